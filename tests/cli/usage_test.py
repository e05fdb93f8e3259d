#!/usr/bin/python3
"""Command lines that are wrong, and help: nothing here gets as far as reading a part."""

import json
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import CliTest, main  # noqa: E402


class Help(CliTest):
    def test_the_bare_program_prints_its_help(self):
        out, _ = self.run_cli()
        self.assertIn("unfold", out)
        self.assertIn("info", out)

    def test_help_has_every_option_and_examples(self):
        out, _ = self.run_cli("unfold", "--help")
        for option in ("-o,", "--json", "--k ", "--k-table", "--din6935", "--root", "--up",
                       "--profile", "--r12", "--splines", "--units", "--body", "--all", "--rules",
                       "--no-rules", "--density", "--write-overlapping", "--tangent-lines",
                       "--bend-marks", "--turn-to-blank", "--arc-tolerance", "--quiet"):
            self.assertIn(option, out)
        self.assertIn("Examples:", out)
        self.assertIn("Exit status:", out)
        self.assertIn("Examples:", self.run_cli("info", "--help")[0])
        self.assertIn("Examples:", self.run_cli("--help")[0])

    def test_version(self):
        out, _ = self.run_cli("--version")
        self.assertRegex(out, r"^planish \d+\.\d+\.\d+\n$")

    def test_print_rules_needs_no_input(self):
        out, _ = self.run_cli("unfold", "--print-rules")
        self.write("rules.json", out)
        self.assertEqual(self.json("rules.json")["format"], "planish/rules")

    def test_printed_rules_are_those_of_the_process(self):
        by_process = {}
        for process in ("laser", "punch"):
            rules = json.loads(self.run_cli("unfold", "--process", process, "--print-rules")[0])
            by_process[process] = [rules[key] for key in ("opening_to_edge_t", "opening_to_opening_t", "smallest_opening_t", "relief_width_t")]
            self.assertFalse(rules["strict"])
            self.assertEqual(set(rules["sources"]), set(rules) - {"format", "version", "enabled", "strict", "sources"})
        self.assertEqual(by_process, {"laser": [1, 1, 0.5, 0.5], "punch": [2, 2, 1.2, 1]})
        self.assertEqual(self.run_cli("unfold", "--print-rules")[0], self.run_cli("unfold", "--process", "laser", "--print-rules")[0])


class WrongUsage(CliTest):
    def wrong(self, *arguments):
        self.angle()
        sentence = self.refused(*arguments, status=2)
        self.assertEqual(self.names(), ["part.step"])
        return sentence

    def test_unknown_command_or_option(self):
        self.wrong("fold")
        self.assertIn("--frobnicate", self.wrong("unfold", "part.step", "--frobnicate"))
        self.wrong("unfold", "part.step", "other.step")
        self.wrong("unfold")
        self.wrong("info")

    def test_an_option_of_another_command_says_which_have_it(self):
        for arguments, words in (
                (["unfold", "part.step", "--flat", "x.dxf"],
                 "`unfold` has no option --flat; connect, transition and slit have it"),
                (["unfold", "part.step", "--flat=x.dxf"], "`unfold` has no option --flat; connect"),
                (["connect", "p.json", "--bend-k", "B1=0.4"], "`connect` has no option --bend-k; unfold and bend have it"),
                (["slit", "s.json", "--k", "0.4"], "`slit` has no option --k; unfold, connect, transition, bend, batch and pack have it"),
                (["unfold", "part.step", "--frobnicate"], "`unfold` has no option --frobnicate (see"),
                (["unfold", "--frobnicate"], "`unfold` has no option --frobnicate (see"),
                (["--k", "0.4", "unfold", "part.step"], "`planish` has no option --k; unfold, "),
                (["unfold", "part.step", "other.step"], "`unfold` takes one FILE: leave \"other.step\" out"),
                (["fold", "part.step", "--k", "1"],
                 "there is no command \"fold\"; there are unfold, connect, transition, slit, bend, batch, pack, info, plates, schema, serve, studio, completion and manual")):
            self.assertIn(words, self.wrong(*arguments))

    def test_an_option_takes_one_value(self):
        for option in ("--k", "--json", "--root"):
            self.assertIn(f"{option} is given 2 times: give it once",
                          self.wrong("unfold", "part.step", option, "1", option, "1"))
        self.assertIn("--k needs a value: --k NUMBER", self.wrong("unfold", "part.step", "--k"))

    def test_all_commands_say_alike_what_a_value_must_be(self):
        self.assertIn("--units: must be one of mm, inch, m, not \"cm\"", self.wrong("info", "part.step", "--units", "cm"))
        self.assertIn("--port: must be a whole number from 1 to 65535, not \"x\"", self.wrong("studio", "--port", "x"))
        self.assertIn("--time-limit: must be a whole number from 1 to 86400, not \"0\"",
                      self.wrong("studio", "--time-limit", "0"))
        self.assertRegex(self.run_cli("info", "--help")[0], r"--units mm\|inch\|m +unit")
        self.assertRegex(self.run_cli("studio", "--help")[0], r"--port N +port")
        self.assertRegex(self.run_cli("studio", "--help")[0], r"--time-limit SECONDS +")

    def test_formats_are_named_once_and_none_is_empty(self):
        for text in ("dxf,", ",dxf", "dxf,,svg"):
            self.assertIn(f"--format: must be one of dxf, svg, step, pdf, not \"\", in \"{text}\"",
                          self.wrong("unfold", "part.step", "--format", text))
        for formats in (["dxf,dxf"], ["dxf", "--format", "svg,dxf"]):
            self.assertIn("--format names dxf twice", self.wrong("unfold", "part.step", "--format", *formats))

    def test_what_the_part_does_not_have_names_the_option(self):
        for option, value in (("--bend-k", "B99=0.4"), ("--root", "99"), ("--rip-edges", "99"), ("--up", "99"), ("--body", "99"),
                              ("--body", "door")):
            self.assertIn(option, self.wrong("unfold", "part.step", option, value))

    def test_an_input_of_another_kind_is_told_before_what_would_be_lost(self):
        self.angle()
        sentence = self.refused("connect", "part.step", status=3)
        self.assertIn("the plates file is not JSON: it is a STEP file", sentence)
        before = (self.dir / "part.step").read_bytes()
        for options in (["--json", "part.step"], ["--json", "part.step", "-o", "missing/a.step"]):
            self.refused("connect", "part.step", *options, status=2)
            self.assertEqual((self.dir / "part.step").read_bytes(), before)
        self.write("part.dxf", "0\nEOF\n")
        self.assertIn("[not_step]", self.refused("unfold", "part.dxf", status=3))

    def test_values_out_of_range(self):
        for option, value in (("--k", "1.5"), ("--k", "-0.1"), ("--k", "nan"), ("--k", "0,44"),
                              ("--k", "0.4x"), ("--k", ""), ("--density", "0"),
                              ("--density", "inf"), ("--arc-tolerance", "-1"),
                              ("--arc-tolerance", "0"), ("--tick-length", "0")):
            sentence = self.wrong("unfold", "part.step", option, value)
            self.assertIn(option, sentence)

    def test_every_number_says_what_it_must_be(self):
        """In the same words for all commands, and without a limit that is none."""
        for command in ("unfold", "bend", "batch", "pack", "serve", "plates", "info", "studio"):
            for option in re.findall(r"(--[a-z0-9-]+) (?:N|NUMBER|SECONDS|MIB)(?!\S)", self.run_cli(command, "--help")[0]):
                for value in ("-3", "1e999"):
                    with self.subTest(command=command, option=option, value=value):
                        words = {"serve": ["--stdio"]}.get(command, ["part.step"])
                        said = self.wrong(command, *words, f"{option}={value}")
                        self.assertRegex(said, rf"{option}: must be an? (whole number|number|angle) .*, not \"{value}\"")
                        self.assertNotRegex(said, r"\d{12}|\.\d*0\b")

    def test_words_that_are_none_of_those_allowed(self):
        for option, value in (("--profile", "autocad"), ("--splines", "lines"), ("--units", "cm"),
                              ("--bend-marks", "dots"), ("--root", "biggest"), ("--root", "0"),
                              ("--up", "down"), ("--format", "dwg"), ("--body", "")):
            sentence = self.wrong("unfold", "part.step", option, value)
            self.assertIn(option, sentence)

    def test_options_that_contradict_each_other(self):
        for options in (["--k", "0.4", "--din6935"], ["--k", "0.4", "--k-table", "t.csv"],
                        ["--k-table", "t.csv", "--din6935"], ["--no-rules", "--rules", "r.json"],
                        ["--r12", "--splines", "keep"], ["--tick-length", "3"],
                        ["--all", "--body", "1", "-o", "flat/"], ["--all"],
                        ["--all", "-o", "a.dxf"], ["--all", "-o", "a/", "-o", "b/"],
                        ["--all", "-o", "a/", "--root", "3"], ["--all", "-o", "a/", "--up", "3"],
                        ["--check", "-o", "a.dxf"], ["--check", "--format", "svg"],
                        ["-o", "a.dxf", "--format", "svg"]):
            self.wrong("unfold", "part.step", *options)
        self.wrong("unfold", "-", "--k-table", "-", "-o", "a.dxf")

    def test_outputs_whose_format_is_not_known(self):
        for name in ("a.dwg", "a", "-", ""):
            self.wrong("unfold", "part.step", "-o", name)

    def test_standard_input_needs_a_name_for_the_output(self):
        self.assertIn("-o", self.wrong("unfold", "-"))

    def test_an_output_never_replaces_an_input(self):
        before = self.angle().read_bytes()
        os.symlink("part.step", self.dir / "link.step")
        (self.dir / "sub").mkdir()
        for output in ("part.step", "./part.step", "sub/../part.step", "link.step"):
            self.refused("unfold", "part.step", "-o", output, status=2)
        self.refused("unfold", "part.step", "--json", "part.step", status=2)
        self.refused("info", "part.step", "--json", "part.step", status=2)
        self.assertEqual((self.dir / "part.step").read_bytes(), before)

    def test_two_outputs_under_one_name(self):
        self.wrong("unfold", "part.step", "-o", "a.dxf", "-o", "./a.dxf")


if __name__ == "__main__":
    main()
