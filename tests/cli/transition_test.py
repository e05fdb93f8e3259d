#!/usr/bin/python3
"""Makes transitions whose nets are known by a formula; refuses profiles that have none."""

import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import CliTest, main  # noqa: E402

EXAMPLES = pathlib.Path(__file__).parent / "../../examples/transition"


def frustum(**more):
    """Circles of 150 and 100, 200 apart."""
    return dict({"format": "planish/transition", "version": 1, "thickness": 2.0,
                 "from": {"profile": {"circle": {"radius": 150}}},
                 "to": {"profile": {"circle": {"radius": 100}}, "frame": {"origin": [0, 0, 200]}}}, **more)


def square_to_round(**more):
    return dict({"thickness": 1.0,
                 "from": {"profile": {"polygon": [[-150, -150], [150, -150], [150, 150], [-150, 150]]}},
                 "to": {"profile": {"circle": {"radius": 100}}, "frame": {"origin": [0, 0, 250]}},
                 "seam": {"edge": 0}}, **more)


class TransitionTest(CliTest):
    def spec(self, content):
        self.write("spec.json", json.dumps(content))
        return "spec.json"

    def report(self, content, *options):
        self.run_cli("transition", self.spec(content), "--json", "report.json", *options)
        return self.json("report.json")

    def sentence(self, content, status=4):
        return self.refused("transition", self.spec(content), "--check", status=status)


class Nets(TransitionTest):
    def test_frustum_is_a_sector(self):
        report = self.report(frustum())
        slant = math.hypot(200, 50)
        area = math.pi * 250 * slant
        self.assertAlmostEqual(report["flat"]["area"] / area, 1.0, places=9)
        self.assertAlmostEqual(report["transition"]["area"] / area, 1.0, places=9)
        for length, radius in zip(report["transition"]["perimeters"], (150, 100)):
            self.assertAlmostEqual(length, 2 * math.pi * radius, places=6)
        self.assertAlmostEqual(report["transition"]["true_lengths"][0]["length"], slant, places=9)
        self.assertAlmostEqual(report["verification"]["volume_ratio"], 1.0, places=5)
        self.assertEqual(self.names(), ["report.json", "spec.dxf", "spec.json", "spec.step"])

    def test_sizes_of_the_inside_and_of_the_outside(self):
        for sizes, off in (("inside", 1.0), ("outside", -1.0)):
            report = self.report(frustum(sizes_are=sizes), "--check")
            for length, radius in zip(report["transition"]["perimeters"], (150, 100)):
                self.assertAlmostEqual(length, 2 * math.pi * (radius + off), places=6)

    def test_square_to_round_has_triangles_and_cones(self):
        report = self.report(square_to_round(press_lines={"count": 8}))
        kinds = [patch["kind"] for patch in report["transition"]["patches"]]
        self.assertEqual(sorted(kinds), ["cone"] * 4 + ["plane"] * 4)
        self.assertEqual(len(report["transition"]["press_lines"]), 32)
        turned = sum(row["angle"] for row in report["transition"]["press_lines"])
        self.assertAlmostEqual(turned, sum(patch["turn"] for patch in report["transition"]["patches"]), places=6)
        triangle = 0.5 * 300 * math.hypot(250, 50)
        planes = [patch["area"] for patch in report["transition"]["patches"] if patch["kind"] == "plane"]
        for area in planes:
            self.assertAlmostEqual(area, triangle, places=6)
        self.assertAlmostEqual(report["verification"]["explained_ratio"], 1.0, places=5)
        corners = {row["from"] for row in report["transition"]["true_lengths"]}
        self.assertTrue({"A", "B", "C", "D"} <= corners)

    def test_unfolding_the_solid_gives_the_net_without_its_tips(self):
        net = self.report(square_to_round(), "-o", "part.step", "--flat", "net.dxf")
        self.run_cli("unfold", "part.step", "--k", "0.5", "--json", "again.json", "-o", "again.dxf")
        again = self.json("again.json")
        self.assertAlmostEqual(again["verification"]["volume_ratio"], 1.0, places=6)
        missing = net["flat"]["area"] - again["flat"]["area"]
        self.assertGreater(missing, 0.0)
        self.assertLess(missing, 50.0)  # four tips of a thickness or three each
        wanted = net["flat"]["area"] * net["verification"]["volume_ratio"] ** -1
        self.assertAlmostEqual(again["flat"]["area"] / wanted, 1.0, places=6)

    def test_pieces_have_files_of_their_own(self):
        report = self.report(square_to_round(pieces=2), "--flat", "net.dxf")
        self.assertEqual(self.names(), ["net-1.dxf", "net-2.dxf", "report.json", "spec.json"])
        whole = report["transition"]["area"]
        self.assertAlmostEqual(sum(piece["flat"]["area"] for piece in report["pieces"]) / whole, 1.0, places=9)
        report = self.report(square_to_round(pieces="per_side"), "--check")
        self.assertEqual(len(report["pieces"]), 4)

    def test_surface_as_a_mesh(self):
        self.report(frustum(), "-o", "part.obj", "-o", "part.stl")
        lines = (self.dir / "part.obj").read_text().splitlines()
        points = [[float(x) for x in line.split()[1:]] for line in lines if line.startswith("v ")]
        facets = [[int(x) - 1 for x in line.split()[1:]] for line in lines if line.startswith("f ")]
        area = 0.0
        for a, b, c in ([points[i] for i in facet] for facet in facets):
            u, v = [[q - p for p, q in zip(a, other)] for other in (b, c)]
            area += 0.5 * math.dist((u[1] * v[2], u[2] * v[0], u[0] * v[1]), (u[2] * v[1], u[0] * v[2], u[1] * v[0]))
        exact = math.pi * 250 * math.hypot(200, 50)
        self.assertLess(abs(area / exact - 1), 2e-3)

    def test_k_and_units(self):
        report = self.report(frustum(sizes_are="inside", units="inch"), "--k", "0.4", "--check")
        self.assertEqual(report["units"], "inch")
        self.assertAlmostEqual(report["transition"]["perimeters"][0], 2 * math.pi * 150.8, places=6)

    def test_examples_have_nets(self):
        for example in sorted(EXAMPLES.glob("*.json")):
            self.run_cli("transition", str(example), "--flat", "net.svg", "--json", "report.json")
            self.assertIn(self.json("report.json")["status"], ("ok", "warning"), example.name)


class Refusals(TransitionTest):
    def test_profiles_without_a_transition(self):
        lying = frustum()
        lying["to"]["frame"] = {"origin": [400, 0, 0]}
        self.assertIn("[profiles_meet]", self.sentence(lying))
        through = frustum()
        through["to"]["frame"] = {"origin": [0, 0, 50], "normal": [1, 0, 0]}
        self.assertIn("[profile_hidden]", self.sentence(through))
        arrow = square_to_round()
        arrow["from"]["profile"]["polygon"][2] = [-100, -100]
        self.assertIn("spec.json/from/profile/polygon/2", self.sentence(arrow))
        self.assertIn("[radius_too_small]", self.sentence(frustum(thickness=250, sizes_are="outside")))

    def test_seams_and_sizes_that_do_not_exist(self):
        self.assertIn("spec.json/seam/edge", self.sentence(square_to_round(seam={"edge": 4}), 3))
        self.assertIn("spec.json/seam/corner", self.sentence(frustum(seam={"corner": 0}), 3))
        flat = frustum()
        flat["to"]["profile"]["circle"]["radius"] = 0
        self.assertIn("/to/profile/circle/radius", self.sentence(flat, 3))
        crossed = square_to_round()
        crossed["from"]["profile"]["polygon"] = [[0, 0], [100, 100], [100, 0], [0, 100]]
        self.assertIn("[self_crossing]", self.sentence(crossed, 3))

    def test_keys(self):
        self.assertIn("/pices", self.sentence(frustum(pices=2), 3))
        self.assertIn("/pieces", self.sentence(frustum(pieces=3), 3))
        both = frustum()
        both["from"]["profile"]["ellipse"] = {"rx": 1, "ry": 2}
        self.assertIn("/from/profile", self.sentence(both, 3))
        self.refused("transition", "missing.json", "--check", status=3)


if __name__ == "__main__":
    main()
