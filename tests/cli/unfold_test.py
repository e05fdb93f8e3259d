#!/usr/bin/python3
"""Unfolds parts whose flat pattern is known by a formula, through every way in and out."""

import csv
import io
import json
import math
import os
import pathlib
import sys
import unittest

import ezdxf

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import step_files  # noqa: E402
from planish_cli import SOURCE, CliTest, main  # noqa: E402

REPORT_KEYS = {"format", "version", "command", "input", "units", "status", "reason", "sheet", "flat",
               "verification", "checks"}
BEND_KEYS = {"id", "kind", "angle", "inside_radius", "k_factor", "allowance", "deduction",
             "direction", "length", "line"}


def flat_length(k, leg=50.0, t=2.0, r=2.0):
    return 2 * (leg - t - r) + math.pi / 2 * (r + k * t)


class Angle(CliTest):
    """The angle of step_files: 60 deep, legs of 50, t = r = 2."""

    def report(self, *options):
        self.angle()
        self.run_cli("unfold", "part.step", "--json", "report.json", *options)
        return self.json("report.json")

    def test_needs_nothing_but_the_file(self):
        self.angle()
        out, err = self.run_cli("unfold", "part.step")
        self.assertEqual(err, "")
        self.assertEqual(self.names(), ["part.dxf", "part.step"])
        for words in ("sheet 2 mm", "2 flanges", "1 bend", "blank 96.524 × 60.000 mm", "B1",
                      "certificate: volume 1.000000", "wrote part.dxf"):
            self.assertIn(words, out)

    def test_report_has_the_keys_of_the_formats_page(self):
        report = self.report()
        self.assertLessEqual(REPORT_KEYS, report.keys())
        self.assertLessEqual(BEND_KEYS, report["flat"]["bends"][0].keys())
        self.assertEqual(report["status"], "ok")
        self.assertEqual(report["files"], ["part.dxf"])
        self.assertEqual(report["body"], "angle")

    def test_flat_pattern_is_that_of_the_formula(self):
        report = self.report()
        self.assertAlmostEqual(report["sheet"]["thickness"], 2.0, places=9)
        self.assertAlmostEqual(report["flat"]["size"][0], flat_length(0.44), places=6)
        self.assertAlmostEqual(report["flat"]["size"][1], 60.0, places=6)
        self.assertAlmostEqual(report["flat"]["area"], 60 * flat_length(0.44), places=5)
        self.assertAlmostEqual(report["sheet"]["volume"], 2 * 60 * flat_length(0.5), places=4)
        bend = report["flat"]["bends"][0]
        self.assertAlmostEqual(bend["angle"], 90.0, places=6)
        self.assertAlmostEqual(bend["allowance"], math.pi / 2 * 2.88, places=6)
        self.assertAlmostEqual(bend["deduction"], 8 - math.pi / 2 * 2.88, places=6)
        self.assertAlmostEqual(bend["length"], 60.0, places=6)

    def test_certificate_holds(self):
        verification = self.report("--k", "0.3")["verification"]
        self.assertAlmostEqual(verification["volume_ratio"], 1.0, places=6)
        self.assertLess(verification["length_error"], 1e-6)
        self.assertLess(verification["refold_deviation"], 1e-6)

    def test_k_comes_from_where_it_is_said(self):
        self.write("table.csv", "r/t,k\n0.5,0.30\n1.5,0.40\n")
        for options, k in ((["--k", "0.5"], 0.5), (["--din6935"], 0.325),
                           (["--k-table", "table.csv"], 0.35)):
            report = self.report(*options)
            self.assertAlmostEqual(report["sheet"]["k_factor"], k, places=9)
            self.assertAlmostEqual(report["flat"]["size"][0], flat_length(k), places=6)
        # The vector of the standard for R = T = 2 and two legs of 50.
        self.assertAlmostEqual(self.report("--din6935")["flat"]["size"][0], 96.1626, places=4)

    def test_units_change_the_report_and_the_dxf(self):
        report = self.report("--units", "inch")
        self.assertEqual(report["units"], "inch")
        self.assertAlmostEqual(report["flat"]["size"][1], 60 / 25.4, places=7)
        lines = (self.dir / "part.dxf").read_text().split("\n")
        at = [line.strip() for line in lines].index("$INSUNITS")
        self.assertEqual(lines[at + 2].strip(), "1")

    def test_turning_it_over_turns_the_bend(self):
        up = {self.report("--up", side)["flat"]["bends"][0]["direction"]
              for side in ("reference", "other")}
        self.assertEqual(up, {"up", "down"})
        self.assertEqual(self.report()["flat"]["bends"][0]["direction"], "up")

    def test_root_and_up_take_the_faces_that_info_lists(self):
        self.angle()
        self.run_cli("info", "part.step", "--sheets", "--json", "info.json")
        faces = self.json("info.json")["bodies"][0]["sheet"]["flange_faces"]
        self.assertEqual(len(faces), 2)
        for face in faces:
            self.run_cli("unfold", "part.step", "--root", face["number"], "--up", face["number"])

    def test_mass_by_density(self):
        report = self.report("--density", "7.85")
        self.assertAlmostEqual(report["sheet"]["mass"], 7.85e-6 * 2 * 60 * flat_length(0.5), places=8)

    def test_same_input_gives_the_same_bytes(self):
        self.report()
        before = {name: (self.dir / name).read_bytes() for name in ("part.dxf", "report.json")}
        self.report()
        self.assertEqual(before, {name: (self.dir / name).read_bytes() for name in before})

    def test_rules_can_be_edited_and_left_out(self):
        self.write("rules.json", '{"flange_height_t": 100}')
        strict = self.report("--rules", "rules.json")
        self.assertEqual(strict["status"], "warning")
        self.assertIn("warning", {check["severity"] for check in strict["checks"]})
        self.assertEqual(self.report("--no-rules")["checks"], [])

    def test_k_from_the_curves_of_a_material(self):
        plastic = lambda stress: {"points": [[0, stress], [3, stress]]}  # noqa: E731
        self.write("m.json", json.dumps({"name": "S355", "tension": plastic(200), "compression": plastic(300)}))
        report = self.report("--material", "m.json")
        self.assertAlmostEqual(report["flat"]["bends"][0]["k_factor"], 0.4, places=12)
        self.assertEqual(report["sheet"]["k_source"], "material S355")
        self.write("wrong.json", json.dumps({"tension": {"points": [[0.2, 300], [0.1, 300]]}}))
        sentence = self.refused("unfold", "part.step", "--material", "wrong.json", status=3)
        self.assertIn("/tension/points/1 has a smaller strain than the point before it", sentence)

    def test_a_rule_gives_one_finding_with_all_its_places(self):
        self.write("rules.json", '{"flange_height_t": 100}')
        (finding,) = self.report("--rules", "rules.json")["checks"]
        self.assertEqual(finding["code"], "flange_height")
        self.assertEqual(finding["count"], len(finding["places"]))
        self.assertGreaterEqual(finding["count"], 2)
        self.assertIn(finding["places"][0]["message"], finding["message"])
        self.assertTrue(finding["message"].startswith(f"{finding['count']} flanges are too low to be bent; the worst: "))
        self.assertEqual(finding["at"], [point for place in finding["places"] for point in place["points"]])


class Outputs(CliTest):
    def test_several_files_of_one_pattern(self):
        self.angle()
        self.run_cli("unfold", "part.step", "-o", "a.dxf", "-o", "b.SVG", "-o", "c.stp")
        self.assertEqual(self.names(), ["a.dxf", "b.SVG", "c.stp", "part.step"])
        self.assertIn("<svg", (self.dir / "b.SVG").read_text())
        self.assertTrue((self.dir / "c.stp").read_text().startswith("ISO-10303-21;"))

    def test_flat_solid_is_a_sheet_without_bends(self):
        self.angle()
        self.run_cli("unfold", "part.step", "-o", "flat.step")
        self.run_cli("unfold", "flat.step", "--json", "again.json", "-o", "again.dxf")
        again = self.json("again.json")
        self.assertEqual(again["sheet"]["bends"], 0)
        self.assertAlmostEqual(again["flat"]["size"][0], flat_length(0.44), places=5)

    def test_folder_old_and_new(self):
        self.angle()
        (self.dir / "old").mkdir()
        self.run_cli("unfold", "part.step", "-o", "old")
        self.run_cli("unfold", "part.step", "-o", "new/", "--format", "dxf,svg,step")
        self.assertEqual(self.names(), ["new/part.dxf", "new/part.svg", "new/part_flat.step",
                                        "old/part.dxf", "part.step"])

    def test_formats_beside_the_input(self):
        self.angle()
        self.run_cli("unfold", "part.step", "--format", "svg", "--format", "step")
        self.assertEqual(self.names(), ["part.step", "part.svg", "part_flat.step"])

    def test_check_writes_no_pattern(self):
        self.angle()
        self.run_cli("unfold", "part.step", "--check", "--json", "r.json")
        self.assertEqual(self.names(), ["part.step", "r.json"])
        self.assertEqual(self.json("r.json")["files"], [])

    def test_quiet_says_nothing(self):
        self.angle()
        self.assertEqual(self.run_cli("unfold", "part.step", "-q"), ("", ""))

    def test_json_on_standard_output_leaves_the_summary_to_standard_error(self):
        self.angle()
        out, err = self.run_cli("unfold", "part.step", "--json", "-")
        self.assertEqual(json.loads(out)["status"], "ok")
        self.assertIn("certificate", err)

    def test_standard_input(self):
        out, _ = self.run_cli("unfold", "-", "-o", "a.dxf", "-o", "flat/", "--json", "r.json",
                              stdin=step_files.angle().encode())
        self.assertEqual(self.names(), ["a.dxf", "flat/stdin.dxf", "r.json"])
        self.assertIn("standard input", out)
        self.assertEqual(self.json("r.json")["input"], "-")
        out, _ = self.run_cli("unfold", "-", "--check", stdin=step_files.angle().encode())
        self.assertIn("certificate", out)

    def test_dxf_options_reach_the_file(self):
        self.angle()
        for options, wanted in ((["--r12"], "AC1009"), ([], "AC1015"),
                                (["--profile", "onshape"], "SHEETMETAL_CUT_LINES"),
                                (["--profile", "inventor"], "IV_OUTER_PROFILE"),
                                (["--profile", "solidedge"], "OUTER_LOOP"),
                                (["--tangent-lines"], "BEND_TANGENT"),
                                (["--bend-marks", "ticks", "--tick-length", "3"], "BEND_"),
                                (["--splines", "keep", "--arc-tolerance", "0.1"], "OUTER_PROFILE")):
            self.run_cli("unfold", "part.step", *options)
            self.assertIn(wanted, (self.dir / "part.dxf").read_text())

    def test_a_dxf_turned_to_its_blank_fills_it(self):
        self.angle()
        self.run_cli("unfold", "part.step", "--turn-to-blank", "--json", "report.json")
        size = self.json("report.json")["flat"]["size"]
        (outer,) = ezdxf.readfile(self.dir / "part.dxf").modelspace().query("LWPOLYLINE")
        for axis in (0, 1):
            along = [point[axis] for point in outer.get_points("xy")]
            self.assertAlmostEqual(min(along), 0.0, places=9)
            self.assertAlmostEqual(max(along), size[axis], places=4)

    def test_refusal_leaves_an_older_pattern_alone(self):
        self.write("block.step", step_files.block())
        self.write("block.dxf", "older")
        self.refused("unfold", "block.step", status=4)
        self.assertEqual((self.dir / "block.dxf").read_text(), "older")


class Reliefs(CliTest):
    """A tab of 2 mm with R 2 between slits of 0.01 mm, where the rules ask for half the thickness."""

    ZONE, DEEPER = math.pi / 2 * (2 + 0.44 * 2), 0.2

    def cut(self, shape):
        self.write("lanced.step", step_files.lanced())
        self.run_cli("unfold", "lanced.step", "--bend-relief", shape, "--profile", "default", "--json", "report.json")
        return self.json("report.json"), ezdxf.readfile(self.dir / "lanced.dxf").modelspace()

    @staticmethod
    def area(outline):
        """Of a closed polyline with arcs: the polygon of their chords, and the segments beyond."""
        points = list(outline.get_points("xyb"))
        sum_ = 0.0
        for (x, y, bulge), (u, v, _) in zip(points, points[1:] + points[:1]):
            angle, chord = 4 * math.atan(bulge), math.hypot(u - x, v - y)
            sum_ += (x * v - u * y) / 2
            if bulge:
                sum_ += (chord / 2 / math.sin(angle / 2)) ** 2 * (angle - math.sin(angle)) / 2
        return abs(sum_)

    def test_they_are_as_wide_as_the_rules_ask_for(self):
        drawn, _ = self.cut("none")
        self.assertEqual([(f["code"], len(f["places"])) for f in drawn["checks"]], [("bend_relief", 2)])
        # Each 1 mm wide over the zone and beyond at both ends; the slits are cut anyway. Round ones end in half
        # circles of 1 mm, but for the corner where the slit enters.
        square = 0.99 * (self.ZONE + self.DEEPER) + 1.0 * self.DEEPER
        for shape, gone in (("square", square), ("round", square + math.pi / 8 + math.pi / 16 + 0.5 * 0.49)):
            with self.subTest(shape):
                report, drawing = self.cut(shape)
                self.assertEqual([f["code"] for f in report["checks"]], ["bend_relief_cut"])
                self.assertAlmostEqual(report["flat"]["area"], drawn["flat"]["area"] - 2 * gone, delta=1e-3)
                (outline,) = drawing.query("LWPOLYLINE")
                self.assertAlmostEqual(self.area(outline), report["flat"]["area"], delta=1e-3)
                self.assertEqual(report["verification"]["openings"], drawn["verification"]["openings"])


class SeveralBodies(CliTest):
    def setUp(self):
        super().setUp()
        self.write("cabinet.step", step_files.two_angles_and_a_block())

    def test_without_a_choice_the_bodies_are_listed(self):
        sentence = self.refused("unfold", "cabinet.step", status=2)
        for words in ("--body", "--all", "\"angle\"", "\"block\""):
            self.assertIn(words, sentence)

    def test_one_by_number_or_name(self):
        self.run_cli("unfold", "cabinet.step", "--body", "1", "--json", "a.json")
        self.run_cli("unfold", "cabinet.step", "--body", "angle", "--json", "b.json")
        self.assertEqual(self.json("a.json"), self.json("b.json"))
        self.assertEqual(self.json("a.json")["quantity"], 2)

    def test_all_into_a_folder(self):
        out, _ = self.run_cli("unfold", "cabinet.step", "--all", "-o", "flat/", "--json", "s.json")
        self.assertEqual(self.names(), ["cabinet.step", "flat/angle_t2.dxf", "flat/door_left_t1.5.dxf",
                                        "flat/summary.csv", "flat/summary.json", "s.json"])
        summary = self.json("s.json")
        self.assertEqual(summary, self.json("flat/summary.json"))
        self.assertEqual([body["quantity"] for body in summary["bodies"]], [2, 1, 1])
        self.assertEqual([body["status"] for body in summary["bodies"]], ["ok", "ok", "refused"])
        self.assertEqual(summary["bodies"][2]["reason"]["code"], "not_a_sheet")
        self.assertIn("2 of 3 different bodies", out)

    def test_long_names_leave_the_table_narrow(self):
        name = "a" * 3000 + "2"
        self.write("cabinet.step", step_files.two_angles_and_a_block().replace("angle copy", name).replace("'angle'", f"'{name}'"))
        for arguments in (("unfold", "cabinet.step", "--all", "-o", "flat/"), ("info", "cabinet.step", "--sheets")):
            out, _ = self.run_cli(*arguments)
            self.assertIn("a…aaaaaaaaaaaaaa2 ", out)
            self.assertLess(max(map(len, out.splitlines())), 400)
        self.assertEqual(self.json("flat/summary.json")["bodies"][0]["body"], name)

    def test_all_as_csv(self):
        self.run_cli("unfold", "cabinet.step", "--all", "-o", "flat/")
        rows = list(csv.DictReader(io.StringIO((self.dir / "flat/summary.csv").read_text())))
        self.assertEqual([row["body"] for row in rows], ["angle", "door, \"left\"", "block"])
        self.assertEqual([row["reason"] for row in rows], ["", "", "not_a_sheet"])
        self.assertEqual(rows[0]["files"], "flat/angle_t2.dxf")
        self.assertAlmostEqual(float(rows[0]["length"]), flat_length(0.44), delta=1e-3)

    def test_all_in_every_format(self):
        self.run_cli("unfold", "cabinet.step", "--all", "-o", "flat.svg", status=2)
        self.run_cli("unfold", "cabinet.step", "--all", "-o", "flat", "--format", "svg,step")
        self.assertIn("flat/angle_t2_flat.step", self.names())
        self.assertIn("flat/angle_t2.svg", self.names())
        self.assertNotIn("flat/angle_t2.dxf", self.names())

    def test_all_is_refused_when_nothing_unfolds(self):
        self.write("block.step", step_files.block())
        _, err = self.run_cli("unfold", "block.step", "--all", "-o", "flat/", status=4)
        self.assertIn("[not_a_sheet]", err)
        self.assertEqual(self.json("flat/summary.json")["status"], "refused")

    def test_all_of_a_file_that_cannot_be_read(self):
        self.refused("unfold", "missing.step", "--all", "-o", "flat/", "--json", "r.json", status=3)
        self.assertEqual(self.json("r.json")["reason"]["code"], "cannot_read")


class OtherFiles(CliTest):
    """An assembly whose parts are in files of their own."""

    def setUp(self):
        super().setUp()
        self.write("assembly.step", step_files.assembly_of_file("part.step"))

    def test_parts_are_found_beside_it(self):
        self.angle()
        self.run_cli("info", "assembly.step", "--json", "info.json")
        bodies = self.json("info.json")["bodies"]
        self.assertEqual([(body["name"], body["quantity"]) for body in bodies], [("child", 2)])
        self.run_cli("unfold", "assembly.step", "-o", "flat.dxf", "--quiet")
        self.assertIn("flat.dxf", self.names())

    def test_a_missing_part_leaves_nothing(self):
        sentence = self.refused("unfold", "assembly.step", status=3)
        self.assertIn("[no_solid]", sentence)

    def test_a_file_that_is_part_of_itself_ends(self):
        self.write("loop.step", step_files.assembly_of_file("loop.step"))
        self.refused("unfold", "loop.step", status=3)


class Info(CliTest):
    def test_says_what_is_in_a_file(self):
        self.write("cabinet.step", step_files.two_angles_and_a_block())
        out, err = self.run_cli("info", "cabinet.step")
        self.assertEqual(err, "")
        for words in ("AP214", "planish tests", "mm", "3 different bodies", "block"):
            self.assertIn(words, out)

    def test_as_json(self):
        self.write("cabinet.step", step_files.two_angles_and_a_block())
        out, _ = self.run_cli("info", "cabinet.step", "--json", "-")
        info = json.loads(out)
        self.assertEqual(info["format"], "planish/info")
        self.assertEqual([body["faces"] for body in info["bodies"]], [10, 10, 6])
        self.assertEqual([body["quantity"] for body in info["bodies"]], [2, 1, 1])
        for extent, wanted in zip(info["bodies"][0]["size"], (50, 50, 60)):
            self.assertAlmostEqual(extent, wanted, places=4)
        self.assertAlmostEqual(info["bodies"][2]["volume"], 27000, places=3)

    def test_finds_the_sheets(self):
        self.write("cabinet.step", step_files.two_angles_and_a_block())
        self.run_cli("info", "cabinet.step", "--sheets", "--json", "i.json")
        sheets = [body["sheet"] for body in self.json("i.json")["bodies"]]
        self.assertEqual([sheet["reason"] is None for sheet in sheets], [True, True, False])
        self.assertAlmostEqual(sheets[1]["thickness"], 1.5, places=9)
        out, _ = self.run_cli("info", "cabinet.step", "--sheets", "--body", "3")
        self.assertIn("not_a_sheet", out)

    def test_standard_input(self):
        out, _ = self.run_cli("info", "-", "--units", "inch", stdin=step_files.angle().encode())
        self.assertIn("1 body, lengths in inch", out)


class RealParts(CliTest):
    """Files that come with the repository or lie beside it."""

    def test_example(self):
        example = SOURCE / "examples" / "bracket.step"
        if not example.exists():
            self.skipTest("there is no examples/bracket.step")
        self.run_cli("unfold", example, "-o", "bracket.dxf", "-o", "bracket.svg", "--json", "r.json")
        report = self.json("r.json")
        self.assertNotEqual(report["status"], "refused")
        self.assertAlmostEqual(report["verification"]["volume_ratio"], 1.0, places=3)

    def part(self, name):
        part = pathlib.Path(os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts") / name
        if not part.exists():
            self.skipTest("the real parts are absent: tools/fetch_parts.py brings them")
        return part

    def test_assembly_of_two_sheets(self):
        self.run_cli("unfold", self.part("asm002_thelio_Veneer-V1.step"), "--all", "-o", "flat/")
        self.assertEqual(self.names(), ["flat/Veneer_t0.8-2.dxf", "flat/Veneer_t0.8.dxf",
                                        "flat/summary.csv", "flat/summary.json"])

    def test_assembly_of_sheets_and_other_bodies(self):
        self.run_cli("unfold", self.part("asm012_FreeCAD-librar_endstop.step"), "--all", "-o", "flat/")
        summary = self.json("flat/summary.json")
        self.assertGreater(summary["unfolded"], 0)
        self.assertGreater(summary["refused"], 0)
        for body in summary["bodies"]:
            self.assertEqual(body["reason"] is None, bool(body["files"]), body["body"])


if __name__ == "__main__":
    main()
