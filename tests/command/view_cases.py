"""`ballpark view`: pages and pictures, what they hold, and what is refused. How a page plays is tested in a browser."""

import base64
import json
import os
import re
import signal
import struct
import subprocess
import time
import unittest
import zlib

from command_test import BALL, PROGRAM, CommandTest

SPINNING = """
name = "spinning"
[run]
duration = 0.25
step = 0.0625
[contact]
kind = "impulse"
[materials.rough]
restitution = 0.5
friction = 0.5
[[boundaries]]
shape = "plane"
material = "rough"
[[bodies]]
name = "balls"
shape = "sphere"
material = "rough"
radius = 0.5
mass = 2.0
position = [[0.0, 0.0, 0.5], [1.0, 0.0, 0.5], [4.0, 0.0, 2.0]]
angular_velocity = [[0.0, 0.0, 3.0]]
[[effects]]
kind = "gravity"
"""


def second_sums(data, frames, bodies, components):
    """Whole numbers by frame, component and body, from second differences of 16 bits."""
    rows, step, now = [], [0] * (bodies * components), [0] * (bodies * components)
    for f in range(frames):
        for i in range(bodies * components):
            component, body = divmod(i, bodies)
            low = ((f * components + component) * 2) * bodies + body
            step[i] = (step[i] + data[low] + 256 * data[low + bodies]) % 65536
            now[i] = (now[i] + step[i]) % 65536
        rows.append(list(now))
    return rows


class View(CommandTest):
    def page(self, name):
        """Headers and inflated data of its runs."""
        text = (self.folder / name).read_text()
        runs = json.loads(re.search(r'<script type="application/json" id="runs">(.*?)</script>', text, re.S)[1])
        data = [zlib.decompress(base64.b64decode(part))
                for part in re.findall(r'<script type="text/plain" id="data-\d+">(.*?)</script>', text, re.S)]
        self.assertEqual(len(runs), len(data))
        for outside in ('src="http', 'href="http', "url(http"):
            self.assertNotIn(outside, text)
        return runs, data

    def test_a_page_holds_the_motion_of_run(self):
        text = self.call("view", self.scene, "--frames", "5").stdout
        self.assertIn("wrote ball.html", text)
        self.assertIn("position", text)
        self.assertEqual(sorted(os.listdir(self.folder)), ["ball.html", "ball.toml"])
        (run,), (data,) = self.page("ball.html")
        self.call("run", self.scene, "--every", "0.25", "--out", "series.csv")
        rows = self.rows("series.csv")
        self.assertEqual(run["times"], [float(row["time"]) for row in rows[::2]])
        self.assertEqual([column["name"] for column in run["columns"]], ["position", "speed"])
        low, high = run["box"]["min"], run["box"]["max"]
        for f, whole in enumerate(second_sums(data, 5, 2, 3)):
            for i, value in enumerate(whole):
                axis, body = divmod(i, 2)
                wanted = float(rows[2 * f + body]["xyz"[axis]])
                size = high[axis] - low[axis]
                self.assertAlmostEqual(low[axis] + value / 65535 * size, wanted, delta=0.501 * size / 65535 + 1e-6)
        self.assertEqual(run["series"][0]["name"], "energy")
        self.assertIn("1/65535 of the box", run["notes"][0])

    def test_json_tells_bytes_by_column(self):
        result = self.json("view", self.scene, "--columns", "position,energy", "--every", "0.5", "--out", "a.html")
        self.assertEqual(result["bytes"], (self.folder / "a.html").stat().st_size)
        self.assertEqual(list(result["runs"][0]["bytes"]), ["position", "energy"])
        self.assertEqual(result["runs"][0]["frames"], 3)

    def test_at_most_one_frame_a_step(self):
        self.assertEqual(self.json("view", self.scene)["runs"][0]["frames"], 17)
        adaptive = ["--set", "run.integrator=dormand_prince5", "--set", "run.tolerance=1e-6"]
        scene = self.write("free.toml", BALL.replace("step = 0.0625\n", ""))
        self.call("view", scene, *adaptive, "--frames", "11")
        times = self.page("free.html")[0][0]["times"]
        self.assertEqual(times, [k * 0.1 for k in range(11)])

    def test_balls_that_spin_show_it_and_contacts_are_counted(self):
        scene = self.write("spinning.toml", SPINNING)
        self.call("view", scene)
        (run,), (data,) = self.page("spinning.html")
        self.assertEqual([column["name"] for column in run["columns"]], ["position", "orientation", "speed"])
        self.assertTrue(run["groups"][0]["turns"])
        self.assertEqual(run["groups"][0]["radius"], 0.5)
        self.assertEqual([series["name"] for series in run["series"]],
                         ["energy", "kinetic energy", "potential energy", "momentum", "angular momentum",
                          "deepest penetration so far", "contacts", "time per body-step"])
        self.assertEqual(len(data), 5 * 3 * (6 + 6 + 1))
        self.call("view", scene, "--columns", "contacts")
        (run,), (data,) = self.page("spinning.html")
        self.assertEqual(list(data[5 * 3 * 6:][:3]), [2, 2, 0])  # the ground, and each other

    def test_two_runs_in_step(self):
        self.call("view", self.scene, "--compare", "integrator=euler,rk4", "--out", "two.html")
        runs, _ = self.page("two.html")
        self.assertEqual([run["label"] for run in runs], ["integrator = euler", "integrator = rk4"])
        self.assertEqual(runs[0]["times"], runs[1]["times"])
        self.assertNotEqual(runs[0]["box"], runs[1]["box"])
        self.call("view", self.scene, "--compare", "bodies.balls.velocity=[[0,0,1]],[[0,0,2]]", "--out", "two.html")
        self.assertEqual(len(self.page("two.html")[0]), 2)
        other = self.write("other.toml", BALL.replace('"ball"', '"other"').replace("duration = 1.0", "duration = 0.5"))
        self.call("view", self.scene, "--with", other, "--frames", "5", "--out", "two.html")
        runs, _ = self.page("two.html")
        self.assertEqual([run["scenario"] for run in runs], ["ball", "other"])
        self.assertEqual([run["times"] for run in runs], [[0, 0.25, 0.5, 0.75, 1], [0, 0.25, 0.5]])

    def test_what_does_not_fit_is_left_out_and_said(self):
        many = ["--copies", "20000", "--perturb", "0.1"]
        whole = self.json("view", self.scene, *many, "--out", "a.html")
        self.assertEqual(whole["runs"][0]["shown"], 40000)
        limit = whole["bytes"] - 200000
        result = self.call("view", self.scene, *many, "--max-size", limit, "--json", "b.json", "--out", "b.html")
        run = json.loads((self.folder / "b.json").read_text())["runs"][0]
        self.assertGreater(run["stride"], 1)
        self.assertLess(run["shown"], 40000)
        self.assertLessEqual((self.folder / "b.html").stat().st_size, limit)
        self.assertIn("bodies are shown, one in", result.stderr)
        self.assertTrue(any("bodies are shown" in note for note in self.page("b.html")[0][0]["notes"]))

    def test_pictures(self):
        text = self.call("view", self.scene, "--still", "0.5", "--out", "a.png", "--size", "320x200").stdout
        self.assertIn("ball at 0.5 s: 2 bodies", text)
        image = (self.folder / "a.png").read_bytes()
        self.assertEqual(image[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", image[16:24]), (320, 200))
        pictures = {image}
        for more in (["--colour", "group"], ["--from", "0,0,1"], ["--still", "0.25"]):
            self.call("view", self.scene, "--still", "0.5", "--out", "b.png", "--size", "320x200", *more)
            pictures.add((self.folder / "b.png").read_bytes())
        self.assertEqual(len(pictures), 4)
        self.call("view", self.scene, "--still", "1", "--out", "a.svg", "--quiet")
        self.assertEqual((self.folder / "a.svg").read_text().count("<circle"), 2)

    def test_refusals(self):
        one_frame = self.json("view", self.scene, "--frames", "1", "--out", "small.html")["bytes"]
        os.remove(self.folder / "small.html")
        for words, says in [
                (["--out", "a.txt"], ["--out", ".html"]),
                (["--out", "a.png"], ["--still T"]),
                (["--still", "0.5", "--out", "a.html"], [".png or .svg"]),
                (["--still", "2"], ["--still", "beyond the end", "1 s"]),
                (["--still", "0.5", "--frames", "3"], ["--frames", "does not go with --still"]),
                (["--still", "0.5", "--size", "big"], ["--size", "whole number"]),
                (["--still", "0.5", "--colour", "sped"], ["--colour", "did you mean 'speed'"]),
                (["--still", "0.5", "--from", "0,0,0"], ["--from", "x,y,z"]),
                (["--size", "320x200"], ["--still T"]),
                (["--frames", "0"], ["--frames", "whole number from 1"]),
                (["--every", "0"], ["--every"]),
                (["--every", "1e-9"], ["--every", "more than 100,000 frames"]),
                (["--frames", "3", "--every", "1"], ["exclude each other"]),
                (["--columns", "positoin"], ["--columns", "did you mean 'position'"]),
                (["--max-size", "1k"], ["--max-size", "not enough"]),
                (["--max-size", "much"], ["--max-size"]),
                (["--max-size", one_frame], ["--max-size", "one body of each group"]),
                (["--compare", "integrator=euler"], ["--compare", "2 to 8"]),
                (["--compare", "euler,rk4"], ["--compare"]),
                (["--compare", "integrator=euler,rk5"], ["rk5"]),
                (["--compare", "step=0.1,0.2", "--with", "break"], ["exclude each other"]),
                (["--with", "nothing_like_it"], ["nothing_like_it"]),
                (["--out", "no/such/a.html"], ["no folder"])]:
            self.refused("view", self.scene, *words, says=says)
        self.assertEqual(os.listdir(self.folder), ["ball.toml"])
        html = self.write("scene.html", BALL)
        self.refused("view", html, says="would lose it")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_full_disk(self):
        os.symlink("/dev/full", self.folder / "full.html")
        self.assertIn("No space left", self.call("view", self.scene, "--out", "full.html", expect=1).stderr)

    def interrupted(self, *words):
        process = subprocess.Popen([PROGRAM, "view", self.scene, "--set", "run.duration=1e9", *words], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while len(os.listdir(self.folder)) == 1 and process.poll() is None:
            time.sleep(0.01)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)

    def test_interrupt_leaves_a_page_of_the_frames_so_far(self):
        self.interrupted("--every", "1e5")
        (run,), _ = self.page("ball.html")
        self.assertLess(run["times"][-1], 1e9)
        self.assertTrue(any("interrupted at" in note for note in run["notes"]))
        os.remove(self.folder / "ball.html")
        self.interrupted("--still", "9e8")
        self.assertEqual(os.listdir(self.folder), ["ball.toml"])
