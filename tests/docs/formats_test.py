#!/usr/bin/python3
"""docs/formats.md against the program: every key that is read or written is described, its examples are
valid, and its tables of reasons and rules are those of the program."""

import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from planish_cli import SOURCE, CliTest, main  # noqa: E402

PAGE = (SOURCE / "docs" / "formats.md").read_text(encoding="utf-8")
EXAMPLES = SOURCE / "examples"
# Objects whose keys are ids that the user gives.
BY_ID = {"edges"}
COMMANDS = {
    "unfold": ["bracket.step"],
    "connect": ["connect/a_folded.json", "connect/b_lofted.json"],
    "transition": ["transition/a_square_to_round.json", "transition/h_hexagon_to_round.json"],
    "slit": ["slit/plume.json"],
}


def section(anchor):
    """The page from an anchor to the next heading of the same or a higher level."""
    text = PAGE[PAGE.index(f'<a id="{anchor}"></a>'):]
    level = len(re.search(r"^(#+) ", text, flags=re.M)[1])
    heads = [m.start() for m in re.finditer(rf"^#{{1,{level}}} ", text, flags=re.M)]
    return text[:heads[1]] if len(heads) > 1 else text


def described():
    """What stands on the page as code: words in backticks, and keys of its JSON."""
    words = set()
    for code in re.findall(r"```.*?```|`[^`\n]+`", PAGE, flags=re.S):
        words |= set(re.findall(r"\w+", code))
    return words


def keys_of(value):
    if isinstance(value, list):
        return set().union(*map(keys_of, value)) if value else set()
    if not isinstance(value, dict):
        return set()
    keys = set(value)
    for key, inside in value.items():
        if key not in BY_ID:
            keys |= keys_of(inside)
    return keys


class Formats(CliTest):
    def report(self, command, *arguments):
        self.run_cli(command, *arguments, "--check", "--json", "report.json", "-q")
        return self.json("report.json")

    def test_every_key_of_a_report_is_described(self):
        words = described()
        for command, inputs in COMMANDS.items():
            for name in inputs:
                with self.subTest(name):
                    self.assertEqual(keys_of(self.report(command, EXAMPLES / name)) - words, set())

    def test_every_key_of_info_and_summary_is_described(self):
        words = described()
        self.run_cli("info", EXAMPLES / "bracket.step", "--sheets", "--json", "info.json")
        self.assertEqual(keys_of(self.json("info.json")) - words, set())
        self.run_cli("unfold", EXAMPLES / "bracket.step", "--all", "-o", "flat/")
        self.assertEqual(keys_of(self.json("flat/summary.json")) - words, set())

    def test_every_key_of_the_examples_is_described(self):
        words = described()
        files = sorted(EXAMPLES.glob("*/*.json"))
        self.assertGreater(len(files), 20)
        for path in files:
            with self.subTest(path.name):
                self.assertEqual(keys_of(json.loads(path.read_text(encoding="utf-8"))) - words, set())

    def test_the_examples_of_the_page_are_valid(self):
        for command, anchor in (("connect", "plates"), ("transition", "transition"), ("slit", "slits")):
            with self.subTest(anchor):
                text = re.search(r"```json\n(.*?)```", section(anchor), flags=re.S)[1]
                given = json.loads(text)
                report = self.report(command, self.write(f"{anchor}.json", text))
                self.assertEqual(report["command"], command)
                self.assertEqual(report["units"], given["units"])
                self.assertIsNone(report["reason"])

    def test_the_rules_and_their_defaults_are_those_of_the_program(self):
        rows = re.findall(r"^\| (`[^|]*) \| ([\d., ]+) \| ([^|]+) \|", section("rules"), flags=re.M)
        for column, process in enumerate(("laser", "punch")):
            given = json.loads(self.run_cli("unfold", "--process", process, "--print-rules")[0])
            table = {}
            for keys, *limits in rows:
                limit = limits[0] if limits[column] == "the same" else limits[column]
                table.update(zip(re.findall(r"`(\w+)`", keys), map(float, limit.split(", "))))
            self.assertEqual(table, {key: value for key, value in given.items()
                                     if key not in ("format", "version", "enabled", "strict", "sources")})

    def test_the_reasons_are_those_of_the_program(self):
        """Both ways: codes and exit statuses, on which scripts branch."""
        statuses = {"internal": 1, "usage": 2, "unreadable": 3, "refused": 4}
        headers = SOURCE / "include" / "planish"
        program = {(name, statuses[status])
                   for header in [headers / "base" / "code.hpp", *headers.glob("*/codes.hpp")]
                   for name, status in re.findall(r'ErrorCode \w+\{\s*"(\w+)",\s*ExitStatus::(\w+),',
                                                  header.read_text(encoding="utf-8"))}
        self.assertGreater(len(program), 40)
        page = set()
        for status, codes in re.findall(r"^\| (\d)[^|]* \| (`.*`) \|$", section("reason"), flags=re.M):
            page |= {(code, int(status)) for code in re.findall(r"`(\w+)`", codes)}
        self.assertEqual(page, program)


if __name__ == "__main__":
    main()
