#!/usr/bin/python3
"""`planish manual`: a page for each command, which names every option, in a form that no formatter complains of."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import help_tables
from planish_cli import CLI, CliTest, main

DAY = "1234567890"  # 2009-02-13


class Manual(CliTest):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="planish-man-")
        self.addCleanup(folder.cleanup)
        done = subprocess.run([CLI, "manual", "-o", folder.name], capture_output=True, check=False,
                              env=dict(os.environ, SOURCE_DATE_EPOCH=DAY))
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"", b""))
        self.commands = help_tables.commands(self.run_help())
        self.pages = {path.stem: path for path in pathlib.Path(folder.name).iterdir()}

    def run_help(self, *command):
        return subprocess.run([CLI, *command, "--help"], capture_output=True, text=True, check=True).stdout

    def text(self, page, columns=80):
        """The page as a person sees it, on one line."""
        done = subprocess.run(["man", "--warnings", "--local-file", str(self.pages[page])], capture_output=True,
                              text=True, check=True,
                              env=dict(os.environ, MANWIDTH=str(columns), LC_ALL="C.UTF-8", MANPAGER="cat"))
        self.assertEqual(done.stderr, "")
        return re.sub(r"\x1b\[[0-9;]*m|.\x08", "", done.stdout)

    def test_each_command_has_a_page_and_the_program_names_them_all(self):
        self.assertEqual(set(self.pages), {"planish"} | {f"planish-{name}" for name in self.commands})
        text = self.text("planish")
        for name in self.commands:
            self.assertIn(f"planish-{name}(1)", text)
            self.assertIn("planish(1)", self.text(f"planish-{name}"))
        for status in "01234":
            self.assertRegex(text, rf"\n +{status} +\S")

    def test_every_option_is_named_with_its_value(self):
        for name in self.commands:
            text = self.text(f"planish-{name}", columns=200)
            self.assertRegex(text, rf"planish-{name} - \S")
            options = help_tables.options(self.run_help(name))
            self.assertIn("--help", options)
            for option, value in options.items():
                self.assertRegex(text, rf"\n +(?:-\w, )?{re.escape(option)}(?:, --[\w-]+)?(?: {re.escape(value)})?\s", option)
                if value:
                    self.assertRegex(text, rf"{re.escape(option)}(?:, --[\w-]+)? {re.escape(value)}")
        self.assertIn("--units mm|inch|m", self.text("planish-unfold"))

    def test_examples_and_exit_status_stand_as_in_the_help(self):
        for name in self.commands:
            text = self.text(f"planish-{name}", columns=200)
            for line in self.run_help(name).split("\nExamples:\n")[1].splitlines():
                if line.startswith("  "):
                    self.assertIn(re.sub(r" +", " ", line.strip()), re.sub(r" +", " ", text))

    def test_no_formatter_complains(self):
        self.assertIsNotNone(shutil.which("mandoc"), "tools/install-packages.sh test")
        for path in self.pages.values():
            lint = subprocess.run(["mandoc", "-Tlint", "-Wwarning", str(path)], capture_output=True, text=True, check=False)
            # A page names others, which are not installed beside it here.
            self.assertEqual((lint.returncode, lint.stdout), (0, ""))

    def test_a_page_has_the_day_of_its_build(self):
        for path in self.pages.values():
            self.assertIn(" 1 2009-02-13 ", path.read_text().splitlines()[0])

    def test_one_page_is_printed(self):
        self.assertIn(".TH PLANISH 1 ", self.run_cli("manual")[0])
        self.assertIn(r".TH PLANISH\-SLIT 1 ", self.run_cli("manual", "slit")[0])
        sentence = self.refused("manual", "fold", status=2)
        self.assertIn("there is no command \"fold\"; there are unfold, connect", sentence)
        self.assertIn("cannot", self.refused("manual", "-o", "missing/", status=3))


if __name__ == "__main__":
    if not shutil.which("man"):
        sys.exit("man is missing: tools/install-packages.sh test")
    main()
