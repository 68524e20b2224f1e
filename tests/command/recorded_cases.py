"""`ballpark view FILE`: what runs have written is shown as they were, and what cannot be read is refused."""

import base64
import json
import os
import re
import struct
import zipfile
import zlib

from command_test import CommandTest
from output_cases import SPHERES


def npy(values, shape, kind="<f8", order="False"):
    """An array as NumPy writes it."""
    head = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + struct.pack(
        f"<{len(values)}{'d' if kind == '<f8' else 'f'}", *values)


TWO = {"time": npy([0, 1], "(2,)"), "position": npy(range(12), "(2, 2, 3)")}


class Recorded(CommandTest):
    def setUp(self):
        super().setUp()
        self.spheres = self.write("spheres.toml", SPHERES)

    def page(self, name):
        """Its only header, and its inflated data."""
        text = (self.folder / name).read_text()
        (run,) = json.loads(re.search(r'<script type="application/json" id="runs">(.*?)</script>', text, re.S)[1])
        (data,) = re.findall(r'<script type="text/plain" id="data-0">(.*?)</script>', text, re.S)
        return run, zlib.decompress(base64.b64decode(data))

    def archive(self, name, arrays, compression=zipfile.ZIP_STORED):
        with zipfile.ZipFile(self.folder / name, "w", compression) as archive:
            for array, content in arrays.items():
                archive.writestr(array + ".npy", content)
        return name

    def test_a_file_and_its_scene_make_the_page_of_the_run(self):
        columns = ["--columns", "position,orientation,speed,energy"]
        self.call("view", self.spheres, "--every", "0.125", *columns, "--out", "run.html")
        wanted, wanted_data = self.page("run.html")
        for name in ("a.npz", "a.csv"):
            self.call("run", self.spheres, "--every", "0.125", "--out", name)
            self.call("view", name, "--scene", self.spheres, *columns)
            run, data = self.page("a.html")
            self.assertEqual(run["label"], name)
            for key in ("scenario", "doc", "bodies", "times", "boundaries", "box", "columns"):
                self.assertEqual(run[key], wanted[key], key)
            self.assertEqual([(group["name"], group["radius"]) for group in run["groups"]],
                             [("large", 0.125), ("small", 0.0625)])
            self.assertEqual(run["series"], [])
            positions = 5 * 3 * 6  # the balls that spin without orientation have one where the run is watched
            self.assertEqual(data[:positions], wanted_data[:positions])
            self.assertEqual(len(data), len(wanted_data))

    def test_a_file_alone_shows_what_it_holds(self):
        self.call("run", self.spheres, "--every", "0.125", "--out", "a.npz", "--columns", "position,radius")
        text = self.call("view", "a.npz").stdout
        self.assertIn("a: a.npz", text)
        run, data = self.page("a.html")
        self.assertEqual([column["name"] for column in run["columns"]], ["position"])
        self.assertEqual(run["groups"][0]["radius"], [0.125, 0.125, 0.0625])
        self.assertEqual(run["boundaries"], [])
        self.call("run", self.scene, "--every", "0.25", "--out", "b.csv", "--out-precision", "single")
        result = self.json("view", "b.csv", "--with", "a.npz", "--out", "both.html")
        self.assertEqual([(run["label"], run["bodies"], run["frames"]) for run in result["runs"]],
                         [("b.csv", 2, 5), ("a.npz", 3, 5)])

    def test_copies_of_a_scene(self):
        self.call("run", self.spheres, "--copies", "3", "--every", "0.25", "--out", "a.npz")
        self.call("view", "a.npz", "--scene", self.spheres)
        self.assertEqual([group["count"] for group in self.page("a.html")[0]["groups"]], [6, 3])

    def test_many_bodies_are_thinned(self):
        self.call("run", self.scene, "--copies", "20000", "--perturb", "0.1", "--every", "0.5", "--out", "a.npz")
        whole = self.json("view", "a.npz", "--out", "whole.html")
        self.assertEqual(whole["runs"][0]["stride"], 1)
        result = self.json("view", "a.npz", "--max-size", whole["bytes"] - 200000)
        self.assertGreater(result["runs"][0]["stride"], 1)
        self.assertEqual(result["runs"][0]["bodies"], 40000)

    def test_a_picture_of_the_nearest_frame(self):
        self.call("run", self.scene, "--every", "0.25", "--out", "a.npz")
        self.call("view", self.scene, "--still", "0.5", "--out", "run.svg")
        self.assertIn("a at 0.5 s", self.call("view", "a.npz", "--still", "0.6", "--out", "file.svg").stdout)
        circles = [(self.folder / name).read_text().count("<circle") for name in ("run.svg", "file.svg")]
        self.assertEqual(circles, [2, 2])
        self.refused("view", "a.npz", "--still", "1.5", says=["--still", "1 s"])
        self.assertIn("a at 1 s", self.call("view", "a.npz", "--still", "0.9", "--out", "file.svg").stdout)

    def test_files_of_others(self):
        """As numpy.savez writes them: without ZIP64, in single precision."""
        arrays = {"time": npy([0, 1], "(2,)"), "position": npy(range(12), "(2, 2, 3)", "<f4"),
                  "other": npy([], "(0,)")}
        self.call("view", self.archive("a.npz", arrays))
        run, _ = self.page("a.html")
        self.assertEqual(run["box"], {"min": [0, 1, 2], "max": [9, 10, 11]})

    def test_what_cannot_be_read_is_refused(self):
        self.call("run", self.scene, "--every", "0.25", "--out", "whole.npz")
        whole = (self.folder / "whole.npz").read_bytes()
        (self.folder / "cut.npz").write_bytes(whole[:-200])
        (self.folder / "foreign.npz").write_bytes(b"no archive" * 100)
        for content, says in [
                ({"time": TWO["time"]}, "no array 'position'"),
                ({"position": TWO["position"]}, "no array 'time'"),
                ({**TWO, "position": npy(range(12), "(2, 6)")}, "(frames, bodies, 3)"),
                ({**TWO, "position": npy(range(6), "(1, 2, 3)")}, "expected (2, 2, 3)"),
                ({**TWO, "position": npy(range(11), "(2, 2, 3)")}, "ends too early"),
                ({**TWO, "position": npy(range(12), "(99999999999, 99999999999, 3)")}, "ends too early"),
                ({**TWO, "position": npy([], "(2, 2, 3)", "<i8")}, "ends too early"),
                ({**TWO, "time": npy([1, 0], "(2,)")}, "do not ascend"),
                ({**TWO, "time": npy([], "(0,)")}, "no frame"),
                ({**TWO, "position": npy(range(12), "(2, 2, 3)", order="True")}, "Fortran"),
                ({**TWO, "position": b"no array"}, ".npy")]:
            self.refused("view", self.archive("bad.npz", content), says=["'bad.npz' cannot be shown", says])
        self.refused("view", self.archive("bad.npz", TWO, zipfile.ZIP_DEFLATED), says="compressed")
        for name in ("cut.npz", "foreign.npz"):
            self.refused("view", name, says=f"'{name}' cannot be shown")
        self.refused("view", "missing.npz", says="no such file")
        self.write("a.xyz", "")
        self.refused("view", "a.xyz", says=[".npz and .csv", "OVITO"])
        head = "time,id,x,y,z\n"
        for content, says in [
                ("", "empty"), ("x,y,z\n", "time,id"), (head, "no frame"), ("time,id,vx,vy,vz\n0,0,1,2,3\n", "no positions"),
                (head + "0,0,1,2\n", "line 2: expected 5 numbers"), (head + "0,0,1,2,x\n", "line 2"),
                (head + "0,0,1,2,3\n0,2,1,2,3\n", "line 3: rows are not in the order of id"),
                (head + "0,0,1,2,3\n0,1,1,2,3\n1,0,1,2,3\n", "1 of 2 bodies"),
                (head + "1,0,1,2,3\n0,0,1,2,3\n", "do not ascend")]:
            self.write("bad.csv", content)
            self.refused("view", "bad.csv", says=["'bad.csv' cannot be shown", says])
        self.assertFalse([name for name in os.listdir(self.folder) if name.endswith(".html")])

    def test_options_that_do_not_fit(self):
        self.call("run", self.scene, "--every", "0.25", "--out", "a.npz", "--columns", "position")
        for words, says in [
                (["--threads", "1"], "--threads is of runs"), (["--frames", "3"], "--frames is of runs"),
                (["--set", "run.step=1"], "--scene"), (["--compare", "step=1,2"], "--compare is of runs"),
                (["--columns", "speed"], "velocity was not written"), (["--columns", "energy"], "--scene"),
                (["--columns", "contacts"], "contacts: they were not written"), (["--with", "break"], "another recorded file"),
                (["--scene", self.spheres], "has 2 bodies, the scene 3")]:
            self.refused("view", "a.npz", *words, says=says)
        self.refused("view", self.scene, "--scene", "break", says="recorded")
        self.refused("view", self.scene, "--with", "a.npz", says="two recorded files")
