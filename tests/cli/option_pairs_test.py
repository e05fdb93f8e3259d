#!/usr/bin/python3
"""Options that choose the same thing, two at a time, on every command that has both: they work together, or the run
ends with 2 before any work and names both."""

import itertools
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import help_tables  # noqa: E402
from planish_cli import CLI, SECONDS, CliTest, main  # noqa: E402

SHOP = {"format": "planish/shop", "version": 1, "name": "S", "materials": [
    {"name": "steel", "density": 8.0, "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.3}]}]}
MATERIAL = {"format": "planish/material", "version": 1, "name": "steel",
            "tension": {"power_law": {"strength": 500, "exponent": 0.2}}}
PLATES = {"thickness": 2, "defaults": {"inside_radius": 2}, "plates": [
    {"id": "A", "outline": [[0, 0, 0], [100, 0, 0], [100, 50, 0], [0, 50, 0]]},
    {"id": "B", "outline": [[0, 60, 10], [100, 60, 10], [100, 60, 60], [0, 60, 60]]}]}
CONE = {"thickness": 2, "from": {"profile": {"circle": {"radius": 100}}},
        "to": {"profile": {"circle": {"radius": 60}}, "frame": {"origin": [0, 0, 150]}}}
# What chooses the material and its K; what chooses bodies and faces; what makes and what only joins.
FAMILIES = (
    {"--shop": "shop.json", "--materials": "materials.csv", "--material": "dc04.json", "--k": "0.4",
     "--k-table": "k.csv", "--din6935": None, "--density": "7"},
    {"--root": "1", "--up": "other", "--body": "1", "--all": None},
    {"--merge": None, "--shard": "1/2", "--format": "svg", "--k": "0.4", "--tools": "tools.json"},
    {"--no-plan": None, "--check-bending": None, "--tools": "tools.json", "--springback": "1"},
)
INPUTS = {"connect": "plates.json", "transition": "cone.json", "batch": "in", "pack": "in"}


class OptionPairs(CliTest):
    def setUp(self):
        super().setUp()
        (self.dir / "in").mkdir()
        for name in ("part.step", "in/part.step"):
            self.angle(name)
        for name, content in (("shop.json", SHOP), ("dc04.json", MATERIAL), ("plates.json", PLATES), ("cone.json", CONE)):
            self.write(name, json.dumps(content))
        self.write("materials.csv", "part;material;quantity\n*;Steel;3\n")
        self.write("k.csv", "r/t,k\n0.5,0.3\n9,0.3\n")
        self.write("tools.json", self.run_cli("bend", "--print-tools")[0])

    def help(self, *command):
        return subprocess.run([CLI, *command, "--help"], capture_output=True, text=True, check=True).stdout

    def made(self, *arguments, status=0):
        """What is said on standard error of a run in whose folders the program keeps its own files."""
        done = subprocess.run([CLI, *arguments], cwd=self.dir, capture_output=True, text=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done.stderr

    def said(self, command, options, folder):
        words = [word for option, value in options for word in ([option] if value is None else [option, value])]
        several = command in ("batch", "pack") or "--all" in words
        output = ["-o", f"{folder}/"] if several else ["--json", "-"] if command == "bend" else []
        done = subprocess.run([CLI, command, INPUTS.get(command, "part.step"), *words, *output], cwd=self.dir,
                              capture_output=True, text=True, timeout=SECONDS, check=False)
        return done.returncode, done.stderr

    def taken_alone(self, command, option):
        if option[0] == "--merge":
            return True
        status, error = self.said(command, [option], "alone")
        if status:
            self.assertEqual((status, option[0] in error), (2, True), f"{command} {option}: {error}")
        return status == 0

    def test_work_together_or_name_each_other(self):
        commands = help_tables.commands(self.help())
        tried = 0
        for command in commands:
            known = help_tables.options(self.help(command))
            for family in FAMILIES:
                # What is refused by itself is named by itself: a transition has no use for curves.
                both = [one for one in family.items() if one[0] in known]
                alone = [one for one in both if len(both) > 1 and self.taken_alone(command, one)]
                for pair in itertools.combinations(alone, 2):
                    tried += 1
                    with self.subTest(command, pair=pair):
                        status, error = self.said(command, pair, f"out{tried}")
                        if status == 2:
                            for option, _ in pair:
                                self.assertRegex(error, rf"{option}\b")
                            self.assertFalse((self.dir / f"out{tried}").exists(), "before any work")
                        else:
                            self.assertEqual(status, 0, error)
        self.assertGreater(tried, 90, "the help names the options")

    def test_a_second_place_for_k_is_refused(self):
        sources = ["--k", "--k-table", "--din6935", "--material"]
        values = {**FAMILIES[0]}
        for command in ("unfold", "connect", "bend", "batch", "pack"):
            for pair in itertools.combinations(sources, 2):
                for beside in ([], ["--shop"]):
                    options = [(one, values[one]) for one in [*beside, *pair]]
                    with self.subTest(command, options=options):
                        status, error = self.said(command, options, "never")
                        self.assertEqual(status, 2, error)
                        self.assertIn(f"{pair[0]} and {pair[1]} each say where K comes from", error)

    def test_a_merge_makes_nothing(self):
        self.made("batch", "in", "-o", "out", "-q")
        for option in (["--shard", "1/2"], ["--format", "svg"], ["--k", "0.4"], ["--shop", "shop.json"]):
            self.assertIn(option[0], self.made("batch", "--merge", "out", "-o", "all", *option, status=2))

    def test_a_finished_batch_is_made_already(self):
        self.made("batch", "in", "-o", "out", "-q")
        for option in (["--k", "0.4"], ["--shop", "shop.json", "--material", "steel"], ["--units", "inch"]):
            said = self.made("pack", "out", "-o", "shop", *option, status=2)
            self.assertIn(option[0], said)
            self.assertIn("are finished", said)
        self.made("pack", "out", "-o", "shop", "--materials", "materials.csv", "--profile", "inventor", "--density", "7")


if __name__ == "__main__":
    main()
