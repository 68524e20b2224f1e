"""`ballpark ablate` and `ballpark prices`: what they say and refuse. No time is judged."""

import math

from command_test import CommandTest

HEAD = """
name = "kick"
doc = "a ball kicked with side spin"
[run]
duration = 2.4
step = 0.01
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.11
mass = 0.43
position = [0.0, 0.0, 0.0]
velocity = [20.0, 0.0, 10.0]
angular_velocity = [0.0, 0.0, 60.0]
[[event]]
name = "landing"
quantity = "state.0.z"
crossing = "falling"
[[expect]]
quantity = "state.0.y"
min = 1.0
"""
EFFECTS = {
    "gravity": "",
    "quadratic_drag": "coefficient = 0.005\n",
    "magnus": "coefficient = 0.002\n",
    "rotating_frame": "angular_velocity = [4.5e-5, 0.0, 5.6e-5]\n",
}


def scene(*left_out):
    return HEAD + "".join(f'[[effects]]\nkind = "{kind}"\n{parameters}' for kind, parameters in EFFECTS.items()
                          if kind not in left_out)


class Ablate(CommandTest):
    def setUp(self):
        super().setUp()
        self.kick = self.write("kick.toml", scene())

    def end(self, *left_out):
        self.call("run", self.write("hand.toml", scene(*left_out)), "--state", "end.csv", "--quiet",
                  expect=1 if "magnus" in left_out else 0)
        row = self.rows("end.csv")[0]
        return [float(row[axis]) for axis in "xyz"]

    def test_verdicts_agree_with_runs_by_hand(self):
        result = self.json("ablate", self.kick, "--seconds", "2")
        self.assertEqual(result["format"], "ballpark-ablate-1")
        full = self.end()
        self.assertEqual({loss["effect"] for loss in result["effects"]}, set(EFFECTS))
        for loss in result["effects"]:
            moved = math.dist(self.end(loss["effect"]), full)
            self.assertAlmostEqual(loss["error"]["value"], moved, delta=1e-12)
            self.assertAlmostEqual(loss["error"]["position"]["end"], moved, delta=1e-12)
            self.assertTrue(loss["error"]["claimed"])
            self.assertEqual(loss["verdict"], "keep" if moved > result["tolerance"] else "may go")
            self.assertTrue(loss["sentence"].startswith(loss["effect"] + ": "))
            self.assertEqual(set(loss["time"]["saved"]), {"min", "median"})
        self.assertEqual([loss["effect"] for loss in result["effects"]],
                         ["rotating_frame", "quadratic_drag", "magnus", "gravity"])
        magnus = result["effects"][2]
        self.assertEqual(magnus["bytes_per_body_step"], 48)
        own = {change["quantity"]: change for change in magnus["observables"]}
        self.assertTrue(own["state.0.y"]["missed"])
        self.assertEqual(len(own["place of landing"]["full"]), 3)

    def test_the_landing_is_that_of_run(self):
        result = self.json("ablate", self.kick, "--seconds", "1")
        landing = self.json("run", self.kick)["events"]["landing"]["times"][0]
        for loss in result["effects"]:
            own = {change["quantity"]: change for change in loss["observables"]}
            self.assertEqual(own["landing"]["full"], landing)
            if loss["effect"] == "gravity":
                self.assertIsNone(own["landing"]["without"])

    def test_text_fits_a_page(self):
        text = self.call("ablate", self.kick, "--seconds", "1").stdout
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.assertRegex(text.replace("\n     ", " "), r"magnus: .*misses the expected state.0.y: keep it\.")

    def test_what_is_worth_losing_can_be_said(self):
        result = self.json("ablate", self.kick, "--seconds", "1", "--tolerance", "1e-6")
        self.assertEqual(result["tolerance"], 1e-6)
        self.assertEqual({loss["verdict"] for loss in result["effects"]}, {"keep"})

    def test_other_errors_and_precisions(self):
        result = self.json("ablate", self.kick, "--seconds", "1", "--error", "velocity.maximum", "--precision", "single")
        self.assertEqual(result["unit"], "m/s")
        self.assertGreater(result["own_error"], 1e-7)

    def test_a_scene_without_effects(self):
        self.assertIn("no effects", self.call("ablate", self.write("bare.toml", scene(*EFFECTS)), "--seconds", "1").stdout)

    def test_refusals(self):
        self.refused("ablate", says="SCENE is missing")
        self.refused("ablate", self.kick, "--tolerance", "nan", says="--tolerance")
        self.refused("ablate", self.kick, "--seconds", "0", says="--seconds")
        self.refused("ablate", self.kick, "--error", "place", says="no quantity 'place'")
        self.refused("ablate", self.kick, "--set", "run.duration=0", says="duration")
        self.refused("ablate", self.kick, "--copies", "2", says="at least 10")

    def test_a_scene_that_fails_by_itself(self):
        result = self.call("ablate", self.write("stiff.toml", """
name = "stiff"
[run]
duration = 1.0
step = 0.01
integrator = "euler"
[[bodies]]
name = "ball"
mass = 1.0
position = [1.0, 0.0, 0.0]
[[effects]]
kind = "spring"
stiffness = 100.0
anchor = [0.0, 0.0, 0.0]
"""), "--seconds", "1", expect=3)
        self.assertIn("the scene itself", result.stderr)


class PriceList(CommandTest):
    def test_every_effect_of_the_catalogue(self):
        result = self.json("prices", "--bodies", "300", "--seconds", "0.1")
        self.assertEqual(result["format"], "ballpark-prices-1")
        self.assertEqual([price["effect"] for price in result["alone"]],
                         [effect["name"] for effect in self.json("list", "effects")])
        self.assertEqual(result["left_out"], [])
        self.assertIsNone(result["in_scene"])
        for effect in result["alone"]:
            self.assertEqual([price["precision"] for price in effect["prices"]], ["double", "single"])

    def test_text_fits_a_page(self):
        text = self.call("prices", "--bodies", "5000", "--seconds", "0.2").stdout
        self.assertIn("5,000 bodies", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)

    def test_of_a_scene(self):
        kick = self.write("kick.toml", scene())
        result = self.json("prices", kick, "--bodies", "5000", "--seconds", "0.2", "--precision", "single")
        self.assertEqual({price["effect"] for price in result["in_scene"]}, set(EFFECTS))
        for effect in result["alone"]:
            self.assertEqual([price["bodies"] for price in effect["prices"]], [5000, 4096])
            self.assertEqual({price["precision"] for price in effect["prices"]}, {"single"})
        text = self.call("prices", kick, "--bodies", "5000", "--seconds", "0.2").stdout
        self.assertIn("In kick", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)

    def test_refusals(self):
        self.refused("prices", "--bodies", "1", says="--bodies")
        self.refused("prices", "--bodies", "1000000000", says="memory")
        self.refused("prices", "--set", "run.step=1", says="--set: there is no scene")
        self.refused("prices", "--seconds", "0", says="--seconds")
        self.refused("prices", "--copies", "2", says="one copy")
        self.refused("prices", "nowhere.toml", says="nowhere.toml")
