#!/usr/bin/python3
"""Parts whose flat pattern is known by a formula: makes them, unfolds them and scores the results.
What Planish is known to get wrong stands in known_defects.json, and must still be wrong: whoever
mends it takes it off."""

import csv
import functools
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", HERE.parents[1]))
CLI = os.environ.get("PLANISH_CLI", "planish")
sys.path.insert(0, str(SOURCE / "tools"))
import make_known_parts  # noqa: E402
import score_parts  # noqa: E402
from known_parts import catalogue, sizes  # noqa: E402

TOLERANCE = 2e-4  # mm
OPTIONS = {"k=0.44": [], "k=0.33": ["--k", "0.33"], "k=0.5": ["--k", "0.5"], "din6935": ["--din6935"]}
DRAWN, SEED = 66, 20261122


@functools.cache
def known_parts():
    """The parts and their sizes, made once for all tests."""
    parts = catalogue.fixed()
    return parts, make_known_parts.expected(parts)


class Fixture(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="planish-known-")
        cls.addClassCleanup(folder.cleanup)
        cls.dir = pathlib.Path(folder.name)
        cls.parts, cls.known = known_parts()

    def unfold(self, step, options):
        """The summary of `planish unfold --all`."""
        summary = self.dir / "summary.json"
        done = subprocess.run([CLI, "unfold", "--all", str(step), "-o", str(self.dir / "flat") + "/",
                               "--json", str(summary), "--no-rules", "--quiet", *options],
                              capture_output=True, text=True, timeout=500, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return summary


def defects(*quantities):
    rows = json.loads((HERE / "known_defects.json").read_text(encoding="utf-8"))
    return [row for row in rows if row["quantity"] in quantities]


class Catalogue(Fixture):
    def test_every_solid_is_closed(self):
        for name, part in self.parts.items():
            self.assertEqual(part.solid.open_edges(), [], name)

    def test_the_sizes_in_the_repository_are_those_of_the_formulas(self):
        stored = json.loads((HERE / "known_parts.json").read_text(encoding="utf-8"))
        self.assert_same(stored, self.known, "")

    def assert_same(self, a, b, where):
        self.assertIs(type(a), type(b), where)
        if isinstance(a, float):
            self.assertTrue(math.isclose(a, b, rel_tol=1e-7, abs_tol=1e-6), f"{where}: {a}, {b}")
        elif isinstance(a, dict):
            self.assertEqual(a.keys(), b.keys(), where)
            for key in a:
                self.assert_same(a[key], b[key], f"{where}/{key}")
        elif isinstance(a, list):
            self.assertEqual(len(a), len(b), where)
            for i, (x, y) in enumerate(zip(a, b)):
                self.assert_same(x, y, f"{where}/{i}")
        else:
            self.assertEqual(a, b, where)

    def test_the_same_seed_gives_the_same_parts(self):
        first, again, other = (make_known_parts.expected_text(catalogue.drawn(6, seed))
                               for seed in (1, 1, 2))
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)


class Formulas(unittest.TestCase):
    """Numbers from elsewhere than the formulas themselves."""

    def test_din_6935(self):
        rule = sizes.RULES[3]
        self.assertAlmostEqual(rule.k(2, 2), 0.325)
        self.assertAlmostEqual(rule.k(12, 2), 0.5)
        # Two legs of 50 outside, r = t = 2: 96.16 mm.
        flat = 2 * 46 + sizes.Bend(90, 2, 60).allowance(2, rule)
        self.assertAlmostEqual(flat, 96.1626, places=4)
        self.assertAlmostEqual(100 - sizes.Bend(90, 2, 60).deduction(2, rule), flat)

    def test_ellipse(self):
        self.assertAlmostEqual(sizes.ellipse_length(3, 3), 6 * math.pi, places=12)
        self.assertAlmostEqual(sizes.ellipse_length(2, 1), 9.688448220547676, places=12)
        by_integral = sizes.integral(lambda s: math.hypot(5 * math.sin(s), math.cos(s)), 0, 2 * math.pi)
        self.assertAlmostEqual(sizes.ellipse_length(5, 1), by_integral, places=9)

    def test_smallest_rectangle(self):
        c, s = math.cos(0.3), math.sin(0.3)
        turned = [(c * x - s * y, s * x + c * y) for x, y in ((0, 0), (7, 0), (7, 3), (0, 3), (2, 1))]
        for found, expected in zip(sizes.smallest_rectangle(turned), (7, 3)):
            self.assertAlmostEqual(found, expected, places=12)
        self.assertIsNone(sizes.smallest_rectangle([(0, 0), (4, 0), (0, 3)]))  # 4 × 3 and 5 × 2.4
        _, _, half_disc = sizes.annular_sector(0.0, 10.0, math.pi)
        for found, expected in zip(sizes.smallest_rectangle_of_curve(half_disc), (20, 10)):
            self.assertAlmostEqual(found, expected, places=5)


class Unfolded(Fixture):
    def misses(self, rule):
        chosen = {row["id"]: self.parts[row["id"]] for row in self.known["parts"]
                  if "refused" in row or rule in row["flat"]}
        step = self.dir / "parts.step"
        make_known_parts.write_together(chosen, step)
        results = score_parts.read_results(self.unfold(step, OPTIONS[rule]))
        self.assertEqual(sorted(results), sorted(chosen))
        total = score_parts.score(self.known, results, rule, TOLERANCE, only_given=True)
        self.assertGreater(len(total.entries), 15 * len(chosen))
        return total.misses, results

    def test_every_size_is_right_but_for_the_known_defects(self):
        for rule in OPTIONS:
            with self.subTest(rule=rule):
                misses, results = self.misses(rule)
                known = {(row["part"], row["quantity"]) for row in defects("refusal")
                         if row["part"] in results}
                self.assertEqual({(part, quantity) for quantity, part, *_ in misses}, known, misses)

    def test_refusals_give_the_right_reason_but_for_the_known_defects(self):
        _, results = self.misses("k=0.44")
        wrong = {part["id"] for part in self.known["parts"] if "refused" in part
                 and results[part["id"]]["refused"] not in part["refused"]}
        self.assertEqual(wrong, {row["part"] for row in defects("reason")})

    def test_a_k_that_leaves_a_sharp_inside_nothing_to_unroll_is_refused(self):
        # DIN 6935 gives K = 0 below R/T = 0.05.
        for part, options in (("sharp_angle", ["--k", "0"]), ("sharp_angle_down", ["--din6935"])):
            with self.subTest(part=part, options=options):
                folder = self.dir / "single"
                make_known_parts.write_parts({part: self.parts[part]}, folder)
                done = subprocess.run([CLI, "unfold", str(folder / f"{part}.step"), "--check", *options],
                                      capture_output=True, text=True, timeout=100, check=False)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("bend B1", done.stderr)
                self.assertIn("K-factor", done.stderr)

    def test_parts_drawn_by_chance(self):
        parts = catalogue.drawn(DRAWN, SEED)
        step = self.dir / "drawn.step"
        make_known_parts.write_together(parts, step)
        results = score_parts.read_results(self.unfold(step, []))
        total = score_parts.score(make_known_parts.expected(parts), results, "k=0.44", TOLERANCE)
        self.assertEqual(total.misses, [])
        self.assertGreater(len(total.entries), 15 * DRAWN)


class Scoring(Fixture):
    """Of results by any program, as CSV: right ones, and ones with one thing wrong."""

    def rows(self):
        rows = []
        for part in self.known["parts"]:
            row = {"id": part["id"], "refused": part.get("refused", [""])[0]}
            if "flat" in part:
                flat = part["flat"]["k=0.44"]
                width, height = flat["size"] or ("", "")
                row |= {"area": flat["area"], "perimeter": flat["perimeter"], "width": height,
                        "height": width, "bends": len(flat["bends"]), "openings": flat["openings"]}
            rows.append(row)
        return rows

    def run_score(self, rows, *options):
        table, sizes_file = self.dir / "results.csv", HERE / "known_parts.json"
        with open(table, "w", newline="", encoding="utf-8") as stream:
            names = ["id", "refused", "area", "perimeter", "width", "height", "bends", "openings"]
            writer = csv.DictWriter(stream, names, restval="")
            writer.writeheader()
            writer.writerows(rows)
        done = subprocess.run([sys.executable, str(SOURCE / "tools" / "score_parts.py"),
                               str(sizes_file), str(table), *options],
                              capture_output=True, text=True, timeout=100, check=False)
        return done.returncode, done.stdout, done.stderr

    def change(self, name, **values):
        rows = self.rows()
        next(row for row in rows if row["id"] == name).update(values)
        return self.run_score(rows)

    def test_right_results_pass(self):
        status, out, _ = self.run_score(self.rows())
        self.assertEqual(status, 0, out)
        self.assertIn(f"of {len(self.parts)} parts scored, 0 missed", out)

    def test_whatever_is_wrong_is_found(self):
        box = next(row for row in self.known["parts"] if row["id"] == "box")
        area = box["flat"]["k=0.44"]["area"]
        for name, values, words in (
                ("box", {"area": area * 1.001}, "box: area is"),
                ("box", {"area": "nan"}, "box: area is"),
                ("staircase", {"bends": 5}, "staircase: bends is 5, expected 6"),
                ("ring", {"openings": 0}, "ring: openings is 0, expected 1"),
                ("hem", {"width": 20.02}, "hem: width of blank is"),
                ("elbow_gore", {"perimeter": 1000}, "elbow_gore: perimeter is"),
                ("zed", {"refused": "too hard"}, "zed: refusal is refused: too hard"),
                ("wedge", {"refused": ""}, "wedge: refusal is unfolded, expected refused")):
            with self.subTest(name=name, values=values):
                status, out, _ = self.change(name, **values)
                self.assertEqual(status, 1, out)
                self.assertIn(f"miss: {words}", out)
                self.assertIn("scored, 1 missed", out)

    def test_a_part_left_out_is_a_miss_unless_only_those_given_count(self):
        rows = self.rows()[1:]
        status, out, _ = self.run_score(rows)
        self.assertEqual((status, out.count("miss: ")), (1, 1))
        self.assertEqual(self.run_score(rows, "--only-given")[0], 0)

    def test_another_rule_has_other_sizes(self):
        status, out, _ = self.run_score(self.rows(), "--rule", "k=0.5")
        self.assertEqual(status, 1)
        self.assertNotIn("miss: plate_with_holes", out)
        self.assertIn("miss: angle: area", out)

    def test_tampered_reports_are_found(self):
        make_known_parts.write_parts({"zed": self.parts["zed"]}, self.dir)
        summary = self.unfold(self.dir / "zed.step", [])
        right = json.loads(summary.read_text())

        def misses(change):
            report = json.loads(json.dumps(right))
            change(report["bodies"][0])
            summary.write_text(json.dumps(report))
            results = score_parts.read_results(summary)
            total = score_parts.score(self.known, results, "k=0.44", TOLERANCE, only_given=True)
            return {quantity for quantity, *_ in total.misses}
        self.assertEqual(misses(lambda body: None), set())
        self.assertEqual(misses(lambda body: body["flat"]["bends"].pop()), {"bends"})
        self.assertEqual(misses(lambda body: body.update(units="inch")) & {"area", "thickness"},
                         {"area", "thickness"})

        def bend(key, value):
            return lambda body: body["flat"]["bends"][0].update({key: value})
        self.assertEqual(misses(bend("direction", right["bodies"][0]["flat"]["bends"][1]["direction"])),
                         {"bend direction"})
        self.assertEqual(misses(bend("angle", 89.9)), {"bend angle"})
        self.assertEqual(misses(bend("allowance", 3.0)), {"bend allowance"})

    def test_what_cannot_be_read_is_said(self):
        status, _, err = self.run_score([{"id": "box", "area": "wide"}])
        self.assertEqual(status, 2)
        self.assertIn("line 2", err)
        status, _, err = self.run_score(self.rows(), "--rule", "k=7")
        self.assertEqual(status, 2)
        self.assertIn("no sizes for k=7", err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
