"""`ballpark cost` and `ballpark order`: what they say, write and refuse. No time is judged."""

import csv
import json
import math

from command_test import CommandTest

SWING = """
name = "swing"
doc = "a mass on a spring"
[run]
duration = 2.0
step = 0.01  # s
integrator = "rk4"
[[bodies]]
name = "mass"
mass = 1.0
position = [[1.0, 0.0, 0.0]]
[[effects]]
kind = "spring"
stiffness = 25.0
anchor = [0.0, 0.0, 0.0]
"""
BALL = """
name = "ball"
[run]
duration = 1.0
step = 0.01
integrator = "velocity_verlet"
[contact]
kind = "impulse"
iterations = 6
[materials.rubber]
restitution = 0.8
[[boundaries]]
shape = "plane"
material = "rubber"
[[bodies]]
name = "ball"
shape = "sphere"
material = "rubber"
radius = 0.1
mass = 1.0
position = [[0.0, 0.0, 1.1]]
[[effects]]
kind = "gravity"
"""
THREE = """
name = "three"
doc = "three stars, softened, that meet again and again"
[run]
duration = 100.0
step = 0.005
integrator = "rk4"
[[bodies]]
name = "stars"
mass = [3.0, 4.0, 5.0]
position = [[1.0, 3.0, 0.0], [-2.0, -1.0, 0.0], [1.0, -1.0, 0.0]]
velocity = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
[[effects]]
kind = "mutual_gravity"
strength = 1.0
softening = 0.3
"""
FEW = ["--integrators", "euler,rk4,dormand_prince5", "--seconds", "4"]
# With fixed settings: a bound that a busy machine does not reach.
AMPLE = ["--seconds", "30"]


def exact(t):
    return math.cos(5 * t)


class Cost(CommandTest):
    def setUp(self):
        super().setUp()
        self.swing = self.write("swing.toml", SWING)

    def test_points_front_and_reference(self):
        result = self.json("cost", self.swing, *FEW)
        self.assertEqual(result["format"], "ballpark-cost-1")
        self.assertEqual(result["reference"]["kind"], "closed form")
        self.assertLess(result["reference"]["error_bar"]["position"], 1e-15)
        self.assertIsNone(result["horizon"])
        self.assertIsNone(result["recommended"])
        self.assertEqual({point["integrator"] for point in result["points"]}, {"euler", "rk4", "dormand_prince5"})
        self.assertEqual({point["precision"] for point in result["points"]}, {"single", "double"})
        front = [point for point in result["points"] if point["pareto"]]
        self.assertTrue(front)
        for point in result["points"]:
            self.assertEqual(set(point["seconds"]), {"min", "median", "max", "runs"})
            self.assertTrue((point["step"] is None) != (point["tolerance"] is None))
            if point["trouble"] is None:
                for better in front:
                    self.assertFalse(better["error"]["value"] > point["error"]["value"]
                                     and better["seconds"]["min"] > point["seconds"]["min"])

    def test_an_error_is_the_distance_from_the_closed_form(self):
        result = self.json("cost", self.swing, "--integrators", "rk4", "--steps", "0.1,0.02", "--precisions", "double",
                           "--seconds", "0.5", "--error", "position.end")
        self.assertEqual([point["step"] for point in result["points"]], [0.1, 0.02])
        for point in result["points"]:
            end = self.json("run", self.swing, "--set", f"run.step={point['step']}", "--state", "end.csv")
            self.assertEqual(end["state_hash"], point["state_hash"])
            self.assertEqual(end["force_evaluations"], point["force_evaluations"])
            error = abs(float(self.rows("end.csv")[0]["x"]) - exact(2.0))
            self.assertAlmostEqual(point["error"]["value"] / error, 1, places=6)

    def test_the_named_setting_keeps_the_tolerance_and_is_written_back(self):
        result = self.json("cost", self.swing, *FEW, "--tolerance", "1e-5", "--write")
        named = result["recommended"]
        self.assertLessEqual(named["error"] * named["margin"], 1e-5)
        self.assertLessEqual(named["confirmed_error"], 1e-5)
        text = (self.folder / "swing.toml").read_text()
        self.assertIn("  # s\n", text)
        kept = [line for line in SWING.splitlines() if "step" not in line and "integrator" not in line]
        self.assertEqual([line for line in kept if line not in text.splitlines()], [])
        run = self.json("run", self.swing, "--state", "end.csv")
        self.assertEqual(run["integrator"], named["integrator"])
        self.assertLessEqual(abs(float(self.rows("end.csv")[0]["x"]) - exact(2.0)), 1e-5)

    def test_what_no_setting_reaches_is_said(self):
        text = self.call("cost", self.swing, "--integrators", "euler", "--seconds", "0.5", "--tolerance", "1e-9",
                         expect=1).stderr
        self.assertIn("no setting that was tried", text)

    def test_a_budget_is_kept(self):
        result = self.json("cost", self.swing, *FEW, "--budget", "20us")
        named = result["recommended"]
        self.assertLessEqual(result["points"][named["point"]]["seconds"]["median"], 20e-6 * 2.0)

    def test_files(self):
        self.call("cost", self.swing, *FEW, "--csv", "points.csv", "--svg", "figure.svg", "--html", "page.html",
                  "--json", "result.json")
        result = json.loads((self.folder / "result.json").read_text())
        with open(self.folder / "points.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(result["points"]))
        self.assertEqual([row["state_hash"] for row in rows], [point["state_hash"] for point in result["points"]])
        self.assertTrue((self.folder / "figure.svg").read_text().startswith("<svg"))
        page = (self.folder / "page.html").read_text()
        self.assertIn("swing", page)
        for outside in ('src="http', 'href="http', "url(http"):
            self.assertNotIn(outside, page)

    def test_events(self):
        passing = self.write("passing.toml", SWING + '[[event]]\nname = "passing"\nquantity = "state.0.x"\n')
        words = ["cost", passing, "--integrators", "euler,rk4", "--steps", "0.002,0.001", "--precisions", "double", *AMPLE]
        result = self.json(*words, "--csv", "points.csv")
        exact_times = [(k + 0.5) * math.pi / 5 for k in range(3)]
        self.assertEqual(result["reference"]["events"]["passing"]["count"], 3)
        for told, time in zip(result["reference"]["events"]["passing"]["times"], exact_times):
            self.assertAlmostEqual(told, time, delta=1e-14)
        self.assertLess(result["reference"]["event_time"], 1e-13)
        point = next(p for p in result["points"] if (p["integrator"], p["step"]) == ("rk4", 0.002))
        run = self.json("run", passing, "--set", f"run.step={point['step']}")
        self.assertEqual(run["state_hash"], point["state_hash"])
        worst = max(abs(a - b) for a, b in zip(run["events"]["passing"]["times"], exact_times))
        self.assertAlmostEqual(point["error"]["event_time"] / worst, 1, places=5)
        self.assertIn("event_time", (self.folder / "points.csv").read_text().splitlines()[0])
        text = self.call(*words).stdout
        self.assertIn("event times [s]", text)
        self.assertIn("3 passing", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)

    def test_text(self):
        text = self.call("cost", self.swing, *FEW).stdout
        for heading in ("Pareto front", "Time to an error [m]", "Price of a step"):
            self.assertIn(heading, text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.assertEqual(self.call("cost", self.swing, *FEW, "--quiet").stdout, "")

    def test_refusals(self):
        for words, says in [
                (["--integrators", "velocity_verlett"], ["--integrators", "did you mean 'velocity_verlet'"]),
                (["--steps", "0.3"], ["--steps", "does not divide run.duration"]),
                (["--steps", "x"], ["--steps", "finite number"]),
                (["--precisions", "doubel"], ["--precisions", "did you mean 'double'"]),
                (["--precision", "double"], ["--precisions"]),
                (["--contacts", "12x1"], ["--contacts", "no contacts"]),
                (["--openings", "0.5"], ["--openings", "fewer than 256 bodies"]),
                (["--error", "positoin"], ["--error", "did you mean 'position'"]),
                (["--error", "position.mean"], ["--error", "maximum"]),
                (["--reference", "closed"], ["--reference", "best"]),
                (["--tolerance", "0"], ["--tolerance", "above 0"]),
                (["--tolerance", "1", "--budget", "1"], ["exclude each other"]),
                (["--budget", "2 weeks"], ["--budget"]),
                (["--write"], ["--write needs --tolerance"]),
                (["--write", "--tolerance", "1", "--precisions", "extended"], ["extended"]),
                (["--copies", "2"], ["--copies", "at least 10"]),
                (["--copies", "10", "--perturb", "0"], ["--perturb", "above 0"]),
                (["--csv", "swing.toml"], ["would lose it"]),
                (["--svg", "nowhere/a.svg"], ["no folder"]),
                (["--write", "--tolerance", "1", "--set", "run.step=0.5"], ["--set"]),
                (["--set", "run.duration=0"], ["duration"])]:
            self.refused("cost", self.swing, *words, says=says)
        self.assertEqual((self.folder / "swing.toml").read_text(), SWING)
        self.refused("cost", "pendulum", "--write", "--tolerance", "1", says="path of a scene file")
        empty = self.write("empty.toml", "[run]\nduration = 1.0\nstep = 0.5\n")
        self.refused("cost", empty, says="no bodies")
        self.refused("order", empty, says="no bodies")
        self.refused("order", self.swing, "--copies", "10", says="one copy")

    def test_contacts_of_both_formulations_are_tried_and_written_back(self):
        ball = self.write("ball.toml", BALL)
        few = ["--integrators", "velocity_verlet", "--steps", "0.001,0.0005", "--precisions", "double", "--seconds", "6"]
        result = self.json("cost", ball, *few)
        self.assertEqual({point["contact"]["kind"] for point in result["points"]}, {"impulse", "penalty"})
        self.assertIn("no step takes away", result["remarks"][0])
        text = self.call("cost", ball, *few, "--contacts", "12x1,penalty:1e6").stdout
        self.assertIn("penalty contacts come as near as", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.call("cost", ball, *few, "--contacts", "penalty:1e6", "--tolerance", "0.1", "--write")
        self.assertIn('[contact]\nkind = "penalty"\nstiffness = 1000000\n[materials', (self.folder / "ball.toml").read_text())
        for words in ("soft", "12", "12x4x2", "penalty:", "penalty:0", "penalty:-1", "impulse:12", "0x1", "12x1,"):
            self.refused("cost", ball, "--contacts", words, says=["--contacts"])
        self.refused("cost", ball, "--contacts", "soft", says=["'soft'", "expected impulse, penalty", "penalty:1e6"])

    def test_paths_that_stay_together_need_no_ensemble(self):
        result = self.json("cost", self.swing, *FEW, "--copies", "10")
        self.assertIsNone(result["ensemble"])
        self.assertIn("paths stay together", result["left_out"][-1])

    def test_beyond_the_horizon_means_are_compared(self):
        three = self.write("three.toml", THREE)
        words = ["cost", three, "--integrators", "rk4,dormand_prince8", "--seconds", "15", "--copies", "11"]
        result = self.json(*words)
        ensemble = result["ensemble"]
        self.assertLess(result["duration"], result["horizon"]["time"])
        self.assertEqual((ensemble["copies"], ensemble["time"], ensemble["perturb"]), (11, 100, 1e-8))
        names = [observable["name"] for observable in ensemble["observables"]]
        self.assertIn("kinetic energy", names)
        self.assertEqual([mean["observable"] for mean in ensemble["reference"]["means"]], names)
        for row in ensemble["settings"]:
            low, high = row["interval95"]
            self.assertTrue(low <= row["mean"] <= high)
            self.assertIn(row["observable"], names)
        text = self.call(*words).stdout
        self.assertIn("Beyond the horizon: ensembles of 11 runs, at t = 100 s", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)

    def test_no_setting_is_tried_twice(self):
        for own in (["run.tolerance=1e-8"], ["run.step=0.1"]):
            words = [word for key in ["run.integrator=dormand_prince5", *own] for word in ("--set", key)]
            points = self.json("cost", self.swing, *words, "--seconds", "3")["points"]
            settings = [(p["integrator"], p["step"], p["tolerance"], p["precision"]) for p in points]
            self.assertEqual(len(settings), len(set(settings)))

    def test_what_does_not_count_is_said(self):
        text = self.call("cost", self.swing, "--integrators", "euler", "--steps", "1,0.5", "--precisions", "double",
                         *AMPLE).stdout
        self.assertIn("No setting that was tried gives an answer", text)
        self.assertIn("2 settings; the first: euler, step 1 s", text)


class Order(CommandTest):
    def test_each_method_shows_its_order(self):
        swing = self.write("swing.toml", SWING)
        result = self.json("order", swing, "--integrators", "euler,velocity_verlet,rk4", "--seconds", "6")
        self.assertEqual([row["order"] for row in result["rows"]], [1, 2, 4])
        for row in result["rows"]:
            self.assertAlmostEqual(row["observed"], row["order"], delta=0.2)
        text = self.call("order", swing, "--integrators", "rk4", "--seconds", "1").stdout
        self.assertIn("its order", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
