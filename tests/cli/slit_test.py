#!/usr/bin/python3
"""Bends slit sheets whose forms must keep lengths and end where they must; refuses those that cannot."""

import itertools
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import CliTest, main  # noqa: E402

EXAMPLES = pathlib.Path(__file__).parent / "../../examples/slit"


def chair(**more):
    """Six strips over a straight leg, with a seat that rises to a back."""
    return dict({"format": "planish/slits", "version": 1, "units": "mm", "thickness": 4.0,
                 "sheet": {"strips": 6, "strip_width": 60, "panel_height": 420, "half_length": 464},
                 "leg_curve": {"bezier": [[360, 0], [360, 120], [360, 240], [360, 360]]},
                 "seat_curve": {"bezier": [[330, 0], [300, 120], [310, 240], [640, 360]]}}, **more)


def banner(**more):
    """Three strips with free ends, not symmetric."""
    return dict({"thickness": 1.0, "symmetric": False,
                 "sheet": {"strips": [{"width": 40}, {"width": 30, "gap": 5, "end": 520}, {"width": 50}],
                           "panel_height": 200, "half_length": 400, "margin": 10},
                 "leg_curve": {"bezier": [[0, 0], [0, 135]]},
                 "ends": [{"strip": 0, "position": [-150, 480, 20], "direction": [-1, 0, 0]},
                          {"strip": 2, "direction": [0, 1, 0]}]}, **more)


class SlitTest(CliTest):
    def spec(self, content):
        self.write("spec.json", json.dumps(content))
        return "spec.json"

    def report(self, content, *options):
        self.run_cli("slit", self.spec(content), "--json", "report.json", *options)
        return self.json("report.json")

    def sentence(self, content, status=4):
        return self.refused("slit", self.spec(content), "--check", status=status)


class Forms(SlitTest):
    def check_strips(self, report, length):
        for strip in report["slit"]["strips"]:
            self.assertEqual(strip["status"], "solved")
            self.assertLess(strip["gap"], 1e-9 * length)
            for near, far in itertools.pairwise(strip["ridges"]):
                # All four sides and both diagonals of a quadrilateral, flat and folded.
                flat, folded = near["flat"] + far["flat"], near["folded"] + far["folded"]
                for i, j in itertools.combinations(range(4), 2):
                    self.assertAlmostEqual(math.dist(flat[i], flat[j]), math.dist(folded[i], folded[j]), delta=1e-9 * length)
        self.assertLess(report["slit"]["gap"], 1e-9 * length)
        self.assertLess(report["slit"]["flat_deviation"], 1e-9 * length)

    def test_a_strip_that_is_creased_is_no_success(self):
        report = self.report(chair(weights={"smooth": 10}, subdivisions=1))
        radii = [strip["min_radius"] for strip in report["slit"]["strips"]]
        creased = [i for i, radius in enumerate(radii) if radius < 1.5 * 4.0]
        self.assertTrue(creased)
        found = [f["message"] for f in report["checks"] if f["code"] == "creased"]
        self.assertEqual(len(found), len(creased))
        self.assertEqual(report["status"], "warning")

    def test_the_objective_energy_bends_strips_less(self):
        def energy(name, objective):
            report = self.report(dict(json.loads((EXAMPLES / name).read_text()), objective=objective))
            self.check_strips(report, 6800)
            return sum(strip["energy"] for strip in report["slit"]["strips"])

        for name in ("chair.json", "arch.json", "monument.json", "plume.json", "bridge.json"):
            self.assertLess(energy(name, "energy"), 0.9 * energy(name, "smooth"), name)

    def test_the_chair_meets_its_mirror_image(self):
        report = self.report(chair(subdivisions=1), "-o", "chair.stl", "--flat", "chair.dxf")
        self.check_strips(report, 464)
        for number, strip in enumerate(report["slit"]["strips"]):
            self.assertEqual(len(strip["ridges"]), 21)
            for end in strip["ridges"][-1]["folded"]:
                self.assertAlmostEqual(end[0], 0.0, delta=1e-7)
            for across, (flat, folded) in enumerate(zip(*(strip["ridges"][0][key] for key in ("flat", "folded")))):
                self.assertEqual(flat, [420, 60 * (number + across)])
                self.assertAlmostEqual(math.dist(folded, [360, 420, 60 * (number + across)]), 0.0, delta=1e-9)
        # The whole sheet, both halves of it.
        self.assertAlmostEqual(report["flat"]["area"], 2 * 360 * (420 + 464), delta=1e-6)
        self.assertEqual([round(x, 6) for x in report["flat"]["size"]], [1768, 360])
        self.assertEqual(report["status"], "ok")

    def test_strips_of_a_sheet_that_is_not_symmetric(self):
        report = self.report(banner(), "--flat", "banner.svg", "-o", "banner.obj")
        self.check_strips(report, 400)
        first, _, last = report["slit"]["strips"]
        middle = [0.5 * (a + b) for a, b in zip(*first["ridges"][-1]["folded"])]
        self.assertAlmostEqual(math.dist(middle, [-150, 480, 20]), 0.0, delta=1e-7)
        before, end = (strip["folded"][0] for strip in last["ridges"][-2:])
        self.assertAlmostEqual((end[1] - before[1]) / math.dist(end, before), 1.0, places=9)
        self.assertAlmostEqual(report["flat"]["area"], 200 * 135 + 40 * 400 + 30 * 320 + 50 * 400, delta=1e-6)

    def test_anchors_and_weights_are_heard(self):
        plain = self.report(chair(), "--check")["slit"]["strips"]
        anchor = {"strip": 2, "ridge": 5, "side": "left", "at": [180, 330, 150]}
        far = math.dist(plain[2]["ridges"][5]["folded"][0], anchor["at"])
        anchored = self.report(chair(anchors=[anchor]), "--check")["slit"]["strips"]
        near = math.dist(anchored[2]["ridges"][5]["folded"][0], anchor["at"])
        self.assertAlmostEqual(anchored[2]["anchor_distance"], near, places=6)
        self.assertLess(near, 0.6 * far)
        nearer = self.report(chair(anchors=[anchor], weights={"anchors": 3.0}), "--check")["slit"]["strips"]
        self.assertLess(nearer[2]["anchor_distance"], near)
        # The last two press each other, and come to rest to a micrometre.
        for other, most in ((0, 1e-9), (1, 1e-9), (5, 1e-3)):
            for before, after in zip(plain[other]["ridges"], anchored[other]["ridges"]):
                for p, q in zip(before["folded"], after["folded"]):
                    self.assertLess(math.dist(p, q), most)

    def test_a_scan_draws_its_strip(self):
        known = self.report(chair(anchors=[{"strip": 0, "ridge": 5, "at": [200, 380, 0]}], weights={"anchors": 1.0}, objective="smooth"), "--check")
        points = [end for ridge in known["slit"]["strips"][0]["ridges"] for end in ridge["folded"]]
        dense = [[a + t * (b - a) for a, b in zip(p, q)] for p, q in zip(points, points[2:]) for t in (i / 20 for i in range(20))]
        self.write("scan.txt", "# x y z\n" + "\n".join(" ".join(map(repr, p)) for p in dense) + "\n\n")
        plain = self.report(chair(objective="smooth"), "--check")["slit"]["strips"][0]

        def away(strip):
            """Root mean square distance of the ridges' ends from the scan."""
            ends = [end for ridge in strip["ridges"][1:] for end in ridge["folded"]]
            return math.sqrt(sum(min(math.dist(end, p) for p in dense) ** 2 for end in ends) / len(ends))

        for given in ("scan.txt", dense):
            drawn = self.report(chair(scan=[{"strip": 0, "points": given}], weights={"scan": 1.0}, objective="smooth"), "--check")["slit"]["strips"][0]
            # The points are a millimetre apart, so the nearest is farther away than the edge that they trace.
            self.assertLess(drawn["scan_distance"], away(drawn))
            self.assertLess(away(drawn), 0.2 * away(plain))

    def test_slits_are_lines_or_slots_with_stop_holes(self):
        def cut(**more):
            report = self.report(chair(**more), "--flat", "pattern.dxf")
            lines = (self.dir / "pattern.dxf").read_text().split("\n")
            pairs = list(zip(lines[::2], lines[1::2]))
            kind, count = None, {}
            for code, value in ((code.strip(), value.strip()) for code, value in pairs):
                if code == "0":
                    kind = value
                if code == "8" and value in ("INTERIOR_PROFILES", "SLITS"):
                    count[kind] = count.get(kind, 0) + 1
                    self.assertEqual(value == "SLITS", kind == "LINE")
            return report["flat"], count

        # Five slits through both halves, 928 long.
        flat, entities = cut()
        self.assertEqual((flat["slits"], entities), (5, {"LINE": 5}))
        self.assertAlmostEqual(flat["cutting"]["inner"], 5 * 928, places=6)
        self.assertAlmostEqual(flat["area"], 360 * 1768, places=6)
        flat, entities = cut(kerf=3)
        self.assertEqual(entities, {"LWPOLYLINE": 5})
        self.assertAlmostEqual(flat["area"], 360 * 1768 - 5 * (3 * 928 + math.pi * 1.5 ** 2), places=6)
        self.assertAlmostEqual(flat["cutting"]["inner"], 5 * (2 * 928 + math.pi * 3), places=6)
        flat, entities = cut(kerf=3, stop_hole=8)
        half = math.asin(1.5 / 4)  # of the slot's mouth, seen from the middle of a hole
        segment = 16 * (math.pi - half) + 1.5 * 4 * math.cos(half)
        self.assertAlmostEqual(flat["area"], 360 * 1768 - 5 * (3 * (928 - 8 * math.cos(half)) + 2 * segment), places=6)
        flat, entities = cut(stop_hole=8)
        self.assertEqual(entities["LINE"], 5)
        self.assertAlmostEqual(flat["area"], 360 * 1768 - 10 * math.pi * 16, places=6)
        self.assertIn("spec.json/kerf", self.sentence(chair(kerf=70), 3))
        self.assertIn("spec.json/stop_hole", self.sentence(chair(kerf=3, stop_hole=70), 3))

    def test_legs_level_with_the_ground(self):
        leg = {"bezier": [[700, 0], [700, 360]], "lean": 90}
        sheet = {"strips": 6, "strip_width": 60, "panel_height": 420, "half_length": 700}
        report = self.report(chair(leg_curve=leg, sheet=sheet), "--check")
        self.check_strips(report, 1120)
        for i, strip in enumerate(report["slit"]["strips"]):
            first = strip["ridges"][0]["folded"]  # the panel is 420 high: its upper edge lies at 700 − 420
            for end, z in zip(first, (60 * i, 60 * i + 60)):
                self.assertLess(math.dist(end, (280, 0, z)), 1e-9)
            self.assertGreater(strip["ridges"][-1]["folded"][0][1], 0)
        self.assertAlmostEqual(report["flat"]["area"], 360 * 2 * 1120, places=6)
        self.assertIn("/leg_curve/lean", self.sentence(chair(leg_curve={**leg, "lean": 91}), 3))
        self.assertIn("symmetry plane", self.sentence(chair(leg_curve={**leg, "bezier": [[400, 0], [400, 360]]}), 3))

    def test_two_panels(self):
        def bridge(**more):
            strips = [{"width": 60}, {"width": 60, "end": 1150}, {"width": 60, "left_start": 220}]
            return dict({"thickness": 2, "symmetric": False, "subdivisions": 1,
                         "sheet": {"strips": strips, "panel_height": 200, "half_length": 1000},
                         "leg_curve": {"bezier": [[300, 0], [300, 180]], "lean": 20},
                         "second_panel": {"height": 150, "leg_curve": {"bezier": [[-300, 10], [-300, 190]], "lean": -30}}}, **more)
        report = self.report(bridge(), "--flat", "pattern.dxf", "-o", "folded.step")
        self.check_strips(report, 1350)
        self.assertAlmostEqual(report["flat"]["area"], 180 * 1350, places=6)
        # A slit runs as far as the longer of its two strips, beside the other's panel.
        self.assertAlmostEqual(report["flat"]["cutting"]["inner"], 2 * (1200 - 200), places=6)
        self.assertLess(abs(report["verification"]["length_error"]), 1e-6)
        for strip, (end, z) in zip(report["slit"]["strips"], ((1200, 10), (1150, 70), (1200, 130))):
            high = 1350 - end  # above the second panel's free edge; it leans outwards by 30°
            edge = (-300 - high * math.sin(math.radians(30)), high * math.cos(math.radians(30)))
            for point, across in zip(strip["ridges"][-1]["folded"], (z, z + 60)):
                self.assertLess(math.dist(point, (*edge, across)), 1e-9 * 1350)
        self.assertIn("/second_panel", self.sentence(bridge(symmetric=True), 3))
        self.assertIn("/ends", self.sentence(bridge(ends=[{"strip": 0, "direction": [0, 1, 0]}]), 3))
        far = bridge(second_panel={"height": 150, "leg_curve": {"bezier": [[-900, 0], [-900, 180]]}})
        self.assertIn("out of reach", self.sentence(far))

    def test_a_leg_curve_is_scaled_to_the_sheet(self):
        half = {"bezier": [[360, 0], [360, 60], [360, 120], [360, 180]]}
        self.assertIn('set fit to true', self.sentence(chair(leg_curve=half)))
        fitted = self.report(chair(leg_curve={**half, "fit": True}), "--check")
        whole = self.report(chair(), "--check")
        self.assertAlmostEqual(fitted["slit"]["leg_scales"][0], 2, places=9)
        self.assertEqual(whole["slit"]["leg_scales"], [1])
        for a, b in zip(fitted["slit"]["strips"], whole["slit"]["strips"]):
            for p, q in zip(a["ridges"], b["ridges"]):
                self.assertLess(math.dist(p["folded"][0], q["folded"][0]), 1e-3)

    def test_a_mould_that_cannot_be_made_leaves_the_other_files(self):
        sideways = chair(mould={"up": [1, 0, 0]})
        report = self.report(sideways, "--mould", "mould.stl", "-o", "folded.step", "--flat", "pattern.dxf")
        self.assertEqual(self.names(), ["folded.step", "pattern.dxf", "report.json", "spec.json"])
        self.assertEqual(report["status"], "warning")
        found = [check for check in report["checks"] if check["code"] == "mould"]
        self.assertEqual(len(found), 1)
        self.assertRegex(found[0]["message"], "no mould could be made.*mould\\.(up|side|inset|form)")
        self.assertNotIn("mould.stl", str(report["files"]))
        (self.dir / "folded.step").unlink()
        sentence = self.refused("slit", self.spec(sideways), "--mould", "mould.stl", status=4)
        self.assertRegex(sentence, "mould\\.(up|side|inset|form)")

    def test_the_mould_as_one_body(self):
        self.report(chair(subdivisions=1, mould={"form": "body", "base": 30}), "--mould", "mould.obj", "--mould", "mould.step")
        lines = (self.dir / "mould.obj").read_text().splitlines()
        points = [tuple(float(x) for x in line.split()[1:]) for line in lines if line.startswith("v ")]
        facets = [[int(x) - 1 for x in line.split()[1:]] for line in lines if line.startswith("f ")]
        sides = [(f[i], f[(i + 1) % 3]) for f in facets for i in range(3)]
        self.assertEqual(len(set(sides)), len(sides))
        self.assertEqual(set(sides), {(b, a) for a, b in sides})
        cross = lambda u, v: (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        volume = sum(sum(x * y for x, y in zip(points[a], cross(points[b], points[c]))) for a, b, c in facets) / 6
        self.run_cli("info", "mould.step", "--json", "info.json")
        bodies = self.json("info.json")["bodies"]
        self.assertEqual(len(bodies), 1)
        self.assertAlmostEqual(bodies[0]["volume"] / volume, 1, places=6)

    def test_the_mould_lies_half_the_thickness_below(self):
        report = self.report(chair(), "--mould", "mould.obj", "--mould", "mould.step", "-o", "folded.step")
        self.assertEqual(self.names(), ["folded.step", "mould.obj", "mould.step", "report.json", "spec.json"])
        lines = (self.dir / "mould.obj").read_text().splitlines()
        points = [tuple(float(x) for x in line.split()[1:]) for line in lines if line.startswith("v ")]
        facets = [[int(x) - 1 for x in line.split()[1:]] for line in lines if line.startswith("f ")]
        sides = [(f[i], f[(i + 1) % 3]) for f in facets for i in range(3)]
        self.assertEqual(len(set(sides)), len(sides))
        self.assertEqual(set(sides), {(b, a) for a, b in sides})  # closed
        # Facets that are parallel to a quadrilateral of the modelled half and lie under it.
        def plane(a, b, c):
            u, v = [[q - p for p, q in zip(a, other)] for other in (b, c)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            size = math.hypot(*n)
            return [x / size for x in n] if size > 1e-9 else None
        found = 0
        for strip in report["slit"]["strips"]:
            for near, far in itertools.pairwise(strip["ridges"]):
                a, b, c = near["folded"][0], far["folded"][0], near["folded"][1]
                normal = plane(a, b, c)
                for facet in facets:
                    p = [points[i] for i in facet]
                    other = plane(*p)
                    if other is None or abs(sum(x * y for x, y in zip(normal, other))) < 1 - 1e-9:
                        continue
                    apart = [abs(sum(n * (x - y) for n, x, y in zip(normal, corner, a))) for corner in p]
                    if max(abs(d - 2.0) for d in apart) < 1e-4:
                        found += 1
                        break
        self.assertGreater(found, 40)  # of 60 quadrilaterals; steep ones are left bare
        self.run_cli("info", "mould.step")

    def test_inches(self):
        small = chair(units="inch", sheet={"strips": 2, "strip_width": 3, "panel_height": 15, "half_length": 18}, thickness=0.125,
                      leg_curve={"bezier": [[14, 0], [14, 6]]}, seat_curve={"bezier": [[14, 0], [13, 6]]})
        report = self.report(small, "--check")
        self.assertEqual(report["units"], "inch")
        self.assertAlmostEqual(report["flat"]["area"], 2 * 6 * 33, places=6)
        self.check_strips(report, 18)

    def test_examples_are_solved(self):
        for example in sorted(EXAMPLES.glob("*.json")):
            with self.subTest(example.name):
                self.run_cli("slit", str(example), "--check", "--json", "report.json")
                report = self.json("report.json")
                self.assertEqual(report["status"], "warning" if example.stem == "stool_pushed" else "ok")
                for strip in report["slit"]["strips"]:
                    self.assertEqual(strip["status"], "solved")
                length = max(report["flat"]["size"])
                self.assertLess(report["slit"]["gap"], 1e-9 * length)

    def test_a_stool_stands_until_it_is_pushed(self):
        """Balanced by hand: 750 N at the height of the seat, 270 N aside, the weight of the sheet; feet 360 apart."""
        for name, stands in ("stool", True), ("stool_pushed", False):
            self.run_cli("slit", str(EXAMPLES / f"{name}.json"), "--check", "--json", "report.json")
            report = self.json("report.json")
            slit = report["slit"]
            codes = {check["code"] for check in report["checks"]}
            self.assertEqual("falls_over" not in codes, stands)
            self.assertIn("springs_open", codes)
            self.assertTrue(slit["stable"])
            self.assertEqual(slit["standing"]["stands"], stands)
            seat = slit["strips"][0]["ridges"][-1]["folded"][0][1]
            weight = 7.9e-6 * 9.80665 * 2.0 * 1768 * 360
            push = 0 if stands else 270
            # About the edge of the feet: what holds, and what tips.
            margin = 180 * (750 + weight) - push * seat
            self.assertEqual(margin > 0, stands)
            up = sum(reaction["force"][1] for reaction in slit["reactions"] if reaction["end"] == "panel")
            strips = 7.9e-6 * 9.80665 * 2.0 * 464 * 360
            self.assertAlmostEqual(up, 375 + strips, delta=1e-6 * up)


class Refusals(SlitTest):
    def test_loads_that_cannot_be(self):
        stool = json.loads((EXAMPLES / "stool.json").read_text())
        for change, place, what in (
                ({"loads": [{"strip": 9, "force": [0, -1, 0]}]}, "/loads/0/strip", "there is no strip 10"),
                ({"material": {"young": 190000}}, "/gravity", "the material has no density"),
                ({"material": None}, "/gravity", "no material"),
                ({"objective": "smooth"}, "/gravity", "not of least energy"),
                ({"loads": [{"strip": 0, "force": [5, -1, 0]}]}, "/loads/0/force", "across its symmetry plane"),
                ({"loads": [{"strip": 0, "force": -75}]}, "/loads/0/force", "a force [x, y, z]"),
                ({"material": "no_such.json"}, "no_such.json", "no_such.json")):
            spec = {key: value for key, value in {**stool, **change}.items() if value is not None}
            (self.dir / "s.json").write_text(json.dumps(spec))
            error = self.run_cli("slit", "s.json", "--check", status=3)[1]
            self.assertIn(place, error)
            self.assertIn(what, error)

    def middle_points(self, strip):
        """Of a strip's middle surface, in space, some every few millimetres."""
        for near, far in itertools.pairwise(strip["ridges"]):
            for i, j in itertools.product(range(11), repeat=2):
                left, right = ([a + i / 10 * (b - a) for a, b in zip(near["folded"][side], far["folded"][side])]
                               for side in (0, 1))
                yield [a + j / 10 * (b - a) for a, b in zip(left, right)]

    def test_strips_that_run_through_each_other(self):
        spec = json.loads((EXAMPLES / "plume.json").read_text())
        for strip in spec["sheet"]["strips"]:
            strip["end"] = 6000
        spec["ends"][2]["position"], spec["ends"][3]["position"] = [2839, 1904, 2231], [2377, 2409, 792]
        spec["objective"] = "smooth"  # strips of least energy are parted
        self.assertIn("[self_intersection]", self.sentence(spec))
        report = self.report(spec, "--write-anyway")
        found = [check for check in report["checks"] if check["code"] == "self_intersection"]
        self.assertEqual([check["severity"] for check in found], ["error"])
        self.assertIn("strip 3 and strip 5 run through each other when folded, 9 mm deep", found[0]["message"])
        # Their middle surfaces come nearer than any two sheets of 10 mm can.
        two, four = (list(self.middle_points(report["slit"]["strips"][i])) for i in (2, 4))
        self.assertLess(min(math.dist(p, q) for p in two for q in four), 9.0)

    def test_neighbours_that_press_into_each_other(self):
        press = {"code": "strips_press", "severity": "info"}
        for name, expected in ("low_chair", [press]), ("chair", []), ("plume", []):
            with self.subTest(name):
                self.run_cli("slit", str(EXAMPLES / f"{name}.json"), "--check", "--json", "report.json")
                report = self.json("report.json")
                found = [{key: check[key] for key in press} for check in report["checks"]
                         if check["code"] in ("strips_press", "self_intersection")]
                self.assertEqual(found, expected)
                for check in report["checks"]:  # its places are no worse than the finding
                    if check["code"] == "strips_press":
                        self.assertEqual({place["severity"] for place in check["places"]}, {"info"})

    def test_strips_too_short(self):
        short = chair()
        short["sheet"]["half_length"] = 300
        sentence = self.refused("slit", self.spec(short), "-o", "folded.step", "--json", "report.json", status=4)
        self.assertIn("[out_of_reach]", sentence)
        report = self.json("report.json")
        self.assertEqual(self.names(), ["report.json", "spec.json"])
        for strip in report["slit"]["strips"]:
            self.assertEqual(strip["status"], "out_of_reach")
            self.assertAlmostEqual(strip["shortfall"], 60, delta=1.0)  # 360 away, 300 long

    def test_curves_that_do_not_fit(self):
        self.assertIn("[curve_too_short]", self.sentence(chair(leg_curve={"bezier": [[360, 0], [360, 300]]})))
        self.assertIn("[curve_too_long]", self.sentence(chair(leg_curve={"bezier": [[360, 0], [360, 400]]})))
        self.assertIn("spec.json/seat_curve", self.sentence(chair(seat_curve={"bezier": [[300, 0], [300, 200]]})))
        tight = chair(leg_curve={"bezier": [[360, 0], [390, 180], [360, 360]]}, min_inside_radius=5000)
        self.assertIn("[radius_too_small]", self.sentence(tight))
        self.assertIn("spec.json/leg_curve", self.sentence(chair(leg_curve={"bezier": [[0, 0], [0, 360]]}), 3))

    def test_anchors_and_scans_that_cannot_be(self):
        self.assertIn("spec.json/anchors/0/strip", self.sentence(chair(anchors=[{"strip": 6, "ridge": 1, "at": [0, 0, 0]}]), 3))
        self.assertIn("spec.json/anchors/0/ridge", self.sentence(chair(anchors=[{"strip": 0, "ridge": 11, "at": [0, 0, 0]}]), 3))
        far = self.sentence(chair(anchors=[{"strip": 0, "ridge": 5, "at": [200, 1200, 0]}]))
        self.assertIn("[out_of_reach]", far)
        self.assertRegex(far, r"[0-9.]+ mm out of reach")
        self.write("none.txt", "# nothing\n")
        self.assertIn("[empty_scan]", self.sentence(chair(scan=[{"strip": 0, "points": "none.txt"}]), 3))
        self.write("bad.txt", "1 2 3\n4 5\n")
        self.assertIn("bad.txt:2", self.sentence(chair(scan=[{"strip": 0, "points": "bad.txt"}]), 3))
        self.assertIn("[cannot_read]", self.sentence(chair(scan=[{"strip": 0, "points": "missing.txt"}]), 3))
        self.assertIn("spec.json/scan/0/strip", self.sentence(chair(scan=[{"strip": 9, "points": [[0, 0, 0]]}]), 3))

    def test_no_output_replaces_a_scan(self):
        points = "".join(f"{x} 500 30\n" for x in range(0, 300, 10))
        self.write("cloud.obj", points)
        spec = self.spec(chair(scan=[{"strip": 0, "points": "cloud.obj"}]))
        for output in (["-o", "cloud.obj"], ["--json", "cloud.obj"], ["-o", "./cloud.obj", "--json", "r.json"]):
            self.assertIn("cloud.obj", self.refused("slit", spec, *output, status=2))
            self.assertEqual((self.dir / "cloud.obj").read_text(), points)

    def test_scans_as_other_programs_write_them(self):
        def distances(name):
            return [s["scan_distance"] for s in self.report(chair(scan=[{"strip": 0, "points": name}]), "--check", "--write-anyway")["slit"]["strips"]]
        self.write("points.txt", "300.5 450.25 30\n200.5 480.25 30\n")
        self.write("commas.txt", "\ufeff300,5 450,25 30,0\n200,5\t480,25;30,0\n")
        self.assertEqual(distances("points.txt"), distances("commas.txt"))

    def test_scans_of_something_else_are_said(self):
        metres = [[x / 1e4, 0.45, 0.03] for x in range(3000)]
        codes = [c["code"] for c in self.report(chair(scan=[{"strip": 0, "points": metres}]), "--check")["checks"]]
        self.assertIn("scan_far", codes)

    def test_numbers_beyond_any_sheet(self):
        for value in (1e160, 1e308, -1e20):
            poles = [[360, 0], [360, value], [360, 360]]
            self.assertIn("/leg_curve/bezier/1", self.sentence(chair(leg_curve={"bezier": poles}), 3))
            self.assertIn("/seat_curve/bezier/1", self.sentence(chair(seat_curve={"bezier": poles}), 3))
            self.assertIn("/anchors/0/at", self.sentence(chair(anchors=[{"strip": 0, "ridge": 1, "at": [0, 0, value]}]), 3))
        self.assertIn("64", self.sentence(chair(leg_curve={"bezier": [[360, i / 5] for i in range(1801)]}), 3))
        self.assertIn("/weights/seat", self.sentence(chair(weights={"seat": 1e9}), 3))

    def test_what_would_be_left_out_silently(self):
        self.assertIn("/ends/1/strip", self.sentence(banner(ends=[{"strip": 1, "direction": [0, 1, 0]}, {"strip": 1}]), 3))
        self.assertIn("/seat_curve", self.sentence(banner(seat_curve={"bezier": [[0, 0], [0, 135]]}), 3))

    def test_numbers_and_keys(self):
        self.assertIn("spec.json/weights/smooth", self.sentence(chair(weights={"smooth": -1}), 3))
        self.assertIn("spec.json/ridges", self.sentence(chair(ridges=2), 3))
        self.assertIn("spec.json/subdivisions", self.sentence(chair(subdivisions=9), 3))
        self.assertIn("/sheet/strips", self.sentence(chair(sheet={"strips": 0, "strip_width": 60, "panel_height": 1, "half_length": 1}), 3))
        self.assertIn("/colour", self.sentence(chair(colour="red"), 3))
        self.assertIn("/ends", self.sentence(chair(ends=[{"strip": 0}]), 3))
        self.assertIn("/ends/0/strip", self.sentence(banner(ends=[{"strip": 5}]), 3))
        self.refused("slit", "missing.json", "--check", status=3)
        self.refused("slit", self.spec(chair()), "-o", "folded.dxf", status=2)


if __name__ == "__main__":
    main()
