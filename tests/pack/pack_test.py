#!/usr/bin/python3
"""Packs: what goes to the shop is complete, counted right and the same each time."""

import csv
import io
import json
import math
import pathlib
import signal
import subprocess
import sys
import zipfile

import ezdxf

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
import planish_cli  # noqa: E402
import step_files  # noqa: E402
from planish_cli import CLI, SECONDS, main  # noqa: E402

DEPTH, THICKNESS, RADIUS, K = 60.0, 2.0, 2.0, 0.44


def flat_length(leg):
    return 2 * (leg - THICKNESS - RADIUS) + math.pi / 2 * (RADIUS + K * THICKNESS)


class PackTest(planish_cli.CliTest):
    def pack(self, *arguments, status=0):
        done = subprocess.run([CLI, "pack", *map(str, arguments)], cwd=self.dir,
                              capture_output=True, text=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def sentence(self, *arguments, status):
        done = subprocess.run([CLI, "pack", *map(str, arguments)], cwd=self.dir,
                              capture_output=True, text=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"^planish: [^\n]+\n$")
        return done.stderr

    def named(self, file, **sizes):
        self.write(file, step_files.angle(**sizes))

    def table(self, out="out", name="parts.csv"):
        return list(csv.DictReader(io.StringIO((self.dir / out / name).read_text())))

    def parts(self, out="out"):
        return [row for row in self.table(out) if row["file"] not in ("", "total")]

    def files(self, out="out"):
        root = self.dir / out
        return {str(path.relative_to(root)): path.read_bytes() for path in root.rglob("*")
                if path.is_file() and ".planish-pack" not in path.parts}


class Parts(PackTest):
    def test_the_list_holds_what_drives_the_price(self):
        self.angle("bracket.step", leg=50.0)
        self.pack("bracket.step", "-o", "out", "--density", "7.85")
        (row,) = self.parts()
        length = flat_length(50.0)
        self.assertEqual(row["file"], "angle_2mm_x1")
        self.assertEqual((row["part"], row["material"], row["quantity"]), ("angle", "unknown", "1"))
        expected = {"thickness": 2.0, "length": max(length, DEPTH), "width": min(length, DEPTH),
                    "area": length * DEPTH, "cut_length": 2 * (length + DEPTH), "pierces": 1,
                    "bends": 1, "bend_length": DEPTH}
        for key, value in expected.items():
            self.assertAlmostEqual(float(row[key]), value, msg=key, delta=6e-6 * value)
        # The bend holds its material at the middle of the thickness.
        volume = (2 * (50.0 - 4.0) + math.pi / 2 * 3.0) * THICKNESS * DEPTH
        self.assertAlmostEqual(float(row["mass"]), 7.85e-6 * volume, 3)
        self.assertEqual((row["plan"], row["status"]), ("can be bent", "ok"))
        self.assertEqual(row["sources"], "bracket.step: angle")

    def test_patterns_are_those_of_unfold(self):
        self.angle("bracket.step")
        self.run_cli("unfold", "bracket.step", "-o", "alone.dxf", "-q", "--profile", "inventor",
                     "--units", "inch", "--check-bending")
        self.pack("bracket.step", "-o", "out", "--profile", "inventor", "--units", "inch")
        self.assertEqual((self.dir / "out" / "angle_2mm_x1.dxf").read_bytes(),
                         (self.dir / "alone.dxf").read_bytes())

    def test_identical_parts_are_merged_with_their_quantities(self):
        (self.dir / "in").mkdir()
        self.write("in/a.step", step_files.two_angles_and_a_block())
        self.named("in/b.step", name="other name")
        self.angle("in/c.step", leg=50.01)
        self.pack("in", "-o", "out")
        rows = {row["file"]: row for row in self.parts()}
        self.assertEqual({name: row["quantity"] for name, row in rows.items()},
                         {name: name.rsplit("_x", 1)[1] for name in rows})
        self.assertEqual(sorted(int(row["quantity"]) for row in rows.values()), [1, 1, 3])
        # The file holds two of these angles, one of 1.5 mm and a block besides.
        total = [row for row in self.table() if row["file"] == "total"]
        self.assertEqual([row["quantity"] for row in total], ["1", "4", "5"])
        self.assertEqual([row["thickness"] for row in total], ["1.5", "2", ""])
        area = 3 * flat_length(50.0) * DEPTH + flat_length(50.01) * DEPTH
        self.assertAlmostEqual(float(total[1]["area"]), area, delta=6e-6 * area)
        door = (2 * (40.0 - 4.5) + math.pi / 2 * (3.0 + K * 1.5)) * 25.0
        self.assertAlmostEqual(float(total[2]["area"]), area + door, delta=6e-6 * area)
        self.assertEqual(len(list((self.dir / "out").glob("*.dxf"))), 3)
        self.assertEqual(len(list((self.dir / "out").glob("*.pdf"))), 4)

    def test_parts_of_one_name_are_numbered(self):
        (self.dir / "in").mkdir()
        for i, leg in enumerate((50.0, 60.0, 70.0)):
            self.named(f"in/{i}.step", leg=leg, name="Angle" if i else "angle")
        self.pack("in", "-o", "out", "--no-drawings")
        names = sorted(path.name.lower() for path in (self.dir / "out").glob("*.dxf"))
        self.assertEqual(names, ["angle-2_2mm_x1.dxf", "angle-3_2mm_x1.dxf",
                                 "angle_2mm_x1.dxf"])

    def test_what_is_refused_is_listed(self):
        (self.dir / "in").mkdir()
        self.angle("in/a.step")
        self.write("in/block.step", step_files.block())
        self.write("in/broken.step", "ISO-10303-21;\nHEADER;\n")
        out = self.pack("in", "-o", "out")
        self.assertIn("2 bodies refused", out)
        refused = [row for row in self.table() if row["status"] == "refused"]
        self.assertEqual(sorted(row["sources"].split(":")[0] for row in refused),
                         ["block.step", "broken.step"])
        self.assertTrue(any(row["warnings"].startswith("not_a_sheet: ") for row in refused))
        text = subprocess.run(["pdftotext", "-layout", "out/cover.pdf", "-"], cwd=self.dir,
                              capture_output=True, text=True, check=False)
        if text.returncode == 0:
            self.assertIn("block.step", text.stdout)

    def test_only_refused_parts_make_a_pack_too(self):
        self.write("block.step", step_files.block())
        self.pack("block.step", "-o", "out", "--nest", "100x100", "--zip")
        self.assertEqual([row["status"] for row in self.table()], ["refused"])

    def test_materials_come_from_a_list(self):
        (self.dir / "in").mkdir()
        self.named("in/a.step", name="Left leg")
        self.named("in/b.step", name="right LEG")
        self.named("in/c.step", name="seat")
        self.write("materials.csv", "part;material;density\n*leg;S235;7.85\nseat?;oak;\n")
        self.pack("in", "-o", "out", "--materials", "materials.csv")
        rows = {row["material"]: row for row in self.parts()}
        self.assertEqual(rows["S235"]["quantity"], "2")
        self.assertEqual(rows["unknown"]["part"], "seat")
        self.assertEqual(rows["unknown"]["mass"], "")
        self.assertGreater(float(rows["S235"]["mass"]), 0.0)
        # Unknown comes last; the sum of what is not known is not known.
        self.assertEqual([row["material"] for row in self.table() if row["file"] == "total"],
                         ["S235", "unknown", ""])
        self.assertEqual(self.table()[-1]["mass"], "")

    def test_materials_of_step_files_hold_where_the_list_says_none(self):
        file = step_files.StepFile()
        definition, _ = file.product("angle", file.prism(*step_files.angle_profile(50.0, 2.0, 2.0), DEPTH))
        file.material(definition, "AlMg3", 2660.0)
        self.write("part.step", file.text())
        volume = (2 * (50.0 - 4.0) + math.pi / 2 * 3.0) * THICKNESS * DEPTH

        def packed(table, *options):
            self.write("materials.csv", "part,material,density\n" + table)
            self.pack("part.step", "-o", "out", "--materials", "materials.csv", "--no-drawings",
                      *options)
            (row,) = self.parts()
            return row["material"], float(row["mass"]) if row["mass"] else None

        for table, options, material, density in [
                ("leg,S235,7.85\n", [], "AlMg3", 2.66), ("angle,S235,7.85\n", [], "S235", 7.85),
                ("angle,S235,\n", [], "S235", None), ("angle,AlMg3,\n", [], "AlMg3", 2.66),
                ("angle,S235,\n", ["--density", "8"], "S235", 8.0),
                ("angle,S235,7.85\n", ["--density", "8"], "S235", 7.85)]:
            with self.subTest(table, options=options):
                name, mass = packed(table, *options)
                self.assertEqual(name, material)
                if density is None:
                    self.assertIsNone(mass)
                else:
                    self.assertAlmostEqual(mass, density * 1e-6 * volume, 3)

    def test_a_finished_batch_is_packed_as_it_is(self):
        (self.dir / "in").mkdir()
        self.angle("in/a.step")
        subprocess.run([CLI, "batch", "in", "-o", "flat", "-q", "--check-bending"], cwd=self.dir,
                       check=True, timeout=SECONDS)
        self.pack("flat", "-o", "out")
        self.pack("in", "-o", "direct")
        self.assertEqual((self.dir / "out" / "parts.csv").read_bytes(),
                         (self.dir / "direct" / "parts.csv").read_bytes())
        self.assertFalse((self.dir / "out" / ".planish-pack" / "parts").exists())

    def test_makers_files_are_packed(self):
        plates = {"format": "planish/plates", "version": 1, "thickness": 2.0,
                  "plates": [{"id": "A", "outline": [[0, 0, 0], [200, 0, 0], [200, 100, 0], [0, 100, 0]]},
                             {"id": "B", "outline": [[230, 0, 30], [230, 100, 30], [230, 100, 130],
                                                     [230, 0, 130]]}]}
        self.write("bent.json", json.dumps(plates))
        self.pack("bent.json", "-o", "out")
        (row,) = self.parts()
        self.assertEqual((row["part"], row["bends"], row["pierces"]), ("bent", "1", "1"))


    def test_a_part_with_an_error_is_not_packed_unless_asked(self):
        # A plate that comes back through the bend between the two others.
        plates = {"format": "planish/plates", "version": 1, "thickness": 4.0,
                  "plates": [{"id": "A", "outline": [[0, 0, 0], [200, 0, 0], [200, 100, 0], [0, 100, 0]]},
                             {"id": "B", "outline": [[0, 120, 20], [200, 120, 20], [200, 120, 120], [0, 120, 120]]},
                             {"id": "C", "outline": [[50, 72.4, 109.9], [150, 72.4, 109.9],
                                                     [150, 118.1, -1.1], [50, 118.1, -1.1]]}],
                  "bends": [{"between": ["A", "B"], "inside_radius": 12}, {"between": ["B", "C"]}]}
        self.write("through.json", json.dumps(plates))
        self.angle()
        self.pack("through.json", "part.step", "-o", "out")
        self.assertEqual([row["part"] for row in self.parts()], ["angle"])
        (refused,) = [row for row in self.table() if row["file"] == ""]
        self.assertEqual(refused["status"], "refused")
        self.assertIn("self_intersection: ", refused["warnings"])
        self.pack("through.json", "part.step", "-o", "out", "--write-anyway")
        self.assertEqual(sorted(row["status"] for row in self.parts()), ["ok", "warning"])


class Shop(PackTest):
    """A shop of two materials, and a list that says which part is of which."""

    K_OF = {"Mild steel": 0.3, "brass": 0.35}

    def setUp(self):
        super().setUp()
        (self.dir / "in").mkdir()
        for name in ("left leg", "right leg", "seat"):
            self.named(f"in/{name}.step", name=name, leg=50.0 + len(name))
        self.write("shop.json", json.dumps({"name": "S", "materials": [
            {"name": name, "density": 8.0, "gauges": [{"thickness": 2, "inside_radius": 2, "k": k}]}
            for name, k in self.K_OF.items()]}))

    def test_lists_choose_among_its_materials(self):
        self.write("m.csv", "part;material\n*leg;BRASS\n*;mild steel\n")
        self.pack("in", "-o", "out", "--shop", "shop.json", "--materials", "m.csv")
        rows = {row["part"]: row for row in self.parts()}
        self.assertEqual(len(rows), 3)
        for part, material in (("left leg", "brass"), ("right leg", "brass"), ("seat", "Mild steel")):
            row = rows[part]
            self.assertEqual(row["material"], material, "as the shop spells it")
            length = 2 * (50.0 + len(part) - 4.0) + math.pi / 2 * (2.0 + self.K_OF[material] * 2.0)
            self.assertAlmostEqual(float(row["length"]), length, delta=1e-5 * length)
            self.assertIn(material.replace(" ", "_"), row["file"])
        subprocess.run([CLI, "batch", "in", "-o", "flat", "-q", "--shop", "shop.json", "--materials", "m.csv"],
                       cwd=self.dir, check=True, timeout=SECONDS)
        self.assertEqual([row["material"] for row in self.table("flat", "summary.csv")],
                         ["brass", "brass", "Mild steel"])

    def test_a_mistake_ends_it_before_any_work(self):
        self.write("m.csv", "part;material\n*leg;brass\nseat;oak\n")
        self.write("good.csv", "part;material\n*;brass\n")
        for options, words in (
                (["--materials", "m.csv"], 'm.csv, line 3: the shop profile has no material "oak"; it has Mild steel, brass'),
                ([], "no input names one of them. Choose one with --material, or that of each part with --materials"),
                (["--material", "oak"], 'no material "oak"'),
                (["--k", "0.4", "--din6935"], "--k and --din6935 each say where K comes from")):
            self.assertIn(words, self.sentence("in", "-o", "out", "--shop", "shop.json", *options, status=2))
            self.assertFalse((self.dir / "out").exists())

    def test_ends_with_2_where_no_part_has_a_material(self):
        self.write("m.csv", "part;material\nlegs;brass\n")
        said = self.sentence("in", "-o", "out", "--shop", "shop.json", "--materials", "m.csv", status=2)
        self.assertIn("m.csv has no row for ", said)
        self.assertIn("left leg.step", said)
        self.assertIn("or choose a material with --material", said)
        self.assertFalse((self.dir / "out").exists())

    def test_what_is_chosen_for_all_names_files_and_rows(self):
        self.write("m.csv", "part;material\nseat;Mild steel\n")
        self.pack("in", "-o", "out", "--shop", "shop.json", "--material", "Brass", "--materials", "m.csv")
        self.assertEqual({row["part"]: row["material"] for row in self.parts()},
                         {"left leg": "brass", "right leg": "brass", "seat": "Mild steel"})
        self.write("dc04.json", json.dumps({"tension": {"power_law": {"strength": 500, "exponent": 0.2}}}))
        self.pack("in/seat.step", "-o", "other", "--material", "dc04.json")
        self.assertEqual([row["file"] for row in self.parts("other")], ["seat_dc04_2mm_x1"])


class Quantities(PackTest):
    def setUp(self):
        super().setUp()
        (self.dir / "in").mkdir()
        self.named("in/leg.step", name="leg")
        self.write("in/chair.step", step_files.two_angles_and_a_block())
        self.write("in/notes.pdf", "%PDF")

    def quantities(self):
        return {row["part"]: int(row["quantity"]) for row in self.parts()}

    def test_come_from_lists_of_files(self):
        self.write("in/parts.txt", "leg.step x20\nchair.step x3\n")
        self.pack("@in/parts.txt", "-o", "out", "--no-drawings")
        # Three chairs have two angles each that equal the leg.
        self.assertEqual(sorted(self.quantities().values()), [3, 26])
        refused = [row for row in self.table() if row["status"] == "refused"]
        self.assertEqual([row["quantity"] for row in refused], ["3"])
        subprocess.run([CLI, "batch", "@in/parts.txt", "-o", "flat", "-q"], cwd=self.dir, check=True, timeout=SECONDS)
        rows = self.table("flat", "summary.csv")
        self.assertEqual(sum(int(row["quantity"]) for row in rows), 20 + 3 * 4)
        self.pack("flat", "-o", "again", "--no-drawings")
        self.assertEqual([row["quantity"] for row in self.parts("again")],
                         [row["quantity"] for row in self.parts()])

    def test_come_from_lists_of_materials(self):
        self.write("m.csv", "part,material,quantity\nleg,S235,20\n")
        self.pack("in/leg.step", "-o", "out", "--materials", "m.csv", "--no-drawings")
        self.assertEqual([row["file"] for row in self.parts()], ["leg_S235_2mm_x20"])
        self.write("m.csv", "part,material,quantity\nleg,S235,7\n")
        self.pack("in/leg.step", "-o", "out", "--materials", "m.csv", "--no-drawings")
        self.assertEqual([row["file"] for row in self.parts()], ["leg_S235_2mm_x7"])
        subprocess.run([CLI, "unfold", "in/leg.step", "--all", "-o", "flat/", "--materials", "m.csv", "-q"],
                       cwd=self.dir, check=True, timeout=SECONDS)
        self.assertEqual([row["quantity"] for row in self.table("flat", "summary.csv")], ["7"])

    def test_come_from_one_place(self):
        self.write("in/parts.txt", "leg.step x20\n")
        self.write("m.csv", "part,material,quantity\nleg,S235,20\n")
        said = self.sentence("@in/parts.txt", "-o", "out", "--materials", "m.csv", status=2)
        self.assertIn("--materials has a column quantity, and in/parts.txt, line 1 gives a quantity too", said)
        self.assertFalse((self.dir / "out").exists())

    def test_what_is_passed_over_is_told(self):
        out = self.pack("in", "-o", "out")
        self.assertIn("passed over (1):\n  notes.pdf: no file that planish reads\n", out)
        text = subprocess.run(["pdftotext", "-layout", "out/cover.pdf", "-"], cwd=self.dir,
                              capture_output=True, text=True, check=False)
        if text.returncode == 0:
            self.assertIn("notes.pdf", text.stdout)


class Folder(PackTest):
    def test_the_same_bytes_each_time(self):
        (self.dir / "in").mkdir()
        for i in range(4):
            self.angle(f"in/{i}.step", leg=50.0 + i)
        arguments = ["in", "--zip", "--nest", "1000x500", "-q"]
        self.pack(*arguments, "-o", "one", "--jobs", 1)
        self.pack(*arguments, "-o", "two", "--jobs", 3)
        first, second = self.files("one"), self.files("two")
        self.assertEqual(sorted(first), sorted(second))
        self.assertEqual([name for name in first if first[name] != second[name]], [])

    def test_the_archive_holds_the_pack(self):
        self.angle()
        self.pack("part.step", "-o", "out", "--zip")
        files = self.files()
        archive = files.pop("pack.zip")
        with zipfile.ZipFile(io.BytesIO(archive)) as packed:
            self.assertIsNone(packed.testzip())
            self.assertEqual({name: packed.read(name) for name in packed.namelist()}, files)
            self.assertEqual({info.date_time for info in packed.infolist()},
                             {(1980, 1, 1, 0, 0, 0)})

    def test_no_drawing_of_an_earlier_pack_stays(self):
        (self.dir / "in").mkdir()
        self.angle("in/a.step")
        self.angle("in/b.step")
        self.pack("in", "-o", "out", "--zip", "--nest", "500x500")
        (self.dir / "out" / "notes.txt").write_text("mine")
        (self.dir / "in" / "b.step").unlink()
        self.pack("in", "-o", "out")
        self.assertEqual(sorted(self.files()),
                         ["angle_2mm_x1.dxf", "angle_2mm_x1.pdf", "cover.pdf",
                          "notes.txt", "parts.csv"])

    def test_what_would_help_at_the_press_brake_is_told(self):
        (self.dir / "in").mkdir()
        self.write("in/deep.json", json.dumps(step_files.deep_channel()))
        self.pack("in", "-o", "out", "--no-drawings")
        (row,) = self.parts()
        self.assertEqual(row["plan"], "cannot be bent")
        self.assertIn("it can be bent ", row["warnings"])

    def test_drawings_can_be_left_out(self):
        self.angle()
        self.pack("part.step", "-o", "out", "--no-drawings", "--no-plan")
        self.assertEqual(sorted(self.files()), ["angle_2mm_x1.dxf", "parts.csv"])
        self.assertEqual(self.parts()[0]["plan"], "not planned")

    def test_an_interrupted_pack_goes_on(self):
        (self.dir / "in").mkdir()
        for i in range(40):
            self.angle(f"in/{i:02}.step", leg=50.0 + i)
        run = subprocess.Popen([CLI, "pack", "in", "-o", "out", "--progress", "json", "--jobs", "1"],
                               cwd=self.dir, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        run.stderr.readline()
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=SECONDS)
        self.assertEqual((run.returncode, out), (1, ""))
        self.assertIn("interrupted", err.splitlines()[-1])
        self.assertEqual(self.files(), {})
        self.pack("in", "-o", "out", "-q")
        self.pack("in", "-o", "whole", "-q")
        self.assertEqual(self.files(), self.files("whole"))


class Rates(PackTest):
    RATES = {"format": "planish/rates", "version": 1, "currency": "EUR",
             "materials": {"S235": {"cut": 0.01, "pierce": 0.5, "bend": 2, "setup": 10, "kg": 1.5}}}

    def test_multiply_what_is_counted(self):
        (self.dir / "in").mkdir()
        self.angle("in/a.step")
        self.angle("in/b.step")
        self.write("rates.json", json.dumps(self.RATES))
        self.write("materials.csv", "part,material,density\n*,S235,7.85\n")
        self.pack("in", "-o", "out", "--rates", "rates.json", "--materials", "materials.csv")
        (row,) = self.parts()
        volume = (2 * (50.0 - 4.0) + math.pi / 2 * 3.0) * THICKNESS * DEPTH
        cost = 10 + 2 * (0.01 * 2 * (flat_length(50.0) + DEPTH) + 0.5 + 2 + 1.5 * 7.85e-6 * volume)
        self.assertAlmostEqual(float(row["cost EUR"]), cost, delta=0.006)

    def test_have_to_fit(self):
        self.angle()
        self.write("rates.json", json.dumps(self.RATES))
        said = self.sentence("part.step", "-o", "out", "--rates", "rates.json", status=2)
        self.assertIn('no rates for the material "unknown"', said)
        self.assertIn("it has S235", said)
        self.write("materials.csv", "part,material\n*,S235\n")
        said = self.sentence("part.step", "-o", "out", "--rates", "rates.json", "--materials",
                             "materials.csv", status=2)
        self.assertIn("the mass of angle is not known", said)
        self.assertEqual(self.files(), {})

    def test_are_read_strictly(self):
        self.angle()
        for text, what in [("{", "not a JSON object"), ('{"materials": {}}', "holds no rates"),
                           ('{"materials": {"a/b": {"cuts": 1}}}', "/materials/a~1b/cuts is an unknown key"),
                           ('{"materials": {"a": {"cut": -1}}}', "at least 0"),
                           ('{"prices": 1}', "/prices is an unknown key")]:
            self.write("rates.json", text)
            self.assertIn(what, self.sentence("part.step", "-o", "out", "--rates", "rates.json",
                                              status=3))


class Sheets(PackTest):
    def test_hold_every_piece_once_and_apart(self):
        (self.dir / "in").mkdir()
        for i in range(12):
            self.named(f"in/{i:02}.step", leg=50.0 + i % 3, name=f"angle {i % 3}")
        self.pack("in", "-o", "out", "--nest", "400x300", "--gap", "6")
        pieces = 0
        for path in sorted((self.dir / "out" / "sheets").glob("*.dxf")):
            drawing = ezdxf.readfile(path)
            self.assertEqual(drawing.audit().errors, [])
            space = drawing.modelspace()
            boxes = []
            for outline in space.query('LWPOLYLINE[layer=="OUTER_PROFILE"]'):
                xs, ys = zip(*[(x, y) for x, y, *_ in outline.get_points()])
                boxes.append((min(xs), min(ys), max(xs), max(ys)))
            # Flat patterns of angles are rectangles along the sheet, so their boxes are exact.
            lines = space.query('LINE[layer=="BEND_UP"]')
            self.assertEqual(len(lines), len(boxes))
            self.assertEqual(len(space.query('TEXT[layer=="PART_NAMES"]')), len(boxes))
            for line in lines:
                middle = (line.dxf.start + line.dxf.end) / 2
                inside = [box for box in boxes
                          if box[0] < middle.x < box[2] and box[1] < middle.y < box[3]]
                self.assertEqual(len(inside), 1)
            for i, (x0, y0, x1, y1) in enumerate(boxes):
                self.assertTrue(x0 >= 6 - 1e-3 and y0 >= 6 - 1e-3 and x1 <= 394 + 1e-3
                                and y1 <= 294 + 1e-3, (x0, y0, x1, y1))
                for a0, b0, a1, b1 in boxes[:i]:
                    apart = math.hypot(max(a0 - x1, x0 - a1, 0), max(b0 - y1, y0 - b1, 0))
                    self.assertGreaterEqual(apart, 6 - 2e-3)
            pieces += len(boxes)
        self.assertEqual(pieces, 12)
        rows = self.table(name="sheets.csv")
        self.assertEqual(sum(int(row["pieces"]) for row in rows), 12)
        use = 4 * sum(flat_length(leg) * DEPTH for leg in (50.0, 51.0, 52.0))
        sheets = sum(float(row["use"]) / 100 * 400 * 300 for row in rows)
        self.assertAlmostEqual(sheets, use, delta=1e-4 * use)

    def test_name_what_is_too_large(self):
        self.angle("part.step", leg=300.0)
        out = self.pack("part.step", "-o", "out", "--nest", "400x300")
        self.assertIn("angle_2mm_x1 does not fit on a sheet of 400 × 300 mm", out)
        self.assertEqual(self.table(name="sheets.csv"), [])


class BadInputs(PackTest):
    def test_get_one_sentence(self):
        self.angle()
        (self.dir / "in").mkdir()
        self.angle("in/a.step")
        (self.dir / "empty").mkdir()
        self.sentence("in", "-o", "in/out", status=2)
        self.sentence("empty", "-o", "out", status=3)
        self.sentence("missing.step", "-o", "out", status=3)
        for size in ("3000", "0x100", "axb", "-1x5"):
            self.assertIn("--nest must be like", self.sentence("part.step", "-o", "out", "--nest=" + size,
                                                               status=2))
        self.assertIn("--nest", self.sentence("part.step", "-o", "out", "--gap", "5", status=2))
        self.sentence("part.step", "-o", "out", "--rates", "none.json", status=3)
        for text, what in [("", "empty"), ("part,density\n", "columns part (or colour) and"),
                           ("part,material\nx,\n", "needs a part or a colour, and a material"),
                           ("part,material,density\nx,S235,heavy\n", "density"),
                           ("part,material,Qty\nx,S235,5\n",
                            'materials.csv, line 1: a list of materials has no column "Qty"'),
                           ("part,material,quantity\nx,S235,five\n",
                            'line 2: the quantity must be a whole number from 1 to 1000000, not "five"')]:
            self.write("materials.csv", text)
            self.assertIn(what, self.sentence("part.step", "-o", "out", "--materials",
                                              "materials.csv", status=3))
        self.assertFalse((self.dir / "out").exists())


if __name__ == "__main__":
    main()
