#!/usr/bin/python3
"""Joins plates whose sheet is known by a formula; refuses what cannot be joined or read."""

import copy
import json
import math
import os
import pathlib
import struct
import sys

import ezdxf
from ezdxf.math import bulge_to_arc

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import CliTest, main  # noqa: E402

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "connect"
BEND_KEYS = {"id", "kind", "angle", "inside_radius", "k_factor", "allowance", "deduction",
             "direction", "length", "line", "between", "edges", "slope", "apex", "width", "span",
             "extension_area", "surface", "facing", "frame", "half_angle", "inside_radii",
             "lateral", "alternatives", "joined", "stretches"}

THICKNESS, RADIUS, WIDTH, HEIGHT, GAP = 4.0, 12.0, 200.0, 100.0, 20.0


def ell():
    """Two plates of 200 x 100, t = 4, at right angles; each ends 20 before the line in which their
    planes meet. A bend of inside radius 12 has its tangent lines 12 + 2 before it."""
    return {"format": "planish/plates", "version": 1, "units": "mm", "thickness": THICKNESS,
            "plates": [{"id": "A", "outline": [[0, 0, 0], [200, 0, 0], [200, 100, 0], [0, 100, 0]]},
                       {"id": "B", "outline": [[0, 120, 20], [200, 120, 20], [200, 120, 120],
                                               [0, 120, 120]]}],
            "bends": [{"between": ["A", "B"], "inside_radius": RADIUS}]}


def flat_length(k, radius=RADIUS):
    extension = GAP - (radius + THICKNESS / 2)
    return 2 * (HEIGHT + extension) + math.pi / 2 * (radius + k * THICKNESS)


def scaled(plates, scale):
    scaled_plates = copy.deepcopy(plates)
    scaled_plates["thickness"] *= scale
    for plate in scaled_plates["plates"]:
        plate["outline"] = [[scale * x for x in corner] for corner in plate["outline"]]
    for bend in scaled_plates["bends"]:
        bend["inside_radius"] *= scale
    return scaled_plates


def arcs_of_dxf(path):
    """(x, y, radius) of each arc and circle that ezdxf reads, sorted."""
    arcs = []
    for entity in ezdxf.readfile(path).modelspace():
        if entity.dxftype() == "CIRCLE":
            arcs.append((entity.dxf.center.x, entity.dxf.center.y, entity.dxf.radius))
        elif entity.dxftype() in ("LWPOLYLINE", "POLYLINE"):
            points = list(entity.get_points("xyb")) if entity.dxftype() == "LWPOLYLINE" else [
                (*vertex.dxf.location.vec2, vertex.dxf.get("bulge", 0)) for vertex in entity.vertices]
            for (ax, ay, bulge), (bx, by, _) in zip(points, points[1:] + points[:1]):
                if bulge:
                    centre, _, _, radius = bulge_to_arc((ax, ay), (bx, by), bulge)
                    arcs.append((centre.x, centre.y, radius))
    return sorted(arcs)


def facets_of_stl(data):
    """(normal, three corners) of each."""
    count, = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count, "not a whole binary STL"
    return [[struct.unpack_from("<3f", data, 84 + 50 * i + 12 * k) for k in range(4)]
            for i in range(count)]


def corners_of_stl(data):
    return [corner for facet in facets_of_stl(data) for corner in facet[1:]]


def volume_of_stl(data):
    """By the divergence theorem."""
    return sum(a[i] * (b[j] * c[k] - b[k] * c[j]) / 6
               for n, a, b, c in facets_of_stl(data) for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))


class PlatesTest(CliTest):
    def plates(self, content=None, name="plates.json"):
        self.write(name, json.dumps(ell() if content is None else content))
        return name

    def report(self, *options, content=None):
        self.plates(content)
        self.run_cli("connect", "plates.json", "--json", "report.json", *options)
        return self.json("report.json")


class Ell(PlatesTest):
    def test_needs_nothing_but_the_file(self):
        self.plates()
        out, err = self.run_cli("connect", "plates.json")
        self.assertEqual(err, "")
        self.assertEqual(self.names(), ["plates.dxf", "plates.json", "plates.step"])
        for words in ("plates.json: sheet 4 mm", "2 flanges, 1 bend", "A – B", "cylinder", "12.000",
                      "90.0°", "extension area", "certificate: volume 1.000000",
                      "wrote plates.step", "wrote plates.dxf"):
            self.assertIn(words, out)

    def test_report_has_its_keys_and_the_values_of_the_formula(self):
        report = self.report()
        self.assertEqual(report["command"], "connect")
        self.assertEqual(report["input"], "plates.json")
        self.assertEqual(report["units"], "mm")
        self.assertEqual(report["status"], "ok")
        self.assertIsNone(report["reason"])
        self.assertEqual(report["files"], ["plates.step", "plates.dxf"])
        self.assertEqual(report["sheet"]["flanges"], 2)
        self.assertAlmostEqual(report["sheet"]["volume"], THICKNESS * WIDTH * flat_length(0.5), places=3)
        self.assertAlmostEqual(report["flat"]["area"], WIDTH * flat_length(0.44), places=5)
        self.assertAlmostEqual(report["flat"]["size"][0], flat_length(0.44), places=6)
        self.assertAlmostEqual(report["flat"]["size"][1], WIDTH, places=6)
        self.assertEqual(len(report["flat"]["bends"]), 1)
        self.assertLessEqual(BEND_KEYS, report["flat"]["bends"][0].keys())

    def test_report_says_how_the_bend_was_fitted(self):
        bend = self.report()["flat"]["bends"][0]
        self.assertEqual(bend["between"], ["A", "B"])
        self.assertEqual(bend["edges"], {"A": [2], "B": [0]})
        self.assertEqual(bend["surface"], "cylinder")
        self.assertEqual(bend["facing"], "facing")
        self.assertIsNone(bend["apex"])
        self.assertIsNone(bend["half_angle"])
        self.assertAlmostEqual(bend["slope"], 0.0, places=9)
        self.assertAlmostEqual(bend["offset"], -(RADIUS + THICKNESS / 2), places=6)
        self.assertAlmostEqual(bend["angle"], 90.0, places=6)
        self.assertAlmostEqual(bend["inside_radius"], RADIUS, places=6)
        self.assertAlmostEqual(bend["width"], WIDTH, places=6)
        self.assertAlmostEqual(bend["extension_area"], 2 * WIDTH * (GAP - RADIUS - 2), places=4)
        self.assertAlmostEqual(bend["length"], WIDTH, places=6)
        self.assertAlmostEqual(bend["frame"]["beta"], 90.0, places=6)
        self.assertEqual({abs(round(x, 6)) for x in bend["frame"]["d"]}, {0.0, 1.0})

    def test_certificate_holds(self):
        verification = self.report("--k", "0.3")["verification"]
        self.assertAlmostEqual(verification["volume_ratio"], 1.0, places=6)
        self.assertLess(verification["length_error"], 1e-6)
        self.assertLess(verification["refold_deviation"], 1e-6)

    def test_k_comes_from_the_command_then_the_file(self):
        in_file = ell()
        in_file["k_factor"] = 0.4
        self.write("table.csv", "r/t,k\n1,0.30\n5,0.50\n")
        for options, k, source in (([], 0.4, "plates file"), (["--k", "0.5"], 0.5, "constant"),
                                   (["--k-table", "table.csv"], 0.4, None),
                                   (["--din6935"], 0.5 * (0.65 + 0.5 * math.log10(3)), None)):
            report = self.report(*options, content=in_file)
            self.assertAlmostEqual(report["sheet"]["k_factor"], k, places=9)
            self.assertAlmostEqual(report["flat"]["size"][0], flat_length(k), places=6)
            if source:
                self.assertEqual(report["sheet"]["k_source"], source)
        self.assertEqual(self.report()["sheet"]["k_source"], "default")

    def test_finds_the_bend_by_itself(self):
        content = ell()
        del content["bends"]
        bend = self.report(content=content)["flat"]["bends"][0]
        self.assertEqual(bend["between"], ["A", "B"])
        self.assertAlmostEqual(bend["angle"], 90.0, places=6)

    def test_report_speaks_the_units_of_the_file(self):
        mm = self.report()
        content = scaled(ell(), 1 / 25.4)
        content["units"] = "inch"
        inch = self.report(content=content)
        self.assertEqual(inch["units"], "inch")
        self.assertAlmostEqual(inch["flat"]["size"][0], mm["flat"]["size"][0] / 25.4, places=6)
        self.assertAlmostEqual(inch["flat"]["bends"][0]["inside_radius"], RADIUS / 25.4, places=6)
        self.assertAlmostEqual(inch["flat"]["bends"][0]["width"], WIDTH / 25.4, places=6)
        lines = [line.strip() for line in (self.dir / "plates.dxf").read_text().split("\n")]
        self.assertEqual(lines[lines.index("$INSUNITS") + 2], "1")
        asked = self.report("--units", "mm", content=content)
        self.assertEqual(asked["units"], "mm")
        self.assertAlmostEqual(asked["flat"]["size"][0], mm["flat"]["size"][0], places=4)

    def test_mass_by_density(self):
        mass = self.report("--density", "7.85")["sheet"]["mass"]
        self.assertAlmostEqual(mass, 7.85e-6 * THICKNESS * WIDTH * flat_length(0.5), places=6)

    def test_rules_can_be_edited_and_left_out(self):
        self.write("rules.json", '{"inside_radius_t": 100}')
        strict = self.report("--rules", "rules.json")
        self.assertEqual(strict["status"], "warning")
        self.assertEqual(self.report("--no-rules")["checks"], [])

    def test_unfolding_the_folded_part_gives_the_same_pattern(self):
        made = self.report("-o", "part.step")
        self.run_cli("unfold", "part.step", "--json", "again.json")
        again = self.json("again.json")
        self.assertAlmostEqual(again["sheet"]["thickness"], THICKNESS, places=6)
        for extent, wanted in zip(again["flat"]["size"], made["flat"]["size"]):
            self.assertAlmostEqual(extent, wanted, places=4)
        self.assertEqual(again["body"], "plates")

    def test_same_input_gives_the_same_bytes(self):
        self.report()
        before = {name: (self.dir / name).read_bytes() for name in ("plates.dxf", "report.json")}
        self.report()
        self.assertEqual(before, {name: (self.dir / name).read_bytes() for name in before})

    def test_names_the_option_that_writes_such_a_file(self):
        self.write("plates.json", json.dumps(ell()))
        for option, name, other in (("-o", "a.dxf", "--flat"), ("--flat", "a.stl", "-o")):
            said = self.refused("connect", "plates.json", option, name, status=2)
            self.assertIn(f"{option} writes no {name[1:]} files. Give {other} {name} instead", said)


def through_the_bend():
    """The plates of `ell` and a third one, which comes from the top of B and leans back into the bend
    between A and B: planes of B and C meet at z = -5.7, and C ends 5 from there, at 22.4 degrees."""
    plates = ell()
    plates["plates"].append({"id": "C", "outline": [[50, 72.4, 109.9], [150, 72.4, 109.9],
                                                    [150, 118.1, -1.1], [50, 118.1, -1.1]]})
    plates["bends"].append({"between": ["B", "C"]})
    return plates


class ThroughItself(CliTest):
    def test_plate_through_a_bend_is_an_error_with_both_parts_and_the_depth(self):
        self.write("plates.json", json.dumps(through_the_bend()))
        said = self.refused("connect", "plates.json", "--json", "report.json", "--no-rules", status=4)
        self.assertIn("--write-anyway", said)
        self.assertEqual(self.names(), ["plates.json", "report.json"])
        report = self.json("report.json")
        self.assertEqual((report["status"], report["reason"]["code"]), ("refused", "self_intersection"))
        out, _ = self.run_cli("connect", "plates.json", "--json", "report.json", "--no-rules", "--write-anyway")
        self.assertEqual(self.names(), ["plates.dxf", "plates.json", "plates.step", "report.json"])
        report = self.json("report.json")
        self.assertEqual((report["status"], report["reason"]), ("warning", None))
        found, behind = report["checks"]
        self.assertEqual(behind["code"], "round_the_back")
        self.assertEqual((found["code"], found["severity"]), ("self_intersection", "error"))
        self.assertEqual(found["message"], "flange 3 and bend B1 run through each other when "
                                           "folded, 4 mm deep")
        self.assertGreaterEqual(len(found["at"]), 2)
        self.assertIn("error [self_intersection]", out)

    def test_its_solid_says_the_same(self):
        self.write("plates.json", json.dumps(through_the_bend()))
        self.run_cli("connect", "plates.json", "-o", "part.step", "--no-rules", "--quiet", "--write-anyway")
        self.refused("unfold", "part.step", "--check", "--json", "report.json", "--no-rules", status=4)
        report = self.json("report.json")
        self.assertEqual(report["status"], "refused")
        self.assertEqual([c["code"] for c in report["checks"]], ["self_intersection"])
        # Tables name options as the command line has them, too.
        said = self.run_cli("unfold", "part.step", "--all", "-o", "flat/", "--no-rules", status=4)[0]
        self.assertIn("Set --write-anyway to", said)
        said += self.run_cli("unfold", "part.step", "--check", "--no-rules", status=4)[0]
        self.assertNotIn("`", said + (self.dir / "flat" / "summary.csv").read_text())

    def test_plate_that_ends_before_the_bend_is_accepted(self):
        plates = through_the_bend()
        for corner in plates["plates"][2]["outline"][2:]:
            corner[1:] = [107.2, 25.4]
        self.write("plates.json", json.dumps(plates))
        self.run_cli("connect", "plates.json", "--check", "--json", "report.json", "--no-rules")
        self.assertEqual([c["code"] for c in self.json("report.json")["checks"]],
                         ["round_the_back"])


class PlatesOfAPart(CliTest):
    BRACKET = pathlib.Path(__file__).parent / "../../examples/bracket.step"

    def test_joined_again_they_are_the_part(self):
        # Its three holes stay circles; its rounded corners become polygons within 0.01 mm.
        self.run_cli("unfold", str(self.BRACKET), "--check", "--json", "part.json")
        part = self.json("part.json")["flat"]
        for options in ([], ["--with-bends"]):
            with self.subTest(options):
                self.run_cli("plates", str(self.BRACKET), "-o", "plates.json", *options)
                self.assertEqual("bends" in self.json("plates.json"), bool(options))
                self.run_cli("connect", "plates.json", "--check", "--json", "again.json")
                again = self.json("again.json")["flat"]
                self.assertAlmostEqual(again["area"], part["area"], delta=0.01 * 40)
                kinds = [[(round(b["angle"], 6), round(b["inside_radius"], 3), round(b["length"], 3)) for b in flat["bends"]]
                         for flat in (part, again)]
                self.assertEqual(sorted(kinds[0]), sorted(kinds[1]))

    def test_goes_through_a_pipe_and_refuses_what_has_no_sheet(self):
        text = self.run_cli("plates", str(self.BRACKET), "-o", "-")[0]
        self.assertEqual(len(json.loads(text)["plates"]), 3)
        self.write("empty.step", "ISO-10303-21;")
        self.refused("plates", "empty.step", "-o", "plates.json", status=3)
        self.refused("plates", "missing.step", "-o", "plates.json", status=3)
        self.assertNotIn("plates.json", self.names())
        self.assertIn("-o FILE", self.refused("plates", "-", status=2))


class RoundHoles(CliTest):
    """Arcs of holes in the drawing, as another program reads them. A lies turned by 90 degrees, B goes
    on behind the bend: (x, y) of A is drawn at (L - y, x), (x, z) of B at (120 - z, x)."""

    ON_A = [{"slot": {"from": [30, 20, 0], "to": [80, 20, 0], "width": 9}},
            {"slot": {"from": [110, 30, 0], "to": [150, 70, 0], "width": 6.5}},
            {"circle": {"at": [40, 60, 0], "radius": 7}},
            {"path": [[170, 40, 0], [180, 40, 0], {"through": [185, 45, 0], "to": [180, 50, 0]}, [170, 50, 0]]}]
    ON_B = [{"slot": {"from": [60, 120, 50], "to": [60, 120, 90], "width": 12}}]
    CENTRES_OF_A = [(30, 20, 4.5), (80, 20, 4.5), (110, 30, 3.25), (150, 70, 3.25), (40, 60, 7), (180, 45, 5)]
    CENTRES_OF_B = [(60, 50, 6), (60, 90, 6)]

    def write_plates(self):
        plates = ell()
        plates["plates"][0]["holes"] = self.ON_A
        plates["plates"][1]["holes"] = self.ON_B
        self.write("plates.json", json.dumps(plates))

    def wanted(self):
        length = flat_length(0.44)
        return sorted([(length - y, x, r) for x, y, r in self.CENTRES_OF_A] +
                      [(120 - z, x, r) for x, z, r in self.CENTRES_OF_B])

    def check_equal(self, found, wanted):
        self.assertEqual(len(found), len(wanted), found)
        for numbers, drawn in zip(found, wanted):
            for number, value in zip(numbers, drawn):
                self.assertAlmostEqual(number, value, places=4)

    def test_are_arcs_about_their_own_centres(self):
        self.write_plates()
        self.run_cli("connect", "plates.json", "--no-rules", "-o", "part.step", "--flat", "new.dxf")
        self.run_cli("connect", "plates.json", "--no-rules", "--r12", "--flat", "r12.dxf")
        self.run_cli("unfold", "part.step", "--no-rules", "-o", "again.dxf")
        for drawing in ("new.dxf", "r12.dxf", "again.dxf"):
            with self.subTest(drawing):
                self.check_equal(arcs_of_dxf(self.dir / drawing), self.wanted())

    def test_stay_so_in_the_plates_of_a_part(self):
        """However the pattern lies: each radius with the distances from its centre to all others."""
        def seen(arcs):
            return sorted((r, *sorted(math.dist(c, (x, y)) for *c, _ in arcs)) for x, y, r in arcs)

        self.write_plates()
        self.run_cli("connect", "plates.json", "--no-rules", "-o", "part.step")
        self.run_cli("plates", "part.step", "--with-bends", "-o", "found.json")
        self.run_cli("connect", "found.json", "--no-rules", "--flat", "found.dxf")
        found = [(x, y, round(r, 6)) for x, y, r in arcs_of_dxf(self.dir / "found.dxf")]
        self.check_equal(seen(found), seen(self.wanted()))


class Section(PlatesTest):
    """What ends free: its neutral surface is unrolled at K."""

    def test_pipe_of_its_own(self):
        pipe = {"thickness": 2, "plates": [],
                "bends": [{"between": [], "inside_radius": 30, "angle": 300, "length": 100}]}
        report = self.report(content=pipe)
        self.assertAlmostEqual(report["flat"]["area"], 100 * math.radians(300) * 30.88, places=4)
        self.assertAlmostEqual(report["verification"]["volume_ratio"], 1.0, places=6)
        bend = report["flat"]["bends"][0]
        self.assertEqual(bend["between"], [])
        self.assertEqual(bend["edges"], {})

    def test_half_pipe_at_a_plate(self):
        half = {"thickness": 2, "plates": ell()["plates"][:1],
                "bends": [{"between": ["A"], "edges": {"A": [2]}, "inside_radius": 30, "angle": 180}]}
        report = self.report(content=half)
        self.assertAlmostEqual(report["flat"]["area"], 200 * (100 + math.pi * 30.88), places=4)
        self.assertEqual(report["flat"]["bends"][0]["edges"], {"A": [2]})

    def test_angle_below_zero_bends_the_other_way(self):
        half = {"thickness": 2, "plates": ell()["plates"][:1],
                "bends": [{"between": ["A"], "edges": {"A": [2]}, "inside_radius": 30, "angle": 180}]}
        areas, heights = [], []
        for half["bends"][0]["angle"] in (180, -180):
            areas.append(self.report("-o", "half.stl", content=half)["flat"]["area"])
            heights.append([z for x, y, z in corners_of_stl((self.dir / "half.stl").read_bytes())])
        self.assertAlmostEqual(*areas, places=6)
        for height, wanted in zip((min(heights[0]), max(heights[0]), min(heights[1]), max(heights[1])),
                                  (-1, 63, -63, 1)):
            self.assertAlmostEqual(height, wanted, places=3)

    def test_section_without_its_angle(self):
        self.plates({"thickness": 2, "plates": [], "bends": [{"between": [], "length": 9}]})
        sentence = self.refused("connect", "plates.json", "--check", status=3)
        self.assertIn("plates.json/bends/0/angle", sentence)


class ObliqueCone(PlatesTest):
    """Two neighbouring corner pieces of a square-to-round: triangles whose planes meet at the apex."""

    def loft(self, tangent_point):
        plates = [{"id": "A", "outline": [[200, -170, 0], [200, 170, 0], [120, 0, 300]]},
                  {"id": "B", "outline": [[170, 200, 0], [-170, 200, 0], [0, 120, 300]]}]
        return {"thickness": 2, "plates": plates,
                "bends": [{"between": ["A", "B"], "edges": {"A": [1], "B": [2]}, "surface": "general",
                           "tangent_point": tangent_point}]}

    def test_is_developed_and_certified(self):
        report = self.report(content=self.loft([120, 120, 300]))
        bend = report["flat"]["bends"][0]
        self.assertEqual(bend["surface"], "general")
        self.assertAlmostEqual(bend["extension_area"], 0.0, places=6)
        self.assertLess(report["verification"]["volume_ratio"] - 1, 1e-5)

    def test_tangent_point_off_the_line_of_the_planes(self):
        self.plates(self.loft([120, 100, 300]))
        sentence = self.refused("connect", "plates.json", "--check", status=4)
        self.assertIn("plates.json/bends/0/tangent_point", sentence)


class Outputs(PlatesTest):
    def test_each_goes_where_it_is_said(self):
        self.plates()
        self.run_cli("connect", "plates.json", "-o", "a.step", "-o", "b.STP", "--flat", "c.dxf",
                     "--flat", "d.svg", "--flat", "e.step", "--json", "f.json")
        self.assertEqual(self.names(), ["a.step", "b.STP", "c.dxf", "d.svg", "e.step", "f.json",
                                        "plates.json"])
        self.assertEqual(self.json("f.json")["files"], ["a.step", "b.STP", "c.dxf", "d.svg", "e.step"])
        self.assertIn("<svg", (self.dir / "d.svg").read_text())
        self.assertEqual((self.dir / "a.step").read_bytes(), (self.dir / "b.STP").read_bytes())
        self.assertNotEqual((self.dir / "a.step").read_bytes(), (self.dir / "e.step").read_bytes())

    def test_mesh_of_the_folded_part(self):
        self.report("-o", "part.stl")
        volume = THICKNESS * WIDTH * flat_length(0.5)
        self.assertLess(abs(volume_of_stl((self.dir / "part.stl").read_bytes()) / volume - 1), 0.001)
        self.assertEqual(self.names(), ["part.stl", "plates.json", "report.json"])

    def test_only_what_is_asked_for_is_written(self):
        self.plates()
        self.run_cli("connect", "plates.json", "--flat", "a.dxf")
        self.assertEqual(self.names(), ["a.dxf", "plates.json"])
        self.run_cli("connect", "plates.json", "-o", "b.step")
        self.assertEqual(self.names(), ["a.dxf", "b.step", "plates.json"])

    def test_check_writes_nothing_but_the_report(self):
        self.plates()
        out, _ = self.run_cli("connect", "plates.json", "--check", "--json", "r.json")
        self.assertEqual(self.names(), ["plates.json", "r.json"])
        self.assertEqual(self.json("r.json")["files"], [])
        self.assertIn("certificate", out)

    def test_quiet_says_nothing(self):
        self.plates()
        self.assertEqual(self.run_cli("connect", "plates.json", "-q"), ("", ""))

    def test_json_on_standard_output_leaves_the_summary_to_standard_error(self):
        self.plates()
        out, err = self.run_cli("connect", "plates.json", "--json", "-")
        self.assertEqual(json.loads(out)["status"], "ok")
        self.assertIn("certificate", err)

    def test_standard_input(self):
        text = json.dumps(ell()).encode()
        out, _ = self.run_cli("connect", "-", "-o", "a.step", "--json", "r.json", stdin=text)
        self.assertEqual(self.names(), ["a.step", "r.json"])
        self.assertIn("standard input", out)
        self.assertEqual(self.json("r.json")["input"], "-")
        self.run_cli("connect", "-", "--check", stdin=text)

    def test_dxf_options_reach_the_file(self):
        self.plates()
        for options, wanted in ((["--r12"], "AC1009"), (["--profile", "onshape"], "SHEETMETAL_CUT"),
                                (["--tangent-lines"], "BEND_TANGENT")):
            self.run_cli("connect", "plates.json", *options)
            self.assertIn(wanted, (self.dir / "plates.dxf").read_text())


class Refusal(PlatesTest):
    """Each with its exit status, code and place, and nothing written but the report."""

    def refusal(self, code, pointer, content, *words, status=3, name="plates.json"):
        text = content if isinstance(content, (str, bytes)) else json.dumps(content)
        self.write(name, text)
        self.write("older.dxf", "older")
        sentence = self.refused("connect", name, "-o", "part.step", "--flat", "older.dxf", "--json",
                                "report.json", status=status)
        self.assertIn(f"[{code}]", sentence)
        for word in (pointer, *words):
            self.assertIn(word, sentence)
        self.assertEqual(self.names(), ["older.dxf", name, "report.json"])
        self.assertEqual((self.dir / "older.dxf").read_text(), "older")
        report = self.json("report.json")
        self.assertEqual(report["command"], "connect")
        self.assertEqual(report["status"], "refused")
        self.assertEqual(report["reason"]["code"], code)
        self.assertIn(name + pointer, report["reason"]["where"])
        (self.dir / "report.json").unlink()
        return sentence


class Unreadable(Refusal):
    def test_missing_file_and_folder(self):
        self.assertIn("[cannot_read]", self.refused("connect", "no.json", "--json", "r.json", status=3))
        self.assertEqual(self.json("r.json")["reason"]["code"], "cannot_read")
        (self.dir / "folder").mkdir()
        self.refused("connect", "folder", "--check", status=3)

    def test_what_is_no_json(self):
        self.refusal("invalid_input", ":2:", '{\n  "thickness" 4 }', "line 2, column ")
        for content in (b"", b"\x00\xff\xfe", b"ISO-10303-21;", b"[", b"[" * 100000):
            self.refusal("invalid_input", "", content)

    def test_what_is_no_plates_file(self):
        self.refusal("invalid_input", "", "[]", "one JSON object")
        wrong = ell()
        wrong["format"] = "planish/rules"
        self.refusal("invalid_input", "/format", wrong, "planish/plates")

    def test_unknown_key(self):
        wrong = ell()
        wrong["plates"][1]["outlin"] = wrong["plates"][1].pop("outline")
        self.refusal("invalid_input", "/plates/1/outlin", wrong, "outline", "holes")

    def test_missing_key(self):
        wrong = ell()
        del wrong["thickness"]
        self.refusal("invalid_input", "/thickness", wrong, "is missing")
        wrong = ell()
        del wrong["bends"][0]["between"]
        self.refusal("invalid_input", "/bends/0/between", wrong, "is missing")

    def test_values_out_of_range(self):
        for pointer, value in ((("thickness",), -4), (("thickness",), 0), (("thickness",), "4"),
                               (("units",), "cm"), (("k_factor",), 2),
                               (("plates", 0, "outline", 2, 1), None),
                               (("plates", 0, "id"), 7), (("bends", 0, "inside_radius"), -12),
                               (("bends", 0, "trade_off"), -1), (("bends", 0, "surface"), "ball"),
                               (("bends", 0, "edges"), {"A": [1.5]})):
            wrong = ell()
            at = wrong
            for key in pointer[:-1]:
                at = at[key]
            at[pointer[-1]] = value
            self.refusal("invalid_input", "/" + "/".join(map(str, pointer)), wrong, "must be")

    def test_two_plates_of_one_name(self):
        wrong = ell()
        wrong["plates"][1]["id"] = "A"
        self.refusal("invalid_input", "/plates/1/id", wrong)

    def test_standard_input_is_named_as_such(self):
        sentence = self.refused("connect", "-", "--check", status=3, stdin=b'{"thicknes": 1}')
        self.assertIn("standard input/thicknes", sentence)


class WrongPlates(Refusal):
    def outline(self, corners, plate=1):
        wrong = ell()
        wrong["plates"][plate]["outline"] = corners
        return wrong

    def test_too_few_corners(self):
        self.refusal("too_few_corners", "/plates/1/outline",
                     self.outline([[0, 120, 20], [200, 120, 20]]))

    def test_repeated_corner(self):
        self.refusal("repeated_corner", "/plates/1/outline",
                     self.outline([[0, 120, 20], [200, 120, 20], [200, 120, 20], [0, 120, 120]]))

    def test_not_planar(self):
        self.refusal("not_planar", "/plates/1/outline",
                     self.outline([[0, 120, 20], [200, 120, 20], [200, 125, 120], [0, 120, 120]]),
                     "mm")

    def test_self_crossing(self):
        self.refusal("self_crossing", "/plates/1/outline",
                     self.outline([[0, 120, 20], [200, 120, 20], [0, 120, 120], [200, 120, 120]]))

    def test_unknown_plate(self):
        wrong = ell()
        wrong["bends"][0]["between"] = ["A", "C"]
        self.refusal("unknown_plate", "/bends/0/between", wrong, "C")
        wrong = ell()
        wrong["root"] = "C"
        self.refusal("unknown_plate", "/root", wrong, "C")

    def test_edges_that_a_plate_does_not_have(self):
        wrong = ell()
        wrong["bends"][0]["edges"] = {"A": [4]}
        self.refusal("unknown_edge", "/bends/0/edges/A", wrong)

    def test_edges_that_cannot_carry_one_bend(self):
        wrong = ell()
        wrong["bends"][0]["edges"] = {"A": [0, 2]}
        self.refusal("unknown_edge", "/bends/0", wrong, "edges 0 and 2")

    def test_loop_of_bends(self):
        wrong = ell()
        wrong["plates"].append({"id": "C", "outline": [[220, 0, 20], [220, 100, 20], [220, 100, 120],
                                                       [220, 0, 120]]})
        wrong["bends"] = [{"between": pair} for pair in (["A", "B"], ["A", "C"], ["B", "C"])]
        self.refusal("bend_loop", "/bends/2", wrong)

    def test_plate_left_alone(self):
        wrong = ell()
        wrong["plates"].append({"id": "C", "outline": [[220, 0, 20], [220, 100, 20], [220, 100, 120],
                                                       [220, 0, 120]]})
        self.refusal("not_connected", "/bends", wrong, '"C"')

    def test_radius_that_does_not_fit(self):
        wrong = ell()
        wrong["bends"][0]["inside_radius"] = 40
        # The tangent lines may lie 20 before the line in which the planes meet: 20 - 4 / 2.
        sentence = self.refusal("no_bend_fits", "/bends/0/inside_radius", wrong, "18", "mm", status=4)
        self.assertTrue(sentence.startswith("planish: refused: "))

    def test_sheet_thicker_than_its_plates_are_wide(self):
        folded = json.loads((EXAMPLES / "a_folded.json").read_text())
        self.refusal("radius_too_small", "/plates/1", {**folded, "thickness": 2000}, "a sheet of 2000 mm needs more than", status=4)


class Usage(PlatesTest):
    def wrong(self, *arguments):
        self.plates()
        sentence = self.refused("connect", *arguments, status=2)
        self.assertEqual(self.names(), ["plates.json"])
        return sentence

    def test_help_has_every_option_and_examples(self):
        out, _ = self.run_cli("connect", "--help")
        for words in ("-o,", "--flat", "--json", "--check", "--quiet", "--k ", "--k-table",
                      "--din6935", "--units", "--profile", "--r12", "--splines", "--rules",
                      "--no-rules", "--density", "--write-overlapping", "Examples:", "Exit status:"):
            self.assertIn(words, out)
        self.assertIn("connect", self.run_cli("--help")[0])

    def test_values_and_words_that_are_not_allowed(self):
        for option, value in (("--k", "1.5"), ("--density", "0"), ("--units", "cm"),
                              ("--profile", "autocad")):
            self.assertIn(option, self.wrong("plates.json", option, value))
        self.wrong("plates.json", "--body", "1")
        self.wrong("plates.json", "--root", "1")
        self.wrong()

    def test_options_that_contradict_each_other(self):
        for options in (["--k", "0.4", "--din6935"], ["--no-rules", "--rules", "r.json"],
                        ["--check", "-o", "a.step"], ["--check", "--flat", "a.dxf"],
                        ["--r12", "--splines", "keep"]):
            self.wrong("plates.json", *options)
        self.wrong("-", "--rules", "-", "-o", "a.step")

    def test_names_that_do_not_say_what_to_write(self):
        for option, name in (("-o", "a.dxf"), ("-o", "a"), ("-o", "folder/"), ("--flat", "a.stl"),
                             ("--flat", "a"), ("--flat", "")):
            self.assertIn(option, self.wrong("plates.json", option, name))

    def test_standard_input_needs_names_for_the_outputs(self):
        self.assertIn("-o", self.wrong("-"))

    def test_an_output_never_replaces_an_input(self):
        self.plates(name="plates.step")
        before = (self.dir / "plates.step").read_bytes()
        os.symlink("plates.step", self.dir / "link.step")
        for options in (["-o", "plates.step"], ["-o", "link.step"], ["--flat", "./plates.step"],
                        ["--json", "plates.step"], []):
            sentence = self.refused("connect", "plates.step", *options, status=2)
            self.assertIn("would be lost", sentence)
        self.assertEqual((self.dir / "plates.step").read_bytes(), before)

    def test_two_outputs_under_one_name(self):
        self.wrong("plates.json", "-o", "a.step", "--flat", "./a.step")
        self.wrong("plates.json", "-o", "a.step", "-o", "a.step")

    def test_outputs_into_a_folder_that_is_not_there(self):
        self.plates()
        self.refused("connect", "plates.json", "--flat", "no/a.dxf", status=3)
        self.assertEqual(self.names(), ["plates.json"])


if __name__ == "__main__":
    main()
