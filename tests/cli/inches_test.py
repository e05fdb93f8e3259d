#!/usr/bin/python3
"""Sentences in inches: the same as in mm, each length divided by 25.4."""

import copy
import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import SOURCE, CliTest, main  # noqa: E402

EXAMPLES = SOURCE / "examples"
SAID = {"message", "change", "sentence", "why"}
LENGTH = re.compile(r"(-?[0-9.]+(?:e-?\d+)?)(?: × (-?[0-9.]+))? (mm|in)(²|³)?(?![a-z])")


def sentences(value, path=""):
    """Every sentence of a report, by its place."""
    found = {}
    if isinstance(value, dict):
        for key, item in value.items():
            if key in SAID and isinstance(item, str):
                found[f"{path}/{key}"] = item
            found.update(sentences(item, f"{path}/{key}"))
    elif isinstance(value, list):
        for i, item in enumerate(value):
            found.update({f"{path}/{i}": item} if isinstance(item, str) and path.endswith("notes")
                         else sentences(item, f"{path}/{i}"))
    return found


def lengths(sentence):
    """Its lengths, areas and volumes, with their powers."""
    return [(float(number), {"": 1, "²": 2, "³": 3}[power or ""], unit)
            for *numbers, unit, power in LENGTH.findall(sentence) for number in numbers if number]


class Inches(CliTest):
    def both(self, maker, part, *options, status=0):
        reports = {}
        for unit in ("mm", "inch"):
            _, err = self.run_cli(maker, part, *options, "--units", unit, "--json", f"{unit}.json",
                                  status=status)
            reports[unit] = self.json(f"{unit}.json")
            self.assertEqual(" mm" in err, unit == "mm" and " mm" in err, err)
        return reports["mm"], reports["inch"]

    def check(self, *arguments, least, **given):
        """At least so many lengths are told, each in both units."""
        metric, imperial = (sentences(report) for report in self.both(*arguments, **given))
        self.assertEqual(metric.keys(), imperial.keys())
        told = 0
        for place, sentence in metric.items():
            said = imperial[place]
            self.assertIsNone(re.search(r"\bmm\b", said), f"{place}: {said}")
            self.assertEqual(LENGTH.sub("#", sentence).count("#"), LENGTH.sub("#", said).count("#"))
            for (mm, power, unit), (inches, same, other) in zip(lengths(sentence), lengths(said)):
                self.assertEqual((unit, other, power), ("mm", "in", same))
                self.assertAlmostEqual(mm / 25.4 ** power, inches, delta=2e-3 * abs(inches), msg=said)
                told += 1
        self.assertGreaterEqual(told, least)

    def test_rules_name_their_worst_place_in_inches(self):
        # Two rules at least: flanges too low, and an inside radius below the thickness.
        self.angle(leg=5.0, radius=1.0)
        self.check("unfold", "part.step", "--check", least=4)

    def test_a_shop_that_has_no_such_radius(self):
        self.angle(radius=9.0)
        self.check("unfold", "part.step", "--check", "--shop", EXAMPLES / "shop" / "example.json",
                   "--material", "mild steel", least=2)

    def test_sheets_of_plates_and_their_refusals(self):
        plates = json.loads((EXAMPLES / "connect" / "f_many_edges.json").read_text())
        self.write("plates.json", json.dumps(plates))
        self.check("connect", "plates.json", "--check", least=0)
        far = copy.deepcopy(plates)
        far["largest_span"] = 0.01
        self.write("far.json", json.dumps(far))
        self.check("connect", "far.json", least=1, status=4)

    def test_a_bend_plan_and_what_is_in_its_way(self):
        self.angle(leg=5.0)
        self.check("bend", "part.step", least=1, status=4)


if __name__ == "__main__":
    main()
