#!/usr/bin/python3
"""The schemas: those of the documentation are those of the program, examples and reports keep them, and the parser takes what
they take."""

import copy
import json
import pathlib
import random
import re
import sys

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import step_files  # noqa: E402
from planish_cli import SOURCE, CliTest, main  # noqa: E402

DOCUMENTED = SOURCE / "docs" / "schema"
EXAMPLES = SOURCE / "examples"
INPUTS = {"connect": "plates", "transition": "transition", "slit": "slits"}


class SchemaTest(CliTest):
    def schema(self, name):
        return json.loads(self.run_cli("schema", name)[0])

    def validator(self, name):
        return jsonschema.Draft202012Validator(self.schema(name))

    def assert_keeps(self, validator, document, name):
        self.assertEqual([f"{e.json_path}: {e.message[:200]}" for e in validator.iter_errors(document)][:3], [], name)


class Printed(SchemaTest):
    def test_the_documentation_has_what_the_program_prints(self):
        names = self.run_cli("schema")[0].split()
        self.assertEqual(sorted(names), sorted(p.stem for p in DOCUMENTED.glob("*.json")))
        for name in names:
            self.assertEqual((DOCUMENTED / f"{name}.json").read_text(), self.run_cli("schema", name)[0],
                             f"planish schema {name} > docs/schema/{name}.json")

    def test_each_is_a_schema(self):
        for name in self.run_cli("schema")[0].split():
            jsonschema.Draft202012Validator.check_schema(self.schema(name))

    def test_a_name_that_there_is_not_names_those_that_there_are(self):
        self.assertIn("plates, transition, slits, rules, material, tools, shop, request, report", self.refused("schema", "plate", status=2))


class Inputs(SchemaTest):
    def test_examples_keep_them(self):
        for command, name in INPUTS.items():
            validator = self.validator(name)
            for path in sorted((EXAMPLES / command).glob("*.json")):
                self.assert_keeps(validator, json.loads(path.read_text()), path.name)
        rules = json.loads(self.run_cli("unfold", "--print-rules")[0])
        self.assert_keeps(self.validator("rules"), rules, "rules")
        tools = json.loads((SOURCE / "src" / "shop" / "european_tools.json").read_text())
        self.assert_keeps(self.validator("tools"), tools, "tools")

    def places(self, value, at=()):
        """The paths of all values in a document."""
        yield at
        for key, child in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
            yield from self.places(child, (*at, key))

    def changed(self, document, chance):
        """A document with one value replaced, left out or added."""
        other = copy.deepcopy(document)
        at = chance.choice([p for p in self.places(document) if p])
        parent = other
        for key in at[:-1]:
            parent = parent[key]
        what = chance.randrange(6)
        if what == 0:
            del parent[at[-1]]
        elif what == 1 and isinstance(parent[at[-1]], dict):
            parent[at[-1]]["no_such_key"] = 1
        else:
            parent[at[-1]] = chance.choice([-1, 0, 0.5, 400, "", "auto", "no such word", True, None, [], [1, 2], {}])
        return other

    def test_the_parser_takes_what_they_take(self):
        chance = random.Random(14)
        refused = 0
        for command, name in INPUTS.items():
            validator = self.validator(name)
            document = json.loads(sorted((EXAMPLES / command).glob("*.json"))[0].read_text())
            for _ in range(25):
                other = self.changed(document, chance)
                self.write("part.json", json.dumps(other))
                done = self.run_anyhow(command, "part.json")
                errors = list(validator.iter_errors(other))
                pointers = {"/".join(["part.json", *map(str, e.absolute_path)]) for e in errors}
                if not errors:
                    self.assertNotIn("must be ", done["message"] if done["code"] == "invalid_input" else "", (other, done))
                    continue
                refused += 1
                self.assertEqual(done["code"], "invalid_input", (errors[0].message, done))
                self.assertTrue(any(done["where"].startswith(p) for p in pointers), (pointers, done))
        self.assertGreater(refused, 30)

    def test_limits_of_the_parser_are_in_them(self):
        """What is refused as invalid input, by the schema too."""
        for command, example, pointer, wrong in (
                ("slit", "chair", ["ridges"], 2), ("slit", "chair", ["ridges"], 1001),
                ("slit", "chair", ["leg_curve", "bezier"], [[1, 0]]), ("slit", "chair", ["thickness"], 2e7),
                ("slit", "chair", ["leg_curve", "bezier"], [[360, 0], [360, 2e7]]),
                ("transition", "a_square_to_round", ["press_lines"], {"count": 2001}),
                ("connect", "a_folded", ["bends"], [{"between": ["A", "B"], "edges": {"A": []}}])):
            document = json.loads((EXAMPLES / command / f"{example}.json").read_text())
            parent = document
            for key in pointer[:-1]:
                parent = parent[key]
            parent[pointer[-1]] = wrong
            self.assertFalse(self.validator(INPUTS[command]).is_valid(document), (pointer, wrong))
            self.write("part.json", json.dumps(document))
            done = self.run_anyhow(command, "part.json")
            self.assertEqual(done["code"], "invalid_input")
            self.assertIn("must be ", done["message"])
            self.assertTrue(done["where"].startswith("part.json/" + "/".join(pointer)), done)

    def run_anyhow(self, command, file):
        """The reason in the report, whatever comes of it."""
        import subprocess

        from planish_cli import CLI, SECONDS
        subprocess.run([CLI, command, file, "--check", "--quiet", "--json", "report.json"], cwd=self.dir,
                       capture_output=True, timeout=SECONDS, check=False)
        return self.json("report.json")["reason"] or {"code": "", "where": "", "message": ""}


class Reports(SchemaTest):
    def test_those_of_all_examples_keep_theirs(self):
        validator = self.validator("report")
        parts = [("unfold", EXAMPLES / "bracket.step")]
        parts += [(command, path) for command in INPUTS for path in sorted((EXAMPLES / command).glob("*.json"))]
        for command, path in parts:
            self.run_cli(command, path, "--check", "--quiet", "--json", "report.json")
            self.assert_keeps(validator, self.json("report.json"), path.name)

    def test_those_of_refused_parts_keep_it_too(self):
        validator = self.validator("report")
        self.write("block.step", step_files.block())
        self.refused("unfold", "block.step", "--json", "report.json", status=4)
        self.assert_keeps(validator, self.json("report.json"), "block")
        for command in INPUTS:
            self.refused(command, "none.json", "--json", "report.json", status=3)
            self.assert_keeps(validator, self.json("report.json"), command)

    def test_those_of_several_pieces_keep_it_too(self):
        spec = json.loads((EXAMPLES / "transition" / "a_square_to_round.json").read_text())
        self.write("spec.json", json.dumps({**spec, "pieces": 2}))
        self.run_cli("transition", "spec.json", "--check", "--quiet", "--json", "report.json")
        self.assert_keeps(self.validator("report"), self.json("report.json"), "pieces")

    def test_summary_and_info_keep_theirs(self):
        self.angle()
        self.run_cli("unfold", "part.step", "--all", "-o", "flat/", "--quiet", "--json", "summary.json")
        self.assert_keeps(self.validator("summary"), self.json("summary.json"), "summary")
        self.run_cli("info", "part.step", "--sheets", "--json", "info.json")
        self.assert_keeps(self.validator("info"), self.json("info.json"), "info")


class Tables(SchemaTest):
    def test_the_documentation_has_every_maker_and_artifact(self):
        text = (SOURCE / "docs" / "cli.md").read_text()
        makers, files = self.run_cli("--formats")[0].split("\n\n")
        for line in files.splitlines()[1:]:
            name, suffix, media_type, description = line.split(maxsplit=3)
            self.assertIn(f"| `{name}` | `{suffix}` | {media_type} | {description} |", text)
        for head, writes in zip(makers.splitlines()[1::2], makers.splitlines()[2::2]):
            (row,) = [line for line in text.splitlines() if line.startswith(f"| `{head.split()[0]}` | a ")]
            self.assertEqual([f"`{name}`" for name in writes.split()[1:]], row.split("|")[3].split(), head)

    def test_the_documentation_has_every_option(self):
        text = "".join((SOURCE / "docs" / page).read_text() for page in ("cli.md", "connect.md", "transition.md", "slit.md", "bend.md"))
        for maker in ("unfold", "connect", "transition", "slit", "bend"):
            for option in re.findall(r"^  (?:-\w,)?(--[a-z0-9-]+)", self.run_cli(maker, "--help")[0], re.M):
                if option != "--help":
                    self.assertIn(f"`{option}", text, maker)

    def test_a_format_that_is_not_known_names_those_that_are(self):
        self.angle()
        sentence = self.refused("unfold", "part.step", "--format", "dwg", status=2)
        self.assertIn("must be one of dxf, svg, step, pdf, not \"dwg\"", sentence)

    def test_messages_spell_options_as_the_command_line_does(self):
        self.angle()
        sentence = self.refused("unfold", "part.step", "--k", "0.4", "--k-table", "t.csv", status=2)
        self.assertIn("--k and --k-table each say where K comes from", sentence)
        self.assertNotIn("`", sentence)


if __name__ == "__main__":
    main()
