"""The files that a run writes, and the streams that it prints to."""

import json
import os
import pty
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as xml
import zipfile

from command_test import BALL, PROGRAM, CommandTest

try:
    import numpy
except ImportError:
    numpy = None


class Files(CommandTest):
    def test_state(self):
        self.call("run", self.scene, "--state", "end.csv", "--quiet")
        rows = self.rows("end.csv")
        self.assertEqual(list(rows[0]), "id x y z vx vy vz".split())
        self.assertEqual(float(rows[1]["x"]), 1.5)
        self.assertAlmostEqual(float(rows[0]["z"]), 10 - 9.81 / 2, places=12)
        turning = BALL.replace("mass = 2.0", "mass = 2.0\ninertia = [[1.0, 2.0, 2.5]]\nangular_velocity = [[1.0, 2.0, 3.0]]")
        self.call("run", self.write("turning.toml", turning), "--state", "end.csv", "--quiet")
        self.assertEqual(list(self.rows("end.csv")[0]), "id x y z qw qx qy qz vx vy vz wx wy wz".split())

    def test_series_of_both_kinds_hold_the_same(self):
        self.call("run", self.scene, "--every", "0.25", "--out", "series.csv")
        self.call("run", self.scene, "--every", "0.25", "--out", "series.npz")
        rows = self.rows("series.csv")
        self.assertEqual([float(row["time"]) for row in rows[::2]], [0, 0.25, 0.5, 0.75, 1])
        with zipfile.ZipFile(self.folder / "series.npz") as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.namelist(), ["time.npy", "id.npy", "position.npy", "velocity.npy"])
        if numpy:
            series = numpy.load(self.folder / "series.npz")
            self.assertEqual(series["position"].shape, (5, 2, 3))
            self.assertEqual(series["position"][4, 1, 2], float(rows[9]["z"]))
            self.assertEqual(list(series["id"]), [0, 1])

    def test_outputs_of_the_scene_file(self):
        self.write("ball.toml", BALL + '[[output]]\nat = [0.0, 0.5]\nfile = "half.csv"\n')
        self.call("run", self.scene, "--every", "1", "--out", "ends.csv")
        self.assertEqual(len(self.rows("half.csv")), 4)
        self.assertEqual(len(self.rows("ends.csv")), 4)
        self.write("ball.toml", BALL + '[[output]]\nevery = 0.5\nfile = "half.txt"\n')
        self.refused("run", self.scene, says=[".npz", ".csv"])

    def test_a_figure_over_time(self):
        plain = self.json("run", self.scene)["state_hash"]
        self.assertEqual(self.json("run", self.scene, "--figure", "ball.svg")["state_hash"], plain)
        text = self.call("run", self.scene, "--figure", "ball.svg").stdout
        self.assertTrue(text.endswith("\n  wrote ball.svg\n"), text)
        figure = xml.parse(self.folder / "ball.svg").getroot()
        words = [element.text for element in figure.iter("{http://www.w3.org/2000/svg}text")]
        for title in ("energy [J]", "momentum [kg m/s]", "angular momentum [kg m^2/s]", "time per body-step [ns]", "t [s]",
                      "a ball in free fall"):
            self.assertTrue(any(word.startswith(title) for word in words), title)
        lines = list(figure.iter("{http://www.w3.org/2000/svg}polyline"))
        self.assertEqual(len(lines), 3 + 1 + 2 + 1)
        self.assertEqual({len(line.get("points").split()) for line in lines}, {17})  # one a step
        self.refused("run", self.scene, "--figure", "ball.png", says=["--figure", ".svg"])
        self.refused("run", self.scene, "--figure", "a.svg", "--state", "a.svg", says="twice")

    def test_bad_destinations_are_refused_before_the_run(self):
        self.refused("run", self.scene, "--every", "1", says="--out")
        self.refused("run", self.scene, "--out", "a.csv", says="--every")
        self.refused("run", self.scene, "--every", "0", "--out", "a.csv", says="--every")
        self.refused("run", self.scene, "--every", "1", "--out", "a.txt", says=".npz")
        self.refused("run", self.scene, "--every", "1", "--out", "no/such/a.npz", says="no folder")
        self.refused("run", self.scene, "--state", ".", says="it is a folder")
        self.refused("run", self.scene, "--json=no/such.json", says="no folder")
        self.refused("run", self.scene, "--state", "a.csv", "--every", "1", "--out", "a.csv", says="twice")
        self.assertEqual(os.listdir(self.folder), ["ball.toml"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_full_disk(self):
        for words in (["--state", "/dev/full"], ["--json=/dev/full"]):
            self.assertIn("No space left", self.call("run", self.scene, *words, expect=1).stderr)
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "list"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("standard output", result.stderr)

    def test_nothing_half_written_is_left(self):
        self.call("run", self.scene, "--every", "0.5", "--out", "a.npz", "--state", "b.csv", "--json=c.json")
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.npz", "b.csv", "ball.toml", "c.json"])


class Streams(CommandTest):
    def long_run(self, *words):
        """A run that does not end, once it has opened its files."""
        process = subprocess.Popen([PROGRAM, "run", self.scene, "--set", "run.duration=1e9", "--every", "1e6", "--out",
                                    "series.npz", *words], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        while len(os.listdir(self.folder)) == 1 and process.poll() is None:
            time.sleep(0.01)
        time.sleep(0.5)
        return process

    def test_interrupt_ends_a_run_with_valid_files(self):
        process = self.long_run("--json=report.json")
        process.send_signal(signal.SIGINT)
        text, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("interrupted", text)
        report = json.loads((self.folder / "report.json").read_text())
        self.assertLess(report["time"], 1e9)
        with zipfile.ZipFile(self.folder / "series.npz") as archive:
            self.assertIsNone(archive.testzip())
        self.assertEqual(len(os.listdir(self.folder)), 3)

    def test_a_killed_run_leaves_no_spools(self):
        process = self.long_run()
        process.kill()
        process.communicate()
        left = [name for name in os.listdir(self.folder) if "spool" in name]
        self.assertEqual(left, [])

    def test_a_reader_that_leaves_early(self):
        process = subprocess.Popen([PROGRAM, "describe", "scene"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.close()
        self.assertEqual(process.stderr.read(), b"")
        self.assertEqual(process.wait(timeout=60), 0)
        process.stderr.close()

    def colour_in_a_terminal(self, **environment):
        parent, child = pty.openpty()
        clean = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        subprocess.run([PROGRAM, "list", "shapes"], stdout=child, env={**clean, "TERM": "xterm", **environment})
        os.close(child)
        text = os.read(parent, 100000)
        os.close(parent)
        return b"\x1b[" in text

    def test_colour_only_on_a_terminal_that_wants_it(self):
        self.assertTrue(self.colour_in_a_terminal())
        self.assertFalse(self.colour_in_a_terminal(NO_COLOR="1"))
        self.assertNotIn("\x1b[", self.call("list").stdout)
