"""Scenes that are checked, explained, run and profiled."""

import json

from command_test import BALL, SCENARIOS, CommandTest


class Scenes(CommandTest):
    def test_shipped_scenarios_are_valid(self):
        names = {path.stem for path in SCENARIOS.glob("*.toml")}
        self.assertEqual({entry["name"] for entry in self.json("list", "scenarios")}, names)
        for name in names:
            self.assertTrue(self.call("check", name).stdout.startswith("ok: "))

    def test_problems_are_located_and_nothing_is_run(self):
        bad = self.write("bad.toml", BALL.replace("mass = 2.0", "mass = -2.0").replace("step =", "setp ="))
        message = self.refused("check", bad, says=["bad.toml:", "mass", "setp", "step"])
        self.assertRegex(message, r"bad\.toml:\d+:\d+: ")
        self.refused("run", bad, "--state", "end.csv", says="nothing was run")
        self.assertFalse((self.folder / "end.csv").exists())
        problems = json.loads(self.call("check", bad, "--json", expect=2).stdout)
        self.assertFalse(problems["ok"])
        self.assertGreaterEqual(len(problems["problems"]), 2)
        self.assertGreater(problems["problems"][0]["line"], 0)

    def test_a_scene_that_is_not_there(self):
        self.refused("run", "no_such.toml", says="no_such.toml")
        self.refused("run", "no_such_scenario", says="no scenario and no file")
        self.refused("check", self.folder, says=str(self.folder))

    def test_an_expectation_of_nothing_is_refused(self):
        odd = self.write("odd.toml", BALL + '[[expect]]\nquantity = "state.7.x"\nmin = 0.0\n')
        self.refused("run", odd, says="state.7.x")
        self.refused("check", odd, says="state.7.x")

    def test_what_is_read_is_never_written(self):
        self.write("rows.csv", "x,y,z\n0,0,1\n")
        scene = self.write("kept.toml", BALL + '[[bodies]]\nname = "more"\nmass = 1.0\nfile = "rows.csv"\n')
        (self.folder / "link.toml").symlink_to("kept.toml")
        kept = {name: (self.folder / name).read_text() for name in ("kept.toml", "rows.csv")}
        for path in ("kept.toml", "./kept.toml", "link.toml", "rows.csv"):
            self.refused("run", scene, "--state", path, says="scene is read from")
            self.refused("run", scene, "--json", path, says="scene is read from")
            self.refused("check", scene, "--json", path, says="scene is read from")
            self.refused("explain", scene, "--json", path, says="scene is read from")
        self.refused("run", scene, "--state", "a.csv", "--json", "./a.csv", says="written twice")
        self.assertEqual(kept, {name: (self.folder / name).read_text() for name in kept})

    def test_what_comes_after_the_end_is_said(self):
        late = self.write("late.toml", BALL + "[[impulse]]\nat = 5.0e9\nid = 0\nJ = [0, 0, 1]\n")
        self.assertIn("does not act", self.call("run", late).stderr)

    def test_explain(self):
        text = self.call("explain", self.scene).stdout
        self.assertIn("fused", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 100)
        explanation = self.json("explain", self.scene)
        self.assertEqual(explanation["path"], "fused")
        self.assertEqual(explanation["groups"][0]["bodies"], 2)
        self.assertNotIn("orientation", [column["name"] for column in explanation["columns"]])
        self.assertEqual(self.json("explain", self.scene, "--path", "staged")["path"], "staged")


class Runs(CommandTest):
    def test_facts(self):
        text = self.call("run", self.scene).stdout
        for word in ("bodies", "simulated time", "steps", "wall time", "body-steps/s", "energy", "momentum drift",
                     "angular momentum drift", "force evaluations", "expectations", "state hash"):
            self.assertIn(word, text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        report = self.json("run", self.scene)
        self.assertEqual((report["bodies"], report["steps"], report["time"]), (2, 16, 1.0))
        self.assertIn(report["state_hash"], text)
        self.assertRegex(report["state_hash"], "^[0-9a-f]{16}$")

    def test_json_to_a_file_leaves_the_text(self):
        result = self.call("run", self.scene, "--json", "report.json")
        self.assertIn("state hash", result.stdout)
        self.assertEqual(json.loads((self.folder / "report.json").read_text())["bodies"], 2)
        self.assertEqual(self.call("run", self.scene, "--quiet", "--json=report.json").stdout, "")
        self.assertEqual(json.loads(self.call("run", "--json", self.scene).stdout)["bodies"], 2)

    def test_bits_depend_on_the_scene_alone(self):
        hashes = {self.json("run", self.scene, "--threads", threads, "--path", path)["state_hash"]
                  for threads in (1, 2, 3) for path in ("fused", "staged")}
        for target in self.json("list", "targets"):
            if target["available"]:
                hashes.add(self.json("run", self.scene, "--target", target["name"])["state_hash"])
        self.assertEqual(len(hashes), 1)
        single = self.json("run", self.scene, "--precision", "single")
        self.assertEqual(single["precision"], "single")
        self.assertNotIn(single["state_hash"], hashes)

    def test_the_ledger_adds_up_and_changes_no_bit(self):
        dragged = self.write("dragged.toml", BALL + '[[effects]]\nkind = "linear_drag"\ncoefficient = 0.5\n')
        alone, booked = self.json("run", dragged), self.json("run", dragged, "--ledger")
        self.assertIsNone(alone["ledger"])
        self.assertEqual(booked["state_hash"], alone["state_hash"])
        ledger = booked["ledger"]
        self.assertEqual((ledger["from"], ledger["to"]), (0.0, booked["time"]))
        kinetic = [sum(ledger["kinetic"][when].values()) for when in ("initial", "final")]
        works = {name: line["work"] for name, line in ledger["lines"].items()}
        self.assertLess(works["linear_drag"], 0)
        self.assertAlmostEqual(sum(works.values()) + ledger["integrator_error"], kinetic[1] - kinetic[0], places=11)
        self.assertLess(abs(ledger["integrator_error"]), 1e-3 * kinetic[1])
        self.assertIsNone(ledger["lines"]["linear_drag"]["potential"])
        text = self.call("run", dragged, "--ledger", "--figure", "work.svg").stdout
        self.assertIn("integrator error", text)
        self.assertIn("linear_drag", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.assertIn("work of linear_drag", (self.folder / "work.svg").read_text())

    def test_expectations_may_name_the_ledger(self):
        wanted = '[[expect]]\nquantity = "ledger.integrator_error"\nmin = -1e-9\nmax = 1e-9\n'
        scene = self.write("booked.toml", BALL + wanted)
        self.assertEqual(self.json("run", scene, "--ledger")["expectations"][0]["met"], True)
        self.refused("run", scene, says="ledger.integrator_error")

    def test_overrides(self):
        report = self.json("run", self.scene, "--set", "run.integrator=euler", "--set", "run.step=0.125",
                           "--set", "bodies.balls.mass=3")
        self.assertEqual((report["integrator"], report["steps"]), ("euler", 8))

    def test_expectations_decide_the_exit_code(self):
        met = '[[expect]]\nquantity = "state.0.z"\nvalue = 5.095\ntolerance = 1e-9\n'
        missed = '[[expect]]\nquantity = "state.1.x"\nmin = 100.0\n'
        self.assertIn("1 met, 0 missed", self.call("run", self.write("met.toml", BALL + met)).stdout)
        result = self.call("run", self.write("missed.toml", BALL + met + missed), expect=1)
        self.assertIn("1 met, 1 missed", result.stdout)
        self.assertIn("MISSED", result.stdout)
        self.call("run", self.folder / "missed.toml", "--quiet", expect=1)

    def test_events(self):
        crossing = '[[event]]\nname = "down"\nquantity = "state.1.z"\nvalue = 9.0\n'
        scene = self.write("events.toml", BALL + crossing)
        when = (2 / 9.81) ** 0.5
        self.assertRegex(self.call("run", scene).stdout, f"event down +once, at {when:.12g}")
        report = self.json("run", scene)
        self.assertEqual(report["events"]["down"]["count"], 1)
        self.assertAlmostEqual(report["events"]["down"]["times"][0], when, delta=1e-14)
        self.assertEqual(report["state_hash"], self.json("run", self.scene)["state_hash"])
        wrong = crossing.replace("state.1.z", "state.1.zz")
        for command in ("run", "check", "cost"):
            self.refused(command, self.write("wrong.toml", BALL + wrong), says=["event[0].quantity", "expected one of x"])

    def test_leaving_the_stability_limit(self):
        stiff = BALL.replace('kind = "gravity"', 'kind = "spring"\nanchor = [0.0, 0.0, 0.0]\nstiffness = 1e6')
        result = self.call("run", self.write("stiff.toml", stiff), expect=3)
        self.assertIn("stability", result.stdout)
        accepted = stiff.replace("[run]", '[run]\naccept = ["stability"]')
        self.assertIn("accepted", self.call("run", self.write("accepted.toml", accepted)).stdout)

    def test_copies(self):
        report = self.json("run", self.scene, "--copies", "3", "--perturb", "1e-3", "--state", "end.csv")
        self.assertEqual(report["bodies"], 6)
        rows = self.rows("end.csv")
        self.assertEqual([row["id"] for row in rows], list("012345"))
        self.assertEqual(len({row["x"] for row in rows[1::2]}), 3)

    def test_no_bodies(self):
        empty = BALL[:BALL.index("[[bodies]]")]
        self.assertEqual(self.json("run", self.write("empty.toml", empty))["bodies"], 0)
        self.call("explain", "empty.toml")
        self.call("run", "empty.toml", "--state", "end.csv", "--every", "0.5", "--out", "series.npz")
        self.assertEqual(self.rows("end.csv"), [])


class Profile(CommandTest):
    def test_passes_and_threads(self):
        figures = self.json("profile", self.scene, "--seconds", "0.2", "--threads", "2")
        self.assertEqual([entry["threads"] for entry in figures["threads"]], [1, 2])
        self.assertEqual(figures["threads"][0]["speed_up"], 1)
        self.assertGreater(figures["streaming_bytes_per_second"], 1e8)
        self.assertGreaterEqual(len(figures["passes"]), 1)
        for each in figures["passes"]:
            self.assertGreater(each["calls"], 0)
            self.assertTrue(0 < each["share"] <= 1)
            self.assertGreater(each["bytes_per_second"], 0)
        text = self.call("profile", self.scene, "--steps", "5", "--threads", "1").stdout
        self.assertIn("Throughput", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
