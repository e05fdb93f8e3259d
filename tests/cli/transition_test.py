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
        self.assertAlmostEqual(report["verification"]["explained_ratio"], 1.0, places=8)
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

    def test_unfolding_takes_the_solid_of_every_example_back(self):
        for example in sorted(EXAMPLES.glob("*.json")):
            with self.subTest(example.name):
                self.run_cli("transition", str(example), "-o", "part.step", "--flat", "net.dxf", "--json", "net.json")
                net = self.json("net.json")
                pieces = net.get("pieces", [net])
                for number, piece in enumerate(pieces, 1):
                    solid = "part.step" if len(pieces) == 1 else f"part-{number}.step"
                    # Square edges that meet in a fold of the seam are an error of a part whose seam nobody names.
                    anyway = ["--write-anyway"] * any(check["code"] == "seam_edges" for check in piece["checks"])
                    self.run_cli("unfold", solid, "--k", "0.5", "--json", "again.json", "-o", "again.dxf", *anyway)
                    again = self.json("again.json")
                    self.assertIn(again["status"], ("ok", "warning"))
                    self.assertAlmostEqual(piece["verification"]["explained_ratio"], 1.0, places=6)
                    if any(bend["kind"] == "sharp" for bend in piece["flat"]["bends"]):
                        continue  # folds, for which unfold allows what K says
                    # What is cut off at corners and the open seam, and both volumes, which are measured.
                    missing = piece["flat"]["area"] * (1.0 - 1.0 / piece["verification"]["volume_ratio"])
                    self.assertAlmostEqual(again["flat"]["area"] / (piece["flat"]["area"] - missing), 1.0, places=6)
                    seam_only = missing < 0.011 * max(piece["flat"]["size"])
                    for old, new in zip(piece["flat"]["size"], again["flat"]["size"]):
                        self.assertAlmostEqual(old, new, delta=0.02 if seam_only else 0.01 * old)

    def test_folds_that_meet_in_a_corner(self):
        # A triangle to a heptagon: fans of triangles, whose offset planes do not meet in one point.
        heptagon = [[120 * math.cos(2 * math.pi * (i + 0.3) / 7), 80 * math.sin(2 * math.pi * (i + 0.3) / 7)] for i in range(7)]
        for thickness in (0.1, 1.0, 2.0):
            for seam in ({"edge": 1}, {"corner": 1}):
                report = self.report({"thickness": thickness, "seam": seam,
                                      "from": {"profile": {"polygon": [[-160, -90], [150, -110], [20, 170]]}},
                                      "to": {"profile": {"polygon": heptagon},
                                             "frame": {"origin": [30, -20, 140], "normal": [0.2, 0.1, 1]}}})
                self.assertAlmostEqual(report["verification"]["explained_ratio"], 1.0, delta=2e-6 * max(1.0, thickness) ** 2)

    def test_a_seam_in_a_fold_is_told_and_one_in_a_panel_is_not(self):
        spec = {"thickness": 5, "from": {"profile": {"polygon": [[-28, -36], [63, 1], [2, 36], [-63, 10]]}},
                "to": {"profile": {"polygon": [[-168, 77], [-95, -119], [9, -147], [164, -24], [103, 70], [-38, 151]]},
                       "frame": {"origin": [0, 0, 124], "normal": [-0.46, 0.41, 1], "x": [1, 0, 0.46]}}}
        for seam, expected in ({"corner": 3}, [("seam_edges", "info")]), ({"edge": 0}, []):
            with self.subTest(seam):
                checks = self.report(dict(spec, seam=seam), "--check")["checks"]
                self.assertEqual([(c["code"], c["severity"]) for c in checks
                                  if c["code"] in ("seam_edges", "self_intersection")], expected)

    def test_a_net_that_overlaps_itself_is_not_written(self):
        flat = {"thickness": 0.5, "seam": {"corner": 2},
                "from": {"profile": {"polygon": [[137, 93], [80, 134], [-129, 101], [-162, 53], [-142, -87], [-22, -150], [170, -28]]}},
                "to": {"profile": {"polygon": [[10, 87], [-77, 6], [3, -87]]}, "frame": {"origin": [-44.5, 33.1, 3]}}}
        self.assertIn("[overlap]", self.refused("transition", self.spec(flat), "--flat", "net.dxf", status=4))
        self.assertEqual(self.names(), ["spec.json"])
        self.run_cli("transition", self.spec(dict(flat, seam={"corner": 0})), "--flat", "net.dxf")

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

    def test_a_cylinder_and_a_flat_cone_turn_all_round(self):
        cylinder = frustum()
        cylinder["to"]["profile"]["circle"]["radius"] = 150
        low = frustum()
        low["to"]["frame"]["origin"] = [0, 0, 1]
        for spec in (cylinder, low):
            report = self.report(spec)
            self.assertAlmostEqual(report["flat"]["bends"][0]["angle"], 360.0, places=6)
            self.assertAlmostEqual(report["verification"]["explained_ratio"], 1.0, places=6)

    def test_hinges_take_no_allowance(self):
        self.run_cli("transition", str(EXAMPLES / "i_twisted_square_to_square.json"), "--check", "--json", "report.json")
        report = self.json("report.json")
        for bend in report["flat"]["bends"]:
            self.assertEqual(bend["allowance"], 0.0)
            outside = 0.5 * report["sheet"]["thickness"]
            self.assertAlmostEqual(bend["deduction"], 2 * outside * math.tan(math.radians(bend["angle"]) / 2), places=9)

    def test_true_lengths_name_their_press_lines(self):
        report = self.report(square_to_round(press_lines={"count": 5}, pieces=2), "--flat", "net.svg")
        lines = {(row["piece"], row["id"]): row["line"] for row in report["transition"]["press_lines"]}
        named = {(row["piece"], row["press_line"]): row for row in report["transition"]["true_lengths"] if row["press_line"]}
        self.assertEqual(set(lines), set(named))
        for key, line in lines.items():
            self.assertAlmostEqual(math.dist(*line), named[key]["length"], places=6)
        drawn = (self.dir / "net-1.svg").read_text()
        for text in ("B", "C", "1", "2&apos;" if "&apos;" in drawn else "2'"):
            self.assertTrue(f">{text}</text>" in drawn, text)

    def test_k_and_units(self):
        report = self.report(frustum(sizes_are="inside", units="inch"), "--k", "0.4", "--check")
        self.assertEqual(report["units"], "inch")
        self.assertAlmostEqual(report["transition"]["perimeters"][0], 2 * math.pi * 150.8, places=6)

    def test_k_comes_from_the_command_then_the_file(self):
        for content, options, k, source in ((square_to_round(k_factor=0.4), [], 0.4, "transition file"),
                                            (square_to_round(k_factor=0.4), ["--k", "0.3"], 0.3, "constant"),
                                            (square_to_round(), [], 0.5, "default")):
            report = self.report(content, *options)
            bends = report["flat"]["bends"]
            self.assertTrue(bends)
            self.assertEqual({(bend["k_factor"], bend["k_source"]) for bend in bends}, {(k, source)})

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

    def test_more_than_can_be_pressed_or_folded(self):
        for lines in ({"count": 1000000000}, {"max_angle": 1e-6}, {"chord": 1e-9}):
            self.assertIn("spec.json/press_lines", self.sentence(square_to_round(press_lines=lines), 3))
        thick = self.spec(square_to_round(thickness=90))
        self.assertIn("[radius_too_small]", self.refused("transition", thick, "-o", "part.step", status=4))
        self.assertEqual(self.names(), ["spec.json"])
        # The net needs no solid.
        self.run_cli("transition", thick, "-o", "part.step", "--flat", "net.dxf", "--json", "report.json")
        self.assertEqual(self.names(), ["net.dxf", "report.json", "spec.json"])
        report = self.json("report.json")
        self.assertIn("folded_solid", [check["code"] for check in report["checks"]])
        self.assertIsNone(report["verification"]["explained_ratio"])

    def test_directions_that_are_none(self):
        leaning = frustum()
        leaning["to"]["frame"]["x"] = [0, 0, 1]
        self.assertIn("/to/frame/x", self.sentence(leaning, 3))

    def test_keys(self):
        self.assertIn("/pices", self.sentence(frustum(pices=2), 3))
        self.assertIn("/pieces", self.sentence(frustum(pieces=3), 3))
        both = frustum()
        both["from"]["profile"]["ellipse"] = {"rx": 1, "ry": 2}
        self.assertIn("/from/profile", self.sentence(both, 3))
        self.refused("transition", "missing.json", "--check", status=3)


if __name__ == "__main__":
    main()
