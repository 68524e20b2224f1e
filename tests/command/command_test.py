"""What all tests of the program share: a folder of their own, a small scene, and ways to call it."""

import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SCENARIOS = pathlib.Path(sys.argv[2])

BALL = """
name = "ball"
doc = "a ball in free fall"
[run]
duration = 1.0
step = 0.0625
integrator = "rk4"
[[bodies]]
name = "balls"
mass = 2.0
position = [[0.0, 0.0, 10.0], [1.0, 0.0, 10.0]]
velocity = [[0.5, 0.25, 0.0]]
[[effects]]
kind = "gravity"
"""


class CommandTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ballpark-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.scene = self.write("ball.toml", BALL)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def call(self, *words, expect=0, **environment):
        inherited = {key: value for key, value in os.environ.items() if key != "BALLPARK_SCENARIOS"}
        result = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True,
                                env={**inherited, "NO_COLOR": "1", **environment}, timeout=600)
        self.assertEqual(result.returncode, expect, f"{words}\n{result.stdout}\n{result.stderr}")
        return result

    def refused(self, *words, says=(), expect=2):
        """Exit code 2, nothing on standard output, and every word of `says` in the message."""
        result = self.call(*words, expect=expect)
        self.assertEqual(result.stdout, "")
        for word in [says] if isinstance(says, str) else says:
            self.assertIn(word, result.stderr)
        self.assertNotIn("terminate", result.stderr)
        return result.stderr

    def json(self, *words, **options):
        return json.loads(self.call(*words, "--json", **options).stdout)

    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))
