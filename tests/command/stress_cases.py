"""The hard cases, and scene files of the user's own that are hard cases."""

import json

from command_test import BALL, SCENARIOS, CommandTest

HARD = BALL + """
[stress]
what = "how far the ball falls"
owed = [{}, { name = "no mass", set = ["bodies.balls.mass=0"], refused = "bodies[0].mass" }]
shown = [{ set = ["run.integrator=euler"] }]
[[expect]]
quantity = "state.0.z"
value = 5.095
tolerance = 1e-9
"""


class Stress(CommandTest):
    def test_owed_ways_decide_and_shown_ones_stand_beside_them(self):
        hard = self.write("hard.toml", HARD)
        text = self.call("stress", hard).stdout
        for word in ("how far the ball falls", "held", "(euler, double)", "fails", "5.095 +- 1e-09",
                     "1 case: 2 of 2 owed ways hold, and 0 of 1 that are shown for comparison."):
            self.assertIn(word, text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        report = self.json("stress", hard)
        self.assertTrue(report["holds"])
        rk4, refused, euler = report["cases"][0]["cells"]
        self.assertEqual([rk4["owed"], rk4["held"], refused["held"], euler["owed"], euler["held"]],
                         [True, True, True, False, False])
        self.assertIn("bodies[0].mass", refused["said"])
        # by hand: explicit Euler is g h T / 2 higher
        self.assertAlmostEqual(euler["expectations"][0]["measured"], 5.095 + 9.81 * 0.0625 / 2, places=12)

    def test_an_owed_way_that_fails_is_exit_code_1(self):
        missed = self.write("missed.toml", HARD.replace("5.095", "5.1"))
        result = self.call("stress", missed, expect=1)
        self.assertIn("FAILED", result.stdout)
        self.assertEqual(self.call("stress", missed, "--quiet", expect=1).stdout, "")
        self.call("stress", missed, "--json", "limits.json", expect=1)
        self.assertFalse(json.loads((self.folder / "limits.json").read_text())["holds"])

    def test_what_cannot_be_run_is_refused(self):
        self.refused("stress", "x02_stif_spring", says="did you mean 'x02_stiff_spring'?")
        self.refused("stress", self.scene, says="no hard case, expected a table [stress]")
        wrong = self.write("wrong.toml", HARD.replace("run.integrator=euler", "run.integrator=eular"))
        message = self.refused("stress", wrong, says=["stress.shown[0].set", "did you mean \"euler\"?", "nothing was run"])
        self.assertRegex(message, r"wrong\.toml:\d+:\d+: ")
        hard = self.write("hard.toml", HARD)
        self.refused("stress", hard, "--json", hard, says="scene is read from")

    def test_the_catalogue(self):
        names = {path.stem for path in (SCENARIOS / "stress").glob("*.toml")}
        self.assertEqual({entry["name"] for entry in self.json("list", "stress")}, names)
        self.assertIn("hard case", self.call("describe", "x02_stiff_spring").stdout)
        report = self.json("stress", "x02_stiff_spring", "x16_bad_bodies", "x04_grazing")
        self.assertEqual([case["name"] for case in report["cases"]],
                         ["x02_stiff_spring", "x16_bad_bodies", "x04_grazing"])
        self.assertEqual([case["holds"] for case in report["cases"]], [True, True, None])
        self.assertEqual(report["cases"][2]["waits_for"], "event")
        one = json.loads(self.call("stress", "--json", "corner_hit").stdout)
        self.assertTrue(one["holds"])

    def test_a_hard_case_is_a_scene_like_any_other(self):
        self.assertTrue(self.call("check", "x02_stiff_spring").stdout.startswith("ok: "))
        self.call("run", "x02_stiff_spring", "--quiet")
