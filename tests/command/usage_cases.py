"""Command lines that are right and wrong, and what the catalogue says."""

import json

from command_test import BALL, CommandTest


class Usage(CommandTest):
    def test_help_and_version(self):
        self.assertRegex(self.call("--version").stdout, r"^ballpark \d+\.\d+\.\d+\n$")
        self.assertIn("profile", self.call("--help").stdout)
        for command in "list describe run explain check view profile cost order ablate prices stress".split():
            text = self.call(command, "--help").stdout
            self.assertRegex(text, r"Examples?:\n  ballpark " + command)
            self.assertIn("Exit codes", text)
            self.assertLessEqual(max(map(len, text.splitlines())), 80)

    def test_commands_and_options_that_do_not_exist(self):
        self.refused(says="command is missing")
        self.refused("rum", self.scene, says="did you mean 'run'")
        self.refused("strain", self.scene, says="no command 'strain'")
        self.refused("run", self.scene, "--thread", "2", says="did you mean --threads?")
        self.refused("run", self.scene, "--steps", "2", says="unknown option --steps")
        self.refused("run", self.scene, "another", says="one argument too many")
        self.refused("run", says="SCENE is missing")
        self.refused("describe", says="NAME is missing")
        self.refused("run", self.scene, "--threads", says="--threads needs a value")

    def test_numbers_out_of_range(self):
        for option in ("--threads", "--copies"):
            for value in ("0", "-1", "1.5", "nan", "x", "", "99999999999999999999"):
                self.refused("run", self.scene, option, value, says=[option, "whole number"])
        for value in ("nan", "inf", "-0.1", "x"):
            self.refused("run", self.scene, "--perturb", value, says="--perturb")
        self.refused("run", self.scene, "--copies", "1000000000", says="memory")
        self.refused("profile", self.scene, "--steps", "0", says="--steps")
        self.refused("profile", self.scene, "--seconds", "nan", says="--seconds")

    def test_names_that_do_not_exist(self):
        self.refused("run", self.scene, "--precision", "doubel", says="did you mean 'double'")
        self.refused("run", self.scene, "--target", "bass", says="did you mean 'base'")
        self.refused("run", self.scene, "--path", "fuse", says="did you mean 'fused'")
        self.refused("list", "effect", says="did you mean 'effects'")
        self.refused("describe", "gravty", says="did you mean 'gravity'")
        self.refused("run", self.scene, "--set", "run.integrator=rk44", says=["--set", "rk4"])
        self.refused("run", self.scene, "--set", "run.step", says="key=value")
        for target in self.json("list", "targets"):
            if not target["available"]:
                self.refused("run", self.scene, "--target", target["name"], says="this machine")


class Catalogue(CommandTest):
    def test_lists(self):
        everything = self.json("list")
        self.assertEqual(list(everything), "scenarios integrators effects shapes contacts targets stress".split())
        for section, entries in everything.items():
            self.assertEqual(self.json("list", section), entries)
            self.assertEqual(json.loads(self.call("list", "--json", section).stdout), entries)
            for entry in entries:
                self.assertEqual(set(entry) >= {"name", "doc"}, section != "targets")
        self.assertEqual([contact["name"] for contact in everything["contacts"]], ["impulse", "penalty"])
        self.assertEqual([shape["name"] for shape in everything["shapes"]], "sphere plane box tube periodic".split())
        for target in everything["targets"]:
            self.assertEqual(set(target), {"name", "available"})
        self.assertEqual([target["name"] for target in everything["targets"]][0], "base")
        self.assertLessEqual(max(map(len, self.call("list").stdout.splitlines())), 80)

    def test_every_name_can_be_described(self):
        for entries in self.json("list").values():
            for entry in entries:
                text = self.call("describe", entry["name"]).stdout
                self.assertTrue(text.startswith(entry["name"]))
                self.assertEqual(self.json("describe", entry["name"])["name"], entry["name"])

    def test_the_example_of_each_effect_is_a_scene(self):
        for effect in self.json("list", "effects"):
            example = self.json("describe", effect["name"])["example"]
            plain = BALL[:BALL.index("[[effects]]")].replace("mass", "inertia = [[1.0, 1.0, 1.0]]\nradius = 0.5\nmass")
            self.call("check", self.write("example.toml", plain + example))

    def test_the_scene_file_is_described(self):
        self.assertIn("duration", self.call("describe", "scene").stdout)
        self.assertIn("properties", self.json("describe", "scene"))

    def test_scenarios_come_from_a_folder_of_choice(self):
        listed = json.loads(self.call("list", "scenarios", "--json", BALLPARK_SCENARIOS=str(self.folder)).stdout)
        self.assertEqual([entry["name"] for entry in listed], ["ball"])
        self.call("run", "ball", "--quiet", BALLPARK_SCENARIOS=str(self.folder))
        self.call("list", "scenarios", BALLPARK_SCENARIOS=str(self.folder / "none"), expect=2)
