"""Series of frames, read back by the programs that they are for: NumPy, ASE, VTK."""

import json
import os
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
try:
    import ase.io
except ImportError:
    ase = None
try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    vtkXMLPolyDataReader = None

SPHERES = """
name = "spheres"
doc = "three spheres in a box that repeats along x and y"
[run]
duration = 0.5
step = 0.015625
integrator = "rk4"
[contact]
kind = "impulse"
[materials.hard]
restitution = 1.0
friction = 0.5
[[boundaries]]
shape = "periodic"
point = [0.5, 0.5, 0.0]
size = [1.0, 2.0, 0.0]
[[bodies]]
name = "large"
shape = "sphere"
material = "hard"
radius = 0.125
mass = 1.0
position = [[0.1, 0.2, 0.3], [0.6, 0.7, 0.8]]
velocity = [[0.5, 0.25, 0.0], [-0.3, 0.1, 0.7]]
angular_velocity = [[1.0, 2.0, 3.0]]
[[bodies]]
name = "small"
shape = "sphere"
material = "hard"
radius = 0.0625
mass = 1.0
orientation = [[0.6, 0.0, 0.8, 0.0]]
position = [[0.3, 0.5, -0.5]]
angular_velocity = [[1.0, 2.0, 3.0]]
"""
COLUMNS = {"position": "x y z", "velocity": "vx vy vz", "orientation": "qw qx qy qz", "angular_velocity": "wx wy wz"}


class Outputs(CommandTest):
    def setUp(self):
        super().setUp()
        self.spheres = self.write("spheres.toml", SPHERES)

    def film(self, name, *words):
        """The state at the end by column; frames of the same run are in the file."""
        self.call("run", self.spheres, "--every", "0.125", "--out", name, "--state", "end.csv", *words)
        rows = self.rows("end.csv")
        return {column: numpy.array([[float(row[cell]) for cell in cells.split()] for row in rows])
                for column, cells in COLUMNS.items()}

    @unittest.skipUnless(numpy, "python3-numpy is missing: no NPZ is read back")
    def test_numpy_reads_npz(self):
        for words, real in (([], numpy.float64), (["--out-precision", "single"], numpy.float32)):
            state = self.film("a.npz", *words)
            series = numpy.load(self.folder / "a.npz")
            self.assertEqual(sorted(series), sorted(["time", "id", *COLUMNS]))
            self.assertEqual(list(series["time"]), [0, 0.125, 0.25, 0.375, 0.5])
            for column, values in state.items():
                self.assertEqual(series[column].dtype, real)
                self.assertEqual(series[column].shape, (5, *values.shape))
                self.assertTrue((series[column][4] == values.astype(real)).all(), column)

    @unittest.skipUnless(ase and numpy, "python3-ase is missing: no XYZ is read back")
    def test_ase_reads_xyz(self):
        for words, real in (([], numpy.float64), (["--out-precision", "single"], numpy.float32)):
            state = self.film("a.xyz", *words)
            frames = ase.io.read(self.folder / "a.xyz", index=":", format="extxyz")
            self.assertEqual([frame.info["Time"] for frame in frames], [0, 0.125, 0.25, 0.375, 0.5])
            last = frames[4]
            self.assertEqual(last.get_chemical_symbols(), ["X"] * 3)
            self.assertEqual(list(last.pbc), [True, True, False])
            self.assertEqual(last.cell.lengths().tolist(), [1, 2, 2])
            self.assertEqual(list(last.arrays["id"]), [0, 1, 2])
            self.assertEqual(list(last.arrays["radius"]), [0.125, 0.125, 0.0625])
            state["orientation"] = state["orientation"][:, [1, 2, 3, 0]]
            for column, name in (("position", "positions"), ("velocity", "velo"), ("orientation", "orientation"),
                                 ("angular_velocity", "angular_velocity")):
                self.assertTrue((last.arrays[name].astype(real) == state[column].astype(real)).all(), column)

    @unittest.skipUnless(vtkXMLPolyDataReader and numpy, "python3-vtk9 is missing: no VTP is read back")
    def test_vtk_reads_vtp(self):
        for words, real in (([], numpy.float32), (["--out-precision", "double"], numpy.float64)):
            state = self.film("a.vtp", *words)
            entries = self.entries("a.pvd")
            self.assertEqual([time for time, _ in entries], [0, 0.125, 0.25, 0.375, 0.5])
            data = self.poly_data(entries[4][1])
            self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfVerts()), (3, 3))
            self.assertEqual([data.GetCell(body).GetPointId(0) for body in range(3)], [0, 1, 2])
            arrays = {data.GetPointData().GetArrayName(i): vtk_to_numpy(data.GetPointData().GetArray(i))
                      for i in range(data.GetPointData().GetNumberOfArrays())}
            self.assertEqual(sorted(arrays), ["angular_velocity", "id", "orientation", "radius", "velocity"])
            arrays["position"] = vtk_to_numpy(data.GetPoints().GetData())
            self.assertEqual(list(arrays["id"]), [0, 1, 2])
            self.assertEqual(list(arrays["radius"]), [0.125, 0.125, 0.0625])
            for column, values in state.items():
                self.assertEqual(arrays[column].dtype, real)
                self.assertTrue((arrays[column] == values.astype(real)).all(), column)
            self.assertEqual(data.GetFieldData().GetArray("TimeValue").GetTuple1(0), 0.5)

    def poly_data(self, name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        self.assertEqual(reader.GetErrorCode(), 0)
        return reader.GetOutput()

    def entries(self, index):
        """(time, file) of an index of VTP files, each of which is there and whole."""
        collection = xml.parse(self.folder / index).getroot().find("Collection")
        for entry in collection:
            frame = (self.folder / entry.get("file")).read_bytes()
            self.assertTrue(frame.startswith(b"<?xml") and frame.endswith(b"</AppendedData>\n</VTKFile>\n"))
        return [(float(entry.get("timestep")), entry.get("file")) for entry in collection]

    def test_columns_and_precision_in_the_scene_file(self):
        output = '[[output]]\nevery = 0.25\nfile = "a.csv"\ncolumns = ["radius", "position"]\nprecision = "single"\n'
        self.call("run", self.write("chosen.toml", SPHERES + output))
        rows = self.rows("a.csv")
        self.assertEqual(list(rows[0]), "time id x y z radius".split())
        self.assertEqual((rows[0]["x"], rows[0]["radius"]), ("0.100000001", "0.125"))
        self.call("run", self.spheres, "--every", "0.25", "--out", "b.csv", "--columns", "position,radius",
                  "--out-precision", "single")
        self.assertEqual((self.folder / "a.csv").read_text(), (self.folder / "b.csv").read_text())
        bad = self.write("bad.toml", SPHERES + output.replace("radius", "force"))
        self.refused("check", bad, says=["output[0].columns", "angular_velocity"])
        drawn = self.write("drawn.toml", SPHERES + output.replace("a.csv", "a.xyz").replace('"position"', '"velocity"'))
        self.refused("check", drawn, says=["output[0].columns", "position"])
        odd = self.write("odd.toml", SPHERES + output.replace("single", "half"))
        self.refused("check", odd, says=["output[0].precision", "single"])

    def test_contacts_and_their_force(self):
        """Of a ball on the floor: one contact, which bears its weight. Another is in flight."""
        for kind, more in (("impulse", ""), ("penalty", "stiffness = 1e5\n")):
            floor = SPHERES[:SPHERES.index("[[boundaries]]")].replace('"impulse"\n', f'"{kind}"\n{more}')
            ball = '[[boundaries]]\nshape = "plane"\nmaterial = "hard"\n[[bodies]]\nname = "balls"\nshape = "sphere"\n' \
                'material = "hard"\nradius = 0.5\nmass = 2.0\nposition = [[0.0, 0.0, 0.5], [3.0, 0.0, 90.0]]\n' \
                '[[effects]]\nkind = "gravity"\n'
            scene = self.write("floor.toml", (floor + ball).replace("restitution = 1.0", "restitution = 0.1"))
            words = ["run", scene, "--set", "run.duration=2", "--set", "run.step=1e-3", "--every", "1"]
            names = "position,contacts,contact_force"
            plain = self.json("run", scene, *words[2:6])["state_hash"]
            self.assertEqual(self.json(*words, "--out", "a.csv", "--columns", names)["state_hash"], plain)
            rows = self.rows("a.csv")
            self.assertEqual(list(rows[0]), "time id x y z contacts fx fy fz".split())
            self.assertEqual([float(row["contacts"]) for row in rows[2:]], [1, 0, 1, 0])
            self.assertAlmostEqual(float(rows[4]["fz"]), 2 * 9.81, places=6)
            self.assertEqual([float(rows[5][cell]) for cell in ("fx", "fy", "fz")], [0, 0, 0])
            self.call(*words, "--out", "a.npz", "--columns", names)
            with zipfile.ZipFile(self.folder / "a.npz") as archive:
                self.assertIn(b"'shape': (3, 2), ", archive.read("contacts.npy"))
                self.assertIn(b"'shape': (3, 2, 3), ", archive.read("contact_force.npy"))
            self.assertEqual(list(self.json("view", "a.npz", "--columns", "contacts")["runs"][0]["bytes"]),
                             ["position", "contacts"])
            self.call(*words, "--out", "a.xyz", "--columns", names)
            self.assertIn("pos:R:3:contacts:R:1:contact_force:R:3", (self.folder / "a.xyz").read_text())
            self.call(*words, "--out", "a.vtp", "--columns", names)
            self.assertIn(b'Name="contact_force" NumberOfComponents="3"', (self.folder / "a_0000.vtp").read_bytes())
        self.refused("run", self.scene, "--every", "0.5", "--out", "a.csv", "--columns", "position,contact_force",
                     says=["no contact_force", "do not touch"])
        output = '[[output]]\nevery = 0.25\nfile = "a.csv"\ncolumns = ["contacts"]\n'
        self.refused("check", self.write("alone.toml", BALL + output), says=["output[0].columns", "do not touch"])

    def test_options_that_do_not_fit(self):
        series = ["run", self.spheres, "--every", "0.25", "--out", "a.vtp"]
        self.refused(*series, "--columns", "positoin", says="did you mean 'position'")
        self.refused(*series, "--columns", "velocity,radius", says=["--columns", "position"])
        self.refused(*series, "--out-precision", "extended", says=["--out-precision", "single"])
        self.refused("run", self.spheres, "--columns", "position", says="--columns needs --out")
        self.refused("run", self.spheres, "--out-precision", "single", says="--out-precision needs --out")
        self.write("twice.toml", SPHERES + '[[output]]\nevery = 0.25\nfile = "a.pvd"\n')
        self.refused("run", "twice.toml", "--every", "0.25", "--out", "a.vtp", says="twice")

    def test_what_output_took_is_told(self):
        words = ["run", self.spheres, "--every", "0.125", "--out", "a.npz"]
        self.assertRegex(self.call(*words).stdout, r"output +5 frames, [\d.]+ kB: .* on another thread")
        self.assertNotIn("frames", self.call("run", self.spheres).stdout)
        output = self.json(*words)["outputs"]
        self.assertEqual(len(output), 1)
        self.assertEqual((output[0]["file"], output[0]["frames"]), ("a.npz", 5))
        self.assertEqual(output[0]["bytes"], (self.folder / "a.npz").stat().st_size)
        for time_of in "writing_seconds writing_cpu_seconds copying_seconds waiting_seconds".split():
            self.assertGreaterEqual(output[0][time_of], 0)
        self.assertGreater(output[0]["writing_seconds"], 0)
        self.assertEqual(self.json("run", self.spheres)["outputs"], [])

    def test_frames_leave_the_bits_of_the_run(self):
        plain = self.json("run", self.spheres)["state_hash"]
        filmed = self.json("run", self.spheres, "--every", "0.01", "--out", "a.xyz")["state_hash"]
        self.assertEqual(plain, filmed)

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_full_disk_is_told_once_and_the_run_goes_on(self):
        (self.folder / "full.csv").symlink_to("/dev/full")
        result = self.call("run", self.scene, "--set", "run.step=1e-5", "--every", "1e-5", "--out", "full.csv", "--state",
                           "end.csv", expect=1)
        self.assertEqual(result.stderr.count("No space left"), 1)
        self.assertIn("state hash", result.stdout)
        self.assertEqual(len(self.rows("end.csv")), 2)


class Interruptions(CommandTest):
    def long_run(self, *names):
        """A run that does not end and has frames in all these files."""
        outputs = "".join(f'[[output]]\nevery = 1e5\nfile = "{name}"\n' for name in names)
        scene = self.write("long.toml", BALL.replace("duration = 1.0", "duration = 1e9") + outputs)
        process = subprocess.Popen([PROGRAM, "run", scene, "--json", "--figure", "a.svg"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        time.sleep(2)
        self.assertIsNone(process.poll())
        return process

    def listed(self):
        return [entry.get("file") for entry in xml.parse(self.folder / "a.pvd").getroot().find("Collection")]

    def test_interrupt_and_termination_leave_valid_files(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.long_run("a.npz", "a.csv", "a.xyz", "a.vtp")
            process.send_signal(number)
            text, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130)
            frames = {output["frames"] for output in json.loads(text)["outputs"]}
            self.assertEqual(len(frames), 1)
            count = frames.pop()
            self.assertGreater(count, 0)
            with zipfile.ZipFile(self.folder / "a.npz") as archive:
                self.assertIsNone(archive.testzip())
            self.assertEqual(len(self.rows("a.csv")), 2 * count)
            self.assertEqual(len((self.folder / "a.xyz").read_text().splitlines()), 4 * count)
            self.assertTrue((self.folder / "a.svg").read_text().endswith("</svg>\n"))
            self.assertEqual(self.listed(), [f"a_{frame:04}.vtp" for frame in range(count)])
            self.assertFalse([name for name in os.listdir(self.folder) if "partial" in name])

    def test_a_killed_run_leaves_a_valid_index(self):
        process = self.long_run("a.vtp", "a.npz")
        process.kill()
        process.communicate()
        self.assertGreater(len(self.listed()), 0)
        for name in self.listed():
            self.assertTrue((self.folder / name).read_bytes().endswith(b"</AppendedData>\n</VTKFile>\n"))
        self.assertFalse((self.folder / "a.npz").exists())
