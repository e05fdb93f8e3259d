"""The package `planish` for Python: the same as the program, arrays, errors, progress, threads."""

import copy
import gc
import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import weakref
from xml.etree import ElementTree

sys.path.insert(0, os.environ.get("PLANISH_PYTHON_FOLDER", "build/release/python"))
sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))

import numpy as np  # noqa: E402
import planish  # noqa: E402
import planish_cli  # noqa: E402
import step_files  # noqa: E402

EXAMPLES = planish_cli.SOURCE / "examples"
BRACKET = EXAMPLES / "bracket.step"
SQUARE_TO_ROUND = EXAMPLES / "transition/a_square_to_round.json"
MAKERS = {"connect": planish.connect, "transition": planish.transition, "slit": planish.slit}


def shoelace(ring):
    x, y = ring.T
    return float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum()) / 2


def inputs():
    yield "unfold", planish.unfold, BRACKET
    for name, make in MAKERS.items():
        for path in sorted((EXAMPLES / name).glob("*.json")):
            yield name, make, path


class PythonTest(planish_cli.CliTest):
    pass


class SameAsTheProgram(PythonTest):
    def test_every_example_byte_for_byte(self):
        count = 0
        for command, make, path in inputs():
            with self.subTest(path.name):
                part = make(path)
                folded = [] if command == "unfold" else ["-o", "folded.step"]
                flat = "-o" if command == "unfold" else "--flat"
                self.run_cli(command, path, flat, "flat.dxf", flat, "flat.svg", *folded, "--json", "report.json", "-q")
                report = self.json("report.json")
                report["files"] = []
                self.assertEqual(part.to_dict(), report)
                if part._made.pieces == 1:
                    self.assertEqual(part.artifact("dxf"), (self.dir / "flat.dxf").read_bytes())
                    self.assertEqual(part.artifact("svg"), (self.dir / "flat.svg").read_bytes())
                    if folded and "step" in part.formats:
                        self.assertEqual(part.artifact("step"), (self.dir / "folded.step").read_bytes())
                    count += 1
                for written in self.dir.iterdir():
                    written.unlink()
        self.assertGreater(count, 20)

    def test_options_are_those_of_the_program(self):
        part = planish.unfold(BRACKET, k=0.33, units="inch", bend_k={"B1": 0.5}, up="other", no_rules=True,
                              rip_width=np.float64(0.2))
        self.run_cli("unfold", BRACKET, "--k", "0.33", "--units", "inch", "--bend-k", "B1=0.5", "--up", "other",
                     "--no-rules", "--rip-width", "0.2", "-o", "x.dxf", "--json", "x.json", "-q")
        self.assertEqual(part.to_dict()["flat"], self.json("x.json")["flat"])
        part.write(self.dir / "y.dxf")
        self.assertEqual((self.dir / "y.dxf").read_bytes(), (self.dir / "x.dxf").read_bytes())
        self.run_cli("unfold", BRACKET, "--k", "0.33", "--units", "inch", "--bend-k", "B1=0.5", "--up", "other",
                     "--no-rules", "-o", "x.dxf", "--profile", "inventor", "--r12", "-q")
        part.write(self.dir / "y.dxf", profile="inventor", r12=True)
        self.assertEqual((self.dir / "y.dxf").read_bytes(), (self.dir / "x.dxf").read_bytes())

    def test_a_bend_plan(self):
        plan = planish.bend(BRACKET, metal="stainless")
        self.run_cli("bend", BRACKET, "--material", "stainless", "-o", "x.svg", "-o", "x.pdf", "--json", "x.json", "-q")
        report = self.json("x.json")
        report["files"] = []
        self.assertEqual(plan.to_dict(), report)
        plan.write(self.dir / "y.svg")
        plan.write(self.dir / "y.pdf")
        self.assertEqual((self.dir / "y.svg").read_bytes(), (self.dir / "x.svg").read_bytes())
        self.assertEqual((self.dir / "y.pdf").read_bytes(), (self.dir / "x.pdf").read_bytes())
        self.run_cli("bend", BRACKET, "--material", "stainless", "--as-made", "x.dxf", "-q")
        as_made = planish.bend(BRACKET, metal="stainless", as_made=True)
        self.assertEqual(as_made.write_as_made(self.dir / "y.dxf"), [self.dir / "y.dxf"])
        with self.assertRaises(planish.InvalidInput):
            plan.write_as_made(self.dir / "z.dxf")
        self.assertEqual((self.dir / "y.dxf").read_bytes(), (self.dir / "x.dxf").read_bytes())
        self.assertEqual([stroke.bends[0] for stroke in plan.plan.strokes], ["B1", "B2"])
        self.assertEqual(planish.bend(self.angle()).report.command, "bend")
        self.assertEqual(planish.bend(BRACKET.read_bytes()).plan.status, "optimal")
        fixed = planish.bend(BRACKET, fix=["B2", "B1"], weights={"turn_over": 10}, first=True)
        self.assertEqual([stroke.bends[0] for stroke in fixed.plan.strokes], ["B2", "B1"])
        with self.assertRaises(planish.Refused) as caught:
            planish.bend(EXAMPLES / "connect/a_folded.json", clearance=100)
        self.assertEqual(caught.exception.code, "cannot_bend")
        self.assertEqual(caught.exception.part.plan.status, "infeasible")

    def test_what_a_file_holds(self):
        self.run_cli("info", BRACKET, "--json", "info.json")
        self.assertEqual(planish.info(BRACKET).to_dict(), self.json("info.json"))
        self.assertEqual(planish.info(BRACKET, sheets=True).bodies[0].sheet.bends, 2)

    def test_a_batch(self):
        (self.dir / "parts").mkdir()
        for number in range(3):
            self.angle(f"parts/{number}.step", leg=40.0 + number)
        self.write("parts/damaged.step", "ISO-10303-21;")
        told = []
        summary = planish.batch(self.dir / "parts", self.dir / "out", jobs=2, k=0.4,
                                progress=lambda stage, share: told.append(share))
        subprocess.run([planish_cli.CLI, "batch", "parts", "-o", "other", "--k", "0.4"], cwd=self.dir, check=True,
                       capture_output=True)
        self.assertEqual(summary.to_dict(), self.json("other/summary.json"))
        self.assertEqual(told[-1], 1.0)
        self.assertEqual(told, sorted(told))
        with self.assertRaises(planish.InvalidInput) as caught:
            planish.batch(self.dir / "nowhere", self.dir / "out2")
        self.assertEqual(caught.exception.code, "cannot_read")

    def test_a_pack(self):
        self.angle("a.step")
        files = planish.pack(self.dir / "a.step", self.dir / "shop", zip=True)
        names = [file.name for file in files]
        self.assertIn("pack.zip", names)
        self.assertTrue(any(name.endswith(".dxf") for name in names), names)


class Inputs(PythonTest):
    def test_bytes_paths_and_texts(self):
        area = planish.unfold(str(BRACKET)).flat.area
        content = BRACKET.read_bytes()
        for given in (content, bytearray(content), memoryview(content)):
            self.assertEqual(planish.unfold(given, name="b.step").flat.area, area)
        self.assertEqual(planish.unfold(content, name="b.step").report.input, "b.step")
        self.assertEqual(planish.unfold(content.decode()).flat.area, area)

    def test_dictionaries(self):
        for name, make in MAKERS.items():
            path = sorted((EXAMPLES / name).glob("*.json"))[0]
            given = json.loads(path.read_text())
            before = copy.deepcopy(given)
            self.assertEqual(make(given).to_dict()["flat"], make(path).to_dict()["flat"])
            self.assertEqual(given, before, "the dictionary is left as it was")
        rules = {"k_low": 0.45}
        codes = [finding.code for finding in planish.unfold(BRACKET, k=0.44, rules=rules).checks]
        self.assertIn("k_factor", " ".join(codes))

    def test_arrays_of_numpy_in_a_dictionary(self):
        given = json.loads((EXAMPLES / "connect/a_folded.json").read_text())
        plain = planish.connect(given).flat.area
        for plate in given["plates"]:
            plate["outline"] = np.array(plate["outline"])
        self.assertEqual(planish.connect(given).flat.area, plain)

    def test_shapes_of_other_libraries(self):
        class Shape:  # as FreeCAD's and CadQuery's hand themselves over
            def __init__(self, data):
                self.data = data

            def exportBrep(self, stream):
                stream.write(self.data)

        class Workplane:
            def __init__(self, shape):
                self.shape = shape

            def val(self):
                return self.shape

        area = planish.unfold(BRACKET).flat.area
        for given in (Shape(BRACKET.read_bytes()), Workplane(Shape(BRACKET.read_bytes()))):
            self.assertEqual(planish.unfold(given).flat.area, area)
        with self.assertRaisesRegex(TypeError, "int"):
            planish.unfold(3)


class Arrays(PythonTest):
    def test_have_the_area_of_the_report(self):
        for command, make, path in inputs():
            for flat in make(path).flats:
                with self.subTest(path.name):
                    fine = flat.polygons(1e-5)
                    area = shoelace(fine.outline) + sum(map(shoelace, fine.openings))
                    self.assertAlmostEqual(area, flat.area, delta=1e-5 * flat.perimeter)
                    length = sum(float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())
                                 for line in [fine.outline, *fine.openings, *fine.slits])
                    self.assertAlmostEqual(length, flat.perimeter, delta=1e-4 * flat.perimeter)

    def test_are_in_the_unit_of_the_report(self):
        mm, inch = planish.unfold(BRACKET).flat, planish.unfold(BRACKET, units="inch").flat
        np.testing.assert_allclose(inch.outline * 25.4, mm.outline, atol=1e-9)
        np.testing.assert_allclose(inch.bends[0].lines * 25.4, mm.bends[0].lines, atol=1e-9)

    def test_shapes_types_and_senses(self):
        flat = planish.unfold(BRACKET).flat
        for ring in [flat.outline, *flat.openings]:
            self.assertEqual((ring.dtype, ring.ndim, ring.shape[1]), (np.float64, 2, 2))
            np.testing.assert_array_equal(ring[0], ring[-1])
        self.assertGreater(shoelace(flat.outline), 0)
        self.assertTrue(all(shoelace(ring) < 0 for ring in flat.openings))
        self.assertEqual(flat.bends[0].lines.shape, (1, 4))
        start, end = flat.bends[0].line
        np.testing.assert_allclose(flat.bends[0].lines[0], [*start, *end], atol=1e-9)

    def test_are_views_that_keep_what_they_show_and_cannot_be_changed(self):
        part = planish.unfold(BRACKET)
        made, outline = weakref.ref(part), part.flat.outline
        mesh = part.mesh().points
        values, corners = outline.copy(), mesh.copy()
        self.assertFalse(outline.flags.owndata)
        self.assertFalse(mesh.flags.owndata)
        with self.assertRaises(ValueError):
            outline[0, 0] = 1.0
        del part
        gc.collect()
        self.assertIsNone(made())
        for _ in range(20):
            planish.unfold(BRACKET)
        np.testing.assert_array_equal(outline, values)
        np.testing.assert_array_equal(mesh, corners)
        again = planish.unfold(BRACKET)
        self.assertIs(again.flat, again.flat)

    def test_a_mesh_is_closed_and_has_the_volume_of_the_solid(self):
        part = planish.unfold(BRACKET)
        mesh = part.mesh()
        a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
        self.assertAlmostEqual(float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6, part.sheet.volume,
                               delta=2e-3 * part.sheet.volume)

    def test_shapely_takes_a_pattern_for_a_polygon(self):
        from shapely.geometry import shape
        flat = planish.unfold(BRACKET).flat.polygons(1e-5)
        polygon = shape(flat)
        self.assertTrue(polygon.is_valid)
        self.assertEqual(len(polygon.interiors), len(flat.openings))
        self.assertAlmostEqual(polygon.area, flat.area, delta=1e-2)

    def test_exact_curves(self):
        curves = planish.unfold(BRACKET).flat.curves()
        radii = sorted(curve[2] for opening in curves["openings"] for curve in opening if len(curve) == 5)
        self.assertGreaterEqual(len(radii), 2)
        self.assertAlmostEqual(radii[0], 3.3, delta=1e-6)

    def test_pieces(self):
        given = json.loads(SQUARE_TO_ROUND.read_text())
        given["pieces"] = 2
        part = planish.transition(given)
        self.assertEqual(len(part.flats), 2)
        self.assertEqual([flat.area for flat in part.flats], [piece.flat.area for piece in part.pieces])
        with self.assertRaisesRegex(planish.InvalidInput, "2 pieces"):
            part.flat
        written = part.write(self.dir / "net.dxf")
        self.assertEqual([path.name for path in written], ["net-1.dxf", "net-2.dxf"])
        self.assertEqual(self.names(), ["net-1.dxf", "net-2.dxf"])


class Errors(PythonTest):
    def test_are_of_three_kinds(self):
        with self.assertRaises(planish.InvalidInput) as caught:
            planish.unfold(self.dir / "nothing.step")
        self.assertEqual(caught.exception.code, "cannot_read")
        self.assertIn("nothing.step", caught.exception.message)
        with self.assertRaises(planish.InvalidInput) as caught:
            planish.unfold(BRACKET, k=1.5)
        self.assertEqual(caught.exception.where, "k")
        self.assertIn("k must be a number from 0 to 1, not 1.5", caught.exception.message)
        with self.assertRaises(planish.InvalidInput) as caught:
            planish.unfold(BRACKET, bend_k={"B9": 0.4})
        self.assertIn("B9", caught.exception.message)
        with self.assertRaises(planish.InvalidInput) as caught:
            planish.unfold(BRACKET, k=0.4, din6935=True)
        self.assertEqual(caught.exception.where, "din6935")
        self.assertIn("`k` and `din6935` each say where K comes from", caught.exception.message)
        with self.assertRaises(planish.InvalidInput):
            planish.unfold(b"solid cube")
        with self.assertRaises(planish.InvalidInput):
            planish.unfold(b"")
        with self.assertRaises(ValueError):
            planish.connect({"format": "planish/plates"})
        with self.assertRaises(TypeError):
            planish.unfold(BRACKET, colour="red")

    def test_name_what_is_wrong(self):
        plates = json.loads((EXAMPLES / "connect/a_folded.json").read_text())
        plates["plates"][0]["outline"][0][0] = float("nan")
        for wrong, sentence in (
                (lambda: planish.connect(plates), "/plates/0/outline/0/0 is nan"),
                (lambda: planish.unfold(BRACKET, rules={"k_lo": 1}), "k_lo is not a known key"),
                (lambda: planish.unfold(BRACKET, k_table="missing.csv"), "missing.csv"),
                (lambda: planish.schema("nothing"), "there are .*plates"),
                (lambda: planish.batch([], self.dir / "out"), "input is required"),
                (lambda: planish.batch(BRACKET, self.dir / "out", formats="png"), "png is unknown"),
                (lambda: planish.batch(BRACKET, self.dir / "out", wrong=1), "no option --wrong"),
                (lambda: planish.pack(self.dir / "nowhere", self.dir / "out"), "no file or folder"),
                (lambda: planish.connect(BRACKET), "it is a STEP file")):
            with self.assertRaisesRegex(planish.InvalidInput, sentence):
                wrong()

    def test_a_refusal_brings_what_is_known(self):
        with self.assertRaises(planish.Refused) as caught:
            planish.unfold(self.write("thick.step", step_files.block()))
        self.assertEqual(caught.exception.code, caught.exception.part.report.reason.code)
        self.assertEqual(caught.exception.part.status, "refused")
        with self.assertRaises(planish.Refused):
            caught.exception.part.write(self.dir / "x.dxf")
        caught.exception.part.write(self.dir / "x.json")
        self.assertEqual(self.names(), ["thick.step", "x.json"])

    def test_files_are_written_whole_or_not_at_all(self):
        part = planish.unfold(BRACKET)
        with self.assertRaises(planish.InvalidInput) as caught:
            part.write(self.dir / "missing" / "x.dxf")
        self.assertEqual(caught.exception.code, "cannot_write")
        for name in ("x", "x.png"):
            with self.assertRaises(planish.InvalidInput):
                part.write(self.dir / name)
        with self.assertRaises(planish.InvalidInput):
            part.write(self.dir / "x.dxf", splines="wobbly")
        self.assertEqual(self.names(), [])

    def test_cross_from_a_listener(self):
        class Mine(Exception):
            pass

        def listener(stage, share):
            raise Mine(stage)

        with self.assertRaises(Mine):
            planish.unfold(BRACKET, progress=listener)
        with self.assertRaises(planish.Cancelled) as caught:
            planish.unfold(BRACKET, progress=lambda stage, share: False)
        self.assertEqual(caught.exception.code, "cancelled")

    def test_ctrl_c_ends_long_work(self):
        given = json.loads((EXAMPLES / "slit/arch.json").read_text())
        main = threading.main_thread().ident
        timer = threading.Timer(0.15, signal.pthread_kill, (main, signal.SIGINT))
        timer.start()
        started = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            while time.monotonic() - started < 60:
                planish.slit(given)
        timer.join()

    def test_progress_tells_stages(self):
        told = []
        planish.unfold(BRACKET, progress=lambda stage, share: told.append((stage, share)))
        self.assertGreater(len(told), 1)
        self.assertTrue(all(isinstance(stage, str) and 0 <= share <= 1 for stage, share in told), told)


class Reports(PythonTest):
    def test_are_read_by_attributes_and_keys(self):
        part = planish.unfold(BRACKET)
        self.assertEqual(part.flat.area, part.report["flat"]["area"])
        self.assertAlmostEqual(part.sheet.thickness, 2.0)
        self.assertEqual(part.report.flat.bends[0].id, "B1")
        self.assertIn("flat", dir(part.report))
        with self.assertRaisesRegex(AttributeError, "it has .*flat"):
            part.report.nothing
        with self.assertRaises(AttributeError):
            part.report.status = "fine"
        changed = part.to_dict()
        changed["flat"]["area"] = 0
        self.assertNotEqual(part.flat.area, 0)
        self.assertEqual(pickle.loads(pickle.dumps(part.report)), part.report)
        self.assertEqual(copy.deepcopy(part.report), part.report)
        self.assertIn("bracket", repr(part))

    def test_a_notebook_shows_the_pattern(self):
        part = planish.unfold(BRACKET)
        self.assertEqual(ElementTree.fromstring(part._repr_svg_()).tag, "{http://www.w3.org/2000/svg}svg")
        self.assertTrue(part._repr_svg_().startswith("<svg"), "it becomes part of a page")
        self.assertTrue(part.artifact("svg").decode().endswith(part._repr_svg_()))
        self.assertEqual(part.flat._repr_svg_(), part._repr_svg_())

    def test_schemas(self):
        import jsonschema
        jsonschema.validate(planish.unfold(BRACKET).to_dict(), json.loads(planish.schema("report")))
        self.assertIn("plates", planish.schema_names())


class Threads(PythonTest):
    def test_eight_at_once(self):
        quick = [(make, path) for _, make, path in inputs()][::6]
        makes, paths = [make for make, _ in quick], [path for _, path in quick]
        expected = [make(path).artifact("svg") if make(path)._made.pieces == 1 else None
                    for make, path in zip(makes, paths)]
        found, failed = {}, []

        def work(first):
            try:
                for i in range(first, first + len(paths)):
                    row = i % len(paths)
                    part = makes[row](paths[row])
                    if expected[row] is not None and part.artifact("svg") != expected[row]:
                        failed.append(paths[row])
                    found[first, row] = part.flats[0].outline.sum()
            except Exception as error:  # noqa: BLE001
                failed.append(error)

        threads = [threading.Thread(target=work, args=(3 * number,)) for number in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failed, [])
        self.assertEqual(len(found), 8 * len(paths))

    def test_one_part_is_shared(self):
        part = planish.unfold(BRACKET)
        answers = []

        def work():
            answers.append((part.artifact("dxf"), part.flat.outline.tobytes(), part.artifact("flat.step")))

        threads = [threading.Thread(target=work) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(set(answers)), 1)

    def test_others_run_meanwhile(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)

        ticking = threading.Thread(target=tick)
        ticking.start()
        planish.slit(sorted((EXAMPLES / "slit").glob("*.json"))[0])
        done.set()
        ticking.join()
        self.assertGreater(len(ticks), 5)


if __name__ == "__main__":
    unittest.main()
