#!/usr/bin/python3
"""Command lines that are wrong, and help: nothing here gets as far as reading a part."""

import os
import pathlib
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
                       "--bend-marks", "--arc-tolerance", "--quiet"):
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

    def test_values_out_of_range(self):
        for option, value in (("--k", "1.5"), ("--k", "-0.1"), ("--k", "nan"), ("--k", "0,44"),
                              ("--k", "0.4x"), ("--k", ""), ("--density", "0"),
                              ("--density", "inf"), ("--arc-tolerance", "-1"),
                              ("--arc-tolerance", "0"), ("--tick-length", "0")):
            sentence = self.wrong("unfold", "part.step", option, value)
            self.assertIn(option, sentence)

    def test_words_that_are_none_of_those_allowed(self):
        for option, value in (("--profile", "autocad"), ("--splines", "lines"), ("--units", "cm"),
                              ("--bend-marks", "dots"), ("--root", "biggest"), ("--root", "0"),
                              ("--up", "down"), ("--format", "pdf"), ("--body", "")):
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
        for name in ("a.pdf", "a", "-", ""):
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
