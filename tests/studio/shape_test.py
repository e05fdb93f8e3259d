#!/usr/bin/python3
"""Reads shapes as the page does, folds them, and compares the folded corners with those of the STEP file."""

import csv
import itertools
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_studio import CLI, EXAMPLES, StudioTest, main  # noqa: E402

ALL = ["bracket.step", "connect/a_folded.json", "connect/b_lofted.json", "connect/ten_plates.json", "transition/a_square_to_round.json",
       "transition/h_hexagon_to_round.json", "slit/chair.json"]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def turn(hinge, angle):
    """About the line through two points of the plane, by the right hand."""
    ax, ay, bx, by = hinge
    length = math.hypot(bx - ax, by - ay)
    x, y, c, s = (bx - ax) / length, (by - ay) / length, math.cos(angle), math.sin(angle)
    r = [[c + x * x * (1 - c), x * y * (1 - c), y * s], [x * y * (1 - c), c + y * y * (1 - c), -x * s], [-y * s, x * s, c]]
    p = [ax, ay, 0.0]
    return [r[i] + [p[i] - sum(r[i][k] * p[k] for k in range(3))] for i in range(3)] + [[0, 0, 0, 1]]


def rows(values, width):
    return [values[i:i + width] for i in range(0, len(values), width)]


def placed(shape, share):
    """By facet, the motion from the flat pattern into space at a share of the fold."""
    a, motions = shape.arrays, []
    root = rows(shape.json["root"], 4)
    for parent, hinge, angle in zip(a["facet_parent"], rows(a["facet_hinge"], 4), a["facet_angle"]):
        motions.append(root if parent < 0 else product(motions[parent], turn(hinge, share * angle)))
    return motions


def facet_points(shape, facet):
    a = shape.arrays
    first, last = (a["ring_starts"][a["polygon_starts"][a["facet_starts"][f]]] for f in (facet, facet + 1))
    return rows(a["points"], 2)[first:last]


def moved(m, p):
    return tuple(m[i][0] * p[0] + m[i][1] * p[1] + m[i][3] for i in range(3))


def folded_points(shape, share=1.0):
    return [moved(m, p) for f, m in enumerate(placed(shape, share)) for p in facet_points(shape, f)]


def step_corners(path):
    """Vertices of a STEP file in mm."""
    text = path.read_text()
    points = {m[1]: tuple(map(float, m[2].split(","))) for m in re.finditer(r"#(\d+) = CARTESIAN_POINT\('[^']*',\(([^)]*)\)\)", text)}
    return [points[m[1]] for m in re.finditer(r"VERTEX_POINT\('[^']*',#(\d+)\)", text)]


class Shapes(StudioTest):
    def check_arrays(self, shape):
        a = shape.arrays
        facets, points = len(a["facet_parent"]), len(a["points"]) // 2
        for starts, count in (("ring_starts", points), ("polygon_starts", len(a["ring_starts"]) - 1),
                              ("facet_starts", len(a["polygon_starts"]) - 1)):
            self.assertEqual(a[starts][0], 0)
            self.assertEqual(a[starts][-1], count, starts)
            self.assertTrue(all(x <= y for x, y in itertools.pairwise(a[starts])), starts)
        for name, count in (("facet_starts", facets + 1), ("facet_hinge", 4 * facets), ("facet_angle", facets), ("facet_part", facets),
                            ("edge_facet", len(a["edges"]) // 4), ("edge_circle", 4 * len(a["edge_length"])), ("edge_feature", len(a["edge_length"])),
                            ("edge_number", len(a["edges"]) // 4), ("bend_line_part", len(a["bend_lines"]) // 4)):
            self.assertEqual(len(a[name]), count, name)
        self.assertEqual(a["facet_parent"][0], -1)
        for i, parent in enumerate(a["facet_parent"]):
            self.assertLess(parent, i)
            self.assertEqual(parent == -1, i == 0)
        for name in ("facet_part", "bend_line_part"):
            self.assertLess(max(a[name], default=0), len(shape.json["parts"]))
        self.assertLess(max(a["edge_facet"]), facets)
        self.assertEqual(sorted(set(a["edge_number"])), list(range(max(a["edge_number"]) + 1)))
        self.assertTrue(all(math.isfinite(x) for name in ("points", "facet_hinge", "facet_angle", "edges") for x in a[name]))

    def check_rings(self, shape):
        """Outer rings counter-clockwise, holes clockwise; together they cover what the report says."""
        a, points = shape.arrays, rows(shape.arrays["points"], 2)
        total = 0.0
        for first, last in itertools.pairwise(a["polygon_starts"]):
            for ring in range(first, last):
                at = points[a["ring_starts"][ring]:a["ring_starts"][ring + 1]]
                area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(at, at[1:] + at[:1])) / 2
                self.assertEqual(area > 0, ring == first, (ring, area))
                total += area
        flat = shape.report["flat"] or shape.report["pieces"][0]["flat"]
        self.assertAlmostEqual(total, flat["area"], delta=1e-3 * flat["area"])

    def test_pierces_are_those_of_the_part_list(self):
        """Contours and slits, as `planish pack` counts them."""
        for name in ("bracket.step", "connect/a_folded.json", "slit/arch.json"):
            document, spec = self.studio.open_example(name)
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([CLI, "pack", EXAMPLES / name, "-o", f"{folder}/pack", "--no-plan", "--no-drawings"], check=True, capture_output=True, timeout=200)
                with open(f"{folder}/pack/parts.csv", newline="") as file:
                    rows = [row for row in csv.DictReader(file) if row["file"] != "total"]
            for verb in ("draft", "result"):
                self.assertEqual([str(self.studio.shape(document, verb, spec).json["pierces"])], [row["pierces"] for row in rows], (name, verb))
        sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
        import step_files
        refused = self.studio.open("block.step", step_files.block()).json()["id"]
        self.assertIsNone(self.studio.shape(refused, "result").json["pierces"])

    def test_arrays_fit_each_other(self):
        for name in ALL:
            document, spec = self.studio.open_example(name)
            for verb in ("draft", "result"):
                with self.subTest(example=name, verb=verb):
                    shape = self.studio.shape(document, verb, spec)
                    self.check_arrays(shape)
                    self.check_rings(shape)

    def test_facets_keep_together_at_every_stage(self):
        """A facet and its parent share the hinge, so it is where both place it."""
        for name in ALL:
            document, spec = self.studio.open_example(name)
            shape = self.studio.shape(document, "draft", spec)
            for share in (0.0, 0.3, 1.0):
                motions = placed(shape, share)
                for f, (parent, hinge) in enumerate(zip(shape.arrays["facet_parent"], rows(shape.arrays["facet_hinge"], 4))):
                    for end in (hinge[:2], hinge[2:]):
                        if parent >= 0:
                            self.assertLess(math.dist(moved(motions[f], end), moved(motions[parent], end)), 1e-6, (name, f))

    def test_the_folded_bracket_has_the_corners_of_the_solid(self):
        document, _ = self.studio.open_example("bracket.step")
        shape = self.studio.shape(document, "draft", k=0.5)  # the neutral surface is the middle one
        folded = folded_points(shape)
        half = shape.report["sheet"]["thickness"] / 2
        corners = step_corners(EXAMPLES / "bracket.step")
        self.assertGreater(len(corners), 60)
        for corner in corners:
            self.assertAlmostEqual(min(math.dist(corner, p) for p in folded), half, delta=0.02, msg=str(corner))
        self.assertAlmostEqual(max(math.dist(p, q) for p, q in itertools.combinations(folded, 2)),
                               max(math.dist(p, q) for p, q in itertools.combinations(corners, 2)), delta=2 * half)

    def test_flanges_know_exactly_where_they_are(self):
        """Every vertex of the solid is a corner of a flange that is moved there, half a thickness up or down, at any K."""
        document, _ = self.studio.open_example("bracket.step")
        for k in (0.3, 0.5):
            shape = self.studio.shape(document, "draft", k=k)
            half, corners = shape.report["sheet"]["thickness"] / 2, []
            for f, row in enumerate(shape.arrays["facet_part"]):
                part = shape.json["parts"][row]
                self.assertEqual("place" in part, part["kind"] == "flange")
                if "place" in part:
                    m = rows(part["place"], 4)
                    corners += [tuple(c + s * half * m[i][2] for i, c in enumerate(moved(m, p))) for p in facet_points(shape, f) for s in (-1, 1)]
            for corner in step_corners(EXAMPLES / "bracket.step"):
                self.assertLess(min(math.dist(corner, c) for c in corners), 2e-5, str(corner))

    def test_a_flat_sheet_lies_in_the_plane_of_its_root(self):
        document, _ = self.studio.open_example("bracket.step")
        shape = self.studio.shape(document, "draft")
        root = rows(shape.json["root"], 4)
        for p, q in zip(folded_points(shape, 0.0), [moved(root, p) for f in range(len(shape.arrays["facet_parent"])) for p in facet_points(shape, f)]):
            self.assertLess(math.dist(p, q), 1e-4)

    def test_the_square_to_round_ends_on_both_profiles(self):
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        # Facets that turn by a fold the arc of a quarter of the circle to within a²/24 of its length.
        for verb, turn in (("draft", 10.0), ("result", 6.0)):
            most = math.radians(turn) ** 2 / 24 * 0.5 * math.pi * 100
            folded = folded_points(self.studio.shape(document, verb, spec))
            for corner in itertools.product((-150, 150), (-150, 150), (0,)):
                self.assertLess(min(math.dist(corner, p) for p in folded), most + 0.02)
            top = [p for p in folded if p[2] > 249.5]
            self.assertGreater(len(top), 20)
            for p in top:
                self.assertAlmostEqual(math.hypot(p[0], p[1]), 100.0, delta=0.5)

    def test_handles_are_where_the_spec_has_them(self):
        document, spec = self.studio.open_example("connect/a_folded.json")
        plates = self.studio.shape(document, "draft", spec).json["handles"]["plates"]
        self.assertEqual({p["id"]: p["corners"] for p in plates}, {p["id"]: p["outline"] for p in spec["plates"]})
        document, spec = self.studio.open_example("slit/chair.json")
        handles = self.studio.shape(document, "draft", spec).json["handles"]
        self.assertEqual(handles["leg_curve"][0], [360, 0, 0])
        self.assertEqual(handles["seat_curve"][-1], [0, 640, 360])
        self.assertEqual(len(handles["ridges"]), 6)
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        handles = self.studio.shape(document, "draft", spec).json["handles"]
        self.assertEqual(handles["profiles"][0]["points"][0], [-150, -150, 0])
        self.assertTrue(all(abs(math.hypot(x, y) - 100) < 1e-9 and z == 250 for x, y, z in handles["profiles"][1]["points"]))

    def test_ten_plates_are_one_sheet(self):
        document, spec = self.studio.open_example("connect/ten_plates.json")
        shape = self.studio.shape(document, "result", spec)
        self.assertEqual((shape.report["status"], shape.report["checks"]), ("ok", []))
        self.assertEqual([p["plate"] for p in shape.json["parts"] if p["kind"] == "flange"], [p["id"] for p in spec["plates"]])
        self.assertEqual(sorted(len(b["between"]) for b in shape.report["flat"]["bends"]), [2] * 9)

    def test_a_draft_says_what_it_has_not_computed(self):
        document, spec = self.studio.open_example("connect/a_folded.json")
        draft = self.studio.shape(document, "draft", spec).report
        whole = self.studio.shape(document, "result", spec).report
        self.assertIsNone(draft["verification"])
        self.assertEqual(draft["checks"], [])
        self.assertIsNotNone(whole["verification"])
        self.assertAlmostEqual(draft["flat"]["area"], whole["flat"]["area"], delta=1e-4 * whole["flat"]["area"])
        self.assertEqual([b["id"] for b in draft["flat"]["bends"]], [b["id"] for b in whole["flat"]["bends"]])

    def test_k_of_one_bend_moves_that_bend_alone(self):
        document, _ = self.studio.open_example("bracket.step")
        plain, moved_one = self.studio.shape(document, "draft", k=0.4), self.studio.shape(document, "draft", k=0.4, bend_k={"B2": 0.5})
        for before, after in zip(plain.report["flat"]["bends"], moved_one.report["flat"]["bends"]):
            self.assertAlmostEqual(after["k_factor"], 0.5 if after["id"] == "B2" else 0.4)
            grown = math.radians(after["angle"]) * 0.1 * plain.report["sheet"]["thickness"] if after["id"] == "B2" else 0.0
            self.assertAlmostEqual(after["allowance"] - before["allowance"], grown, delta=1e-9)
        self.assert_problem(self.studio.post(document, "draft", bend_k={"B99": 0.5}), "bad_option")
        self.assert_problem(self.studio.post(document, "draft", k=0.4, din6935=True), "bad_option")
        self.assertIsNotNone(self.studio.shape(document, "result", bend_k={"B1": 0.3}).report["verification"])

    def test_what_is_refused_is_still_seen(self):
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        spec["to"]["frame"]["origin"] = [0, 0, 0]
        shape = self.studio.shape(document, "draft", spec)
        self.assertEqual(shape.report["status"], "refused")
        self.assertEqual(shape.report["reason"]["code"], "profiles_meet")
        self.assertEqual(len(shape.json["handles"]["profiles"]), 2)

    def test_solids_that_are_no_sheets_are_shown(self):
        sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
        import step_files
        opened = self.studio.open("block.step", step_files.block()).json()
        shape = self.studio.shape(opened["id"], "draft")
        self.assertEqual(shape.report["status"], "refused")
        triangles = rows(shape.arrays["space_triangles"], 3)
        points = rows(shape.arrays["space_points"], 3)
        self.assertGreaterEqual(len(triangles), 12)
        self.assertLess(max(itertools.chain(*triangles)), len(points))
        # Faces have the numbers that the file gives them: each one's triangles lie across its direction.
        text = step_files.block()
        entity = dict(re.findall(r"(#\d+)=(.*?);", text))
        shell = next(e for e in entity.values() if e.startswith("CLOSED_SHELL"))
        for number, face in enumerate(re.findall(r"#\d+", shell), 1):
            plane = entity[re.findall(r"#\d+", entity[face])[-1]]
            placement = entity[re.findall(r"#\d+", plane)[0]]
            direction = [float(v) for v in re.search(r"\(([^()]*)\)", entity[re.findall(r"#\d+", placement)[1]])[1].split(",")]
            own = [t for t, of in zip(triangles, shape.arrays["space_faces"]) if of == number]
            self.assertEqual(len(own), 2)
            for corners in own:
                heights = {round(sum(a * b for a, b in zip(points[c], direction)), 4) for c in corners}
                self.assertEqual(len(heights), 1, f"face {number}")
                self.assertGreaterEqual(heights.pop(), 0.0)  # the side to which it faces

    def test_what_is_drawn_is_told_from_what_is_cut(self):
        sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
        import step_files
        opened = self.studio.open("pressed.step", step_files.pressed_plate()).json()
        for verb in ("draft", "result"):
            shape = self.studio.shape(opened["id"], verb)
            kinds = [feature["kind"] for feature in shape.report["flat"]["features"]]
            found = {}  # radius of a circle: the features whose outline it is
            for feature, radius in zip(shape.arrays["edge_feature"], shape.arrays["edge_circle"][2::4]):
                found.setdefault(round(radius, 4), set()).add(kinds[feature] if feature >= 0 else "cut")
            self.assertEqual(found, {0.0: {"cut"}, 2.5: {"cut"}, 5.0: {"countersink"}, 10.0: {"formed"}})
            cut = sum(length for length, feature in zip(shape.arrays["edge_length"], shape.arrays["edge_feature"]) if feature < 0)
            self.assertAlmostEqual(cut, 320 + 5 * math.pi, delta=1e-3)

    def test_overlaps_are_triangles_of_their_area(self):
        """The front wall and a flap of the left wall stand side by side, and lie on each other when flat."""
        spec = {"thickness": 1, "k_factor": 0.5, "root": "base", "plates": [
            {"id": "base", "outline": [[0, 0, 0], [100, 0, 0], [100, 100, 0], [0, 100, 0]]},
            {"id": "left", "outline": [[-6, 0, 6], [-6, 100, 6], [-6, 100, 86], [-6, 0, 86]]},
            {"id": "front", "outline": [[-80, -6, 6], [100, -6, 6], [100, -6, 86], [-80, -6, 86]]},
            {"id": "flap", "outline": [[-12, -12, 6], [-12, -12, 86], [-100, -12, 86], [-100, -12, 6]]}],
            "bends": [{"between": ["base", "left"]}, {"between": ["base", "front"]}, {"between": ["left", "flap"]}]}
        opened = self.studio.open("flap.json", json.dumps(spec)).json()
        shape = self.studio.shape(opened["id"], "result", spec)
        said = sum(float(re.search(r"by ([0-9.e+]+) mm²", check["message"])[1]) for check in shape.report["checks"] if check["code"] == "overlap")
        corners = rows(rows(shape.arrays["overlaps"], 2), 3)
        area = sum((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) for a, b, c in corners) / 2
        self.assertGreater(said, 100.0)
        self.assertAlmostEqual(area, said, delta=0.02 * said)
        self.assertNotIn("overlaps", self.studio.shape(opened["id"], "draft", spec).arrays)


if __name__ == "__main__":
    main()
