"""Runs in freecadcmd: objects that are made, recomputed, saved and opened again."""

import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD as App
import inside
import Part
import Sketcher
import planish_workbench
from planish_workbench import features, library, make, places, preferences, profiles

planish = library.planish()
NEAR = 1e-6  # mm² and mm: between the kernel's measures and closed forms


class Document(unittest.TestCase):
    def setUp(self):
        self.document = App.newDocument("test")

    def tearDown(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)

    def solid(self, shape, name="Solid", placement=None):
        source = self.document.addObject("Part::Feature", name)
        source.Shape = shape
        if placement is not None:
            source.Placement = placement
        return source

    def plane(self, name, length, width, placement=None):
        plate = self.document.addObject("Part::Plane", name)
        plate.Length, plate.Width = length, width
        if placement is not None:
            plate.Placement = placement
        self.document.recompute()
        return plate

    def closed_sketch(self, points, placement=None):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        vectors = [App.Vector(*point, 0) for point in points]
        sketch.addGeometry([Part.LineSegment(a, b) for a, b in zip(vectors, vectors[1:] + vectors[:1])], False)
        if placement is not None:
            sketch.Placement = placement
        self.document.recompute()
        return sketch

    def reopened(self):
        path = str(inside.SCRATCH / "document.FCStd")
        self.document.saveAs(path)
        App.closeDocument(self.document.Name)
        self.document = App.openDocument(path)
        return self.document

    def assert_near(self, first, second, delta=NEAR):
        self.assertAlmostEqual(first, second, delta=delta)

    def assert_placed(self, one, placement):
        for a, b in zip(one.Placement.toMatrix().A, placement.toMatrix().A):
            self.assert_near(a, b)


class Unfold(Document):
    def test_the_area_is_that_of_the_closed_form_for_every_k(self):
        shape, area = inside.bent()
        flat = planish_workbench.unfold(self.solid(shape), k_factor=0.3)
        self.assertEqual(flat.KFactor, 0.3)
        self.assert_near(flat.Shape.Area, area(0.3))
        self.assertEqual((flat.Shape.ShapeType, flat.Shape.isValid()), ("Face", True))
        for k in (0.0, 0.44, 1.0):
            flat.KFactor = k
            self.document.recompute()
            self.assert_near(flat.Shape.Area, area(k))
            self.assert_near(json.loads(flat.Report)["flat"]["area"], area(k))
        self.assert_near(flat.Thickness.Value, 2.0)

    def test_bend_lines_lie_in_the_middle_of_the_bend(self):
        shape, _ = inside.bent(length=80, width=50, height=40)
        flat = planish_workbench.unfold(self.solid(shape), k_factor=0.5)
        up, down = self.document.getObject("BendsUp"), self.document.getObject("BendsDown")
        self.assert_near(up.Shape.Length, 50)
        self.assertTrue(down.Shape.isNull())
        across = sorted(edge.Length for edge in flat.Shape.Edges)[-1]
        self.assert_near(across, 80 + 40 + math.pi / 2 * 4)
        distances = sorted(up.Shape.distToShape(edge)[0] for edge in flat.Shape.Edges if abs(edge.Length - 50) < NEAR)
        self.assert_near(distances[0], 40 + math.pi)
        self.assert_near(distances[1], 80 + math.pi)

    def test_a_closed_tray_is_cut_open_along_the_edges_that_its_refusals_name(self):
        shape, area = inside.tray()
        source, edges = self.solid(shape), []
        with self.assertRaises(planish.Error) as refused:
            planish_workbench.unfold(source, k_factor=0.5, rip_edges=edges)
        self.assertEqual(refused.exception.code, "closed_loop")
        edges += places.named(refused.exception.places, "edge")
        self.assertEqual(len(edges), 4)
        flat = planish_workbench.unfold(source, k_factor=0.5, rip_edges=edges)
        self.assert_near(flat.Shape.Area, area(0.5))
        self.assertEqual(flat.RipEdges, ",".join(map(str, edges)))
        for edge in edges:  # corners of the tray, outside or inside
            self.assert_near(shape.Edges[edge - 1].Length, 40 if shape.Edges[edge - 1].BoundBox.ZMin < 1 else 38)
        name = flat.Name
        flat = self.reopened().getObject(name)
        flat.KFactor = 0.3
        self.document.recompute()
        self.assert_near(flat.Shape.Area, area(0.3))

    def test_openings_are_holes_and_the_program_finds_the_same(self):
        source = self.solid(inside.bracket())
        flat = planish_workbench.unfold(source, k_factor=0.44)
        self.assertEqual(len(flat.Shape.Wires), 4)
        self.assert_near(flat.Shape.Area, planish.unfold(str(inside.SOURCE / "examples/bracket.step"), k=0.44).flat.area)

    def test_it_follows_its_source_and_a_turned_solid_is_as_large(self):
        shape, area = inside.bent()
        source = self.solid(shape)
        flat = planish_workbench.unfold(source, k_factor=0.44)
        source.Placement = App.Placement(App.Vector(100, -20, 7), App.Rotation(App.Vector(1, 2, 3), 77))
        self.document.recompute()
        self.assert_near(flat.Shape.Area, area(0.44))
        source.Shape = inside.bent(height=60)[0]
        self.document.recompute()
        self.assert_near(flat.Shape.Area, inside.bent(height=60)[1](0.44))

    def test_a_pattern_stays_where_it_was_put_and_its_lines_with_it(self):
        source = self.solid(inside.bent()[0])
        flat = planish_workbench.unfold(source, beside=True)
        self.assertGreater(flat.Shape.BoundBox.XMin, source.Shape.BoundBox.XMax)
        moved = App.Placement(App.Vector(500, 0, 0), App.Rotation(App.Vector(0, 0, 1), 90))
        flat.Placement = moved
        self.document.recompute()
        self.assert_placed(flat, moved)
        line = self.document.getObject("BendsUp")
        self.assert_placed(line, moved)
        self.assert_near(line.Shape.distToShape(flat.Shape)[0], 0)

    def test_what_is_refused_raises_and_leaves_nothing_behind(self):
        source = self.solid(Part.makeSphere(10))
        with self.assertRaises(planish.Refused) as raised:
            planish_workbench.unfold(source, k_factor=0.44)
        self.assertEqual(raised.exception.code, "not_a_sheet")
        self.assertEqual(len(self.document.Objects), 1)

    def test_wrong_choices_are_one_sentence(self):
        sheet = self.solid(inside.bent()[0])
        surface = self.solid(Part.makePlane(10, 10), "Surface")
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        for call, code in ((lambda: planish_workbench.unfold(surface), "no_solid"),
                           (lambda: planish_workbench.unfold(group), "no_shape"),
                           (lambda: planish_workbench.unfold(sheet, body=2), "no_such_body"),
                           (lambda: planish_workbench.unfold(sheet, k_factor=1.5), "bad_option"),
                           (lambda: planish_workbench.unfold(sheet, k_table="/nowhere.csv"), "cannot_read"),
                           (lambda: planish_workbench.connect([], 2.0), "no_plates")):
            with self.assertRaises(planish_workbench.Refusal) as raised:
                call()
            self.assertEqual(raised.exception.code, code)
            self.assertRegex(str(raised.exception), r"^[A-Z/].*\.$")
        self.assertEqual(len(self.document.Objects), 3)

    def test_a_recompute_that_fails_keeps_the_shape_and_says_why(self):
        shape, area = inside.bent()
        source = self.solid(shape)
        flat = planish_workbench.unfold(source, k_factor=0.44)
        source.Shape = Part.makeSphere(10)
        self.document.recompute()
        self.assertIn("Invalid", flat.State)
        self.assertEqual((flat.Status, flat.Code), ("refused", "not_a_sheet"))
        self.assertIn("not a sheet", flat.Problem)
        self.assert_near(flat.Shape.Area, area(0.44))
        source.Shape = shape
        self.document.recompute()
        self.assertEqual((flat.State, flat.Problem, flat.Status), (["Up-to-date"], "", "ok"))

    def test_saved_and_opened_it_is_parametric_still(self):
        shape, area = inside.bent()
        planish_workbench.unfold(self.solid(shape), k_factor=0.44)
        document = self.reopened()
        flat = document.getObject("Unfold")
        self.assert_near(flat.Shape.Area, area(0.44))
        self.assertEqual(flat.State, ["Up-to-date"])
        flat.KFactor = 0.2
        document.recompute()
        self.assert_near(flat.Shape.Area, area(0.2))
        document.getObject("Solid").Shape = inside.bent(width=70)[0]
        document.recompute()
        self.assert_near(flat.Shape.Area, inside.bent(width=70)[1](0.2))
        self.assert_near(document.getObject("BendsUp").Shape.Length, 70)

    def test_a_bend_table_comes_before_the_factor(self):
        table = inside.SCRATCH / "table.csv"
        table.write_text("r/t,k\n0.5,0.25\n5,0.25\n")
        shape, area = inside.bent()
        flat = planish_workbench.unfold(self.solid(shape), k_table=str(table))
        self.assert_near(flat.Shape.Area, area(0.25))

    def test_bodies_parts_and_links_are_sources(self):
        shape, area = inside.bent()
        body = self.document.addObject("PartDesign::Body", "Body")
        body.BaseFeature = self.solid(shape)
        part = self.document.addObject("App::Part", "Assembly")
        part.Placement = App.Placement(App.Vector(10, 20, 30), App.Rotation(App.Vector(0, 1, 0), 33))
        part.addObject(self.solid(shape, "Member"))
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.document.getObject("Member")
        self.document.recompute()
        for source in (body, part, link, self.document.getObject("Member")):
            with self.subTest(source.Name):
                self.assert_near(planish_workbench.unfold(source, k_factor=0.44).Shape.Area, area(0.44))

    def test_the_whole_document_is_each_different_solid_once(self):
        shape, area = inside.bent()
        turned = App.Placement(App.Vector(300, 0, 0), App.Rotation(App.Vector(1, 1, 0), 40))
        self.solid(shape)
        self.solid(shape, "Again", turned)
        self.solid(Part.makeCompound([inside.bent(height=55)[0], inside.bracket()]), "Two")
        self.solid(Part.makeSphere(5), "Ball")
        made, refused = planish_workbench.unfold_document(self.document, k_factor=0.44)
        self.assertEqual([(one.Source.Name, one.Body) for one in made], [("Solid", 1), ("Two", 1), ("Two", 2)])
        self.assert_near(made[1].Shape.Area, inside.bent(height=55)[1](0.44))
        self.assertEqual([(source.Name, error.code) for source, _, error in refused], [("Ball", "not_a_sheet")])

    def test_files_and_a_sketch(self):
        source = self.solid(inside.bracket())
        flat = planish_workbench.unfold(source, k_factor=0.44)
        path = inside.SCRATCH / "flat.dxf"
        planish_workbench.write(flat, path)
        expected = planish.unfold(inside.bracket().Solids[0], k=0.44, name=source.Label).artifact("dxf")
        self.assertEqual(path.read_bytes(), expected)
        sketch = planish_workbench.sketch(flat)
        self.document.recompute()
        self.assertEqual((sketch.State, sketch.solve()), (["Up-to-date"], 0))
        drawn = Part.makeFace(sketch.Shape.Wires, "Part::FaceMakerBullseye")
        self.assert_near(drawn.Area, flat.Shape.Area)
        self.assertEqual(sum(map(sketch.getConstruction, range(len(sketch.Geometry)))), 2)


    def test_what_can_be_chosen_is_what_planish_takes(self):
        options = json.loads(planish.schema("request"))["properties"]["options"]["properties"]

        def words(schema):
            return set(schema.get("enum", ())) | {word for one in schema.get("anyOf", ()) for word in words(one)}

        for name, offered in (("relief", features.RELIEF), ("bend_relief", features.BEND_RELIEF), ("extruded", features.EXTRUDED), ("up", features.UP),
                              ("metal", features.METAL[1:]), ("lateral", features.LATERAL),
                              ("profile", preferences.PROFILES)):
            self.assertEqual(set(offered), words(options[name]), name)


class Findings(Document):
    def test_faces_handed_over_keep_the_numbers_of_freecad(self):
        """A face may be the root only if it is a flange, so a face of one size tells its number."""
        placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(3, 2, 1), 50))
        solid = self.solid(inside.bent(length=80, height=40)[0], placement=placement).Shape.Solids[0]
        taken = []
        for number, face in enumerate(solid.Faces, 1):
            try:
                planish.unfold(solid, root=number)
                taken.append(round(face.Area, 6))
            except planish.Error as error:
                self.assertEqual(error.code, "no_such_face")
        self.assertEqual(sorted(taken), [2000.0, 4000.0])
        self.assertEqual(sorted(round(solid.Faces[number - 1].Area, 6) for number in places.flange_faces(solid)),
                         [2000.0, 4000.0])

    def test_a_place_in_the_pattern_is_the_face_of_its_flange(self):
        shape, _ = inside.bent(length=80, width=50, height=40)
        hole = Part.makeCylinder(0.3, 10, App.Vector(-40, 25, -5))
        source = self.solid(Part.makeCompound([inside.bracket(), shape.cut(hole)]))
        flat = planish_workbench.unfold(source, k_factor=0.44, body=2)
        row, = [row for row in places.rows(flat) if "Ø 0.6" in row.message]
        skins = [source.Shape.getElement(name) for name in places.faces(flat, row)]
        for face in skins:
            self.assert_near(face.Area, 4000 - math.pi * 0.09)
        self.assertEqual(sorted(round(abs(face.CenterOfMass.z), 6) for face in skins), [0.0, 2.0])

    def test_the_face_that_a_refusal_names_is_found(self):
        shape, _ = inside.bent()
        source = self.solid(shape)
        flat = planish_workbench.unfold(source)
        step = Part.makeBox(20, 50, 1, App.Vector(-60, 0, 2))
        source.Shape = shape.fuse(step).removeSplitter()
        self.document.recompute()
        self.assertEqual(flat.Status, "refused")
        row, = places.rows(flat)
        names = places.faces(flat, row)
        self.assertEqual(bool(names), bool(places.named(json.loads(flat.Places or "[]"), "face")))
        for name in names:
            self.assertGreater(source.Shape.getElement(name).Area, 0)


class Connect(Document):
    THICKNESS, RADIUS = 2.0, 3.0

    def plates(self, gap=10.0):
        """Two plates at right angles, each `gap` from the line in which their planes meet."""
        base = self.plane("Base", 100, 60)
        back = self.plane("Back", 100, 50, App.Placement(App.Vector(0, 60 + gap, gap), App.Rotation(App.Vector(1, 0, 0), 90)))
        return base, back

    def volume(self, gap):
        middle = self.RADIUS + self.THICKNESS / 2
        return 100 * self.THICKNESS * (60 + 50 + 2 * (gap - middle) + math.pi / 2 * middle)

    def test_the_volume_is_that_of_the_closed_form_and_it_follows_a_plate(self):
        base, back = self.plates()
        made = planish_workbench.connect([(base, "Face1"), (back, "Face1")], self.THICKNESS, inside_radius=self.RADIUS)
        self.assert_near(made.Shape.Volume, self.volume(10), 1e-3)
        self.assertTrue(made.Shape.isValid() and made.Shape.ShapeType == "Solid")
        back.Placement.Base = App.Vector(0, 75, 15)
        self.document.recompute()
        self.assert_near(made.Shape.Volume, self.volume(15), 1e-3)
        net = make.pattern_of(made)
        self.assert_near(net.Shape.Area, made.Area.Value, 1e-3)

    def test_sketches_are_plates_and_their_holes_are_openings(self):
        outline = [(0, 0), (100, 0), (100, 60), (0, 60)]
        sketch = self.closed_sketch(outline)
        hole = [App.Vector(*point, 0) for point in ((40, 20), (60, 20), (60, 40), (40, 40))]
        sketch.addGeometry([Part.LineSegment(a, b) for a, b in zip(hole, hole[1:] + hole[:1])], False)
        _, back = self.plates()
        made = planish_workbench.connect([sketch, back], self.THICKNESS, inside_radius=self.RADIUS)
        self.assert_near(made.Shape.Volume, self.volume(10) - 20 * 20 * self.THICKNESS, 1e-3)

    def test_faces_of_a_skin_have_the_material_behind_them(self):
        base, back = self.plates()
        made = planish_workbench.connect([base, back], self.THICKNESS, inside_radius=self.RADIUS, faces_are="skin")
        box = made.Shape.BoundBox
        self.assert_near(box.ZMin, -self.THICKNESS, 1e-4)

    def test_it_follows_the_part_in_which_a_plate_stands(self):
        base, back = self.plates()
        frame = self.document.addObject("App::Part", "Frame")
        frame.addObject(back)
        made = planish_workbench.connect([base, back], self.THICKNESS, inside_radius=self.RADIUS)
        frame.Placement.Base = App.Vector(0, 5, 5)
        self.document.recompute()
        self.assert_near(made.Shape.Volume, self.volume(15), 1e-3)

    def test_plates_that_lie_alike_are_refused_with_its_code(self):
        base, _ = self.plates()
        above = self.plane("Above", 100, 60, App.Placement(App.Vector(0, 0, 0.5), App.Rotation()))
        before = len(self.document.Objects)
        with self.assertRaises(planish.Error) as raised:
            planish_workbench.connect([base, above], self.THICKNESS, inside_radius=self.RADIUS)
        self.assertTrue(raised.exception.code)
        self.assertEqual(len(self.document.Objects), before)

    def test_a_curved_face_is_no_plate(self):
        base, _ = self.plates()
        with self.assertRaises(planish_workbench.Refusal) as raised:
            planish_workbench.connect([base, (self.solid(Part.makeCylinder(5, 5)), "Face1")], 2.0)
        self.assertEqual(raised.exception.code, "not_planar")

    def test_saved_and_opened_it_follows_still(self):
        planish_workbench.connect(list(self.plates()), self.THICKNESS, inside_radius=self.RADIUS)
        document = self.reopened()
        made = document.getObject("Connect")
        self.assert_near(made.Shape.Volume, self.volume(10), 1e-3)
        document.getObject("Back").Placement.Base = App.Vector(0, 80, 20)
        document.recompute()
        self.assert_near(made.Shape.Volume, self.volume(20), 1e-3)

    def test_its_solid_can_be_unfolded_to_the_same_area(self):
        made = planish_workbench.connect(list(self.plates()), self.THICKNESS, inside_radius=self.RADIUS, k_factor=0.44)
        flat = planish_workbench.unfold(made, k_factor=0.44)
        self.assert_near(flat.Shape.Area, made.Area.Value, 1e-3)


class Transition(Document):
    def circle(self, radius, height, name="Circle"):
        circle = self.document.addObject("Part::Circle", name)
        circle.Radius = radius
        circle.Placement.Base = App.Vector(0, 0, height)
        self.document.recompute()
        return circle

    @staticmethod
    def cone(low, high, height):
        return math.pi * (low + high) * math.hypot(low - high, height)

    def test_two_circles_are_a_cone_and_it_follows_them(self):
        low, high = self.circle(80, 0), self.circle(40, 100, "High")
        made = planish_workbench.transition(low, high, 1.0, press_angle=0)
        self.assert_near(made.Area.Value / self.cone(80, 40, 100), 1.0, 1e-4)
        net = make.pattern_of(made)
        self.assert_near(net.Shape.Area / self.cone(80, 40, 100), 1.0, 1e-4)
        high.Radius = 50
        self.document.recompute()
        self.assert_near(made.Area.Value / self.cone(80, 50, 100), 1.0, 1e-4)
        self.assert_near(net.Shape.Area / self.cone(80, 50, 100), 1.0, 1e-4)

    def test_a_sketch_and_a_circle_are_what_the_file_of_the_examples_is(self):
        path = inside.SOURCE / "examples/transition/a_square_to_round.json"
        expected = planish.transition(str(path)).flat.area
        square = self.closed_sketch([(-150, -150), (150, -150), (150, 150), (-150, 150)])
        made = planish_workbench.transition(square, self.circle(100, 250), 1.5)
        self.assert_near(made.Area.Value / expected, 1.0, 1e-6)

    def test_a_frame_that_is_turned_and_one_below_make_no_difference(self):
        square = [(-150, -150), (150, -150), (150, 150), (-150, 150)]
        upright = planish_workbench.transition(self.closed_sketch(square), self.circle(100, 250), 1.0)
        over = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 180))
        turned = planish_workbench.transition(self.closed_sketch(square, over), self.circle(100, -250, "Below"), 1.0)
        self.assert_near(turned.Area.Value / upright.Area.Value, 1.0, 1e-6)

    def test_several_pieces_lie_beside_each_other(self):
        square = self.closed_sketch([(-150, -150), (150, -150), (150, 150), (-150, 150)])
        made = planish_workbench.transition(square, self.circle(100, 250), 1.0, pieces=2)
        first, second = make.pattern_of(made).Shape.Faces
        self.assertGreater(second.BoundBox.XMin, first.BoundBox.XMax)
        self.assert_near(first.Area + second.Area, made.Area.Value, 1e-3)

    def test_profiles_are_recognised(self):
        def arc(centre, start, stop, radius):
            circle = Part.Circle(App.Vector(*centre, 0), App.Vector(0, 0, 1), radius)
            return Part.ArcOfCircle(circle, math.radians(start), math.radians(stop)).toShape()

        def line(a, b):
            return Part.makeLine(App.Vector(*a, 0), App.Vector(*b, 0))

        obround = [line((-30, -10), (30, -10)), arc((30, 0), -90, 90, 10), line((30, 10), (-30, 10)), arc((-30, 0), 90, 270, 10)]
        rounded = [line((-30, -20), (30, -20)), arc((30, -15), -90, 0, 5), line((35, -15), (35, 15)), arc((30, 15), 0, 90, 5),
                   line((30, 20), (-30, 20)), arc((-30, 15), 90, 180, 5), line((-35, 15), (-35, -15)),
                   arc((-30, -15), 180, 270, 5)]
        ellipse = [Part.Ellipse(App.Vector(), 30, 20).toShape()]
        for edges, kind, values in ((obround, "obround", {"length": 80, "width": 20}),
                                    (rounded, "rounded_rectangle", {"width": 70, "height": 40, "radius": 5}),
                                    (ellipse, "ellipse", {"rx": 30, "ry": 20})):
            with self.subTest(kind):
                profile = profiles.end(Part.Wire(edges), kind)["profile"]
                self.assertEqual(list(profile), [kind])
                for name, value in values.items():
                    self.assert_near(profile[kind][name], value)
        half = Part.Wire([line((-10, 0), (10, 0)), arc((0, 0), 0, 180, 10)])
        with self.assertRaises(planish_workbench.Refusal) as raised:
            profiles.end(half, "Half")
        self.assertEqual(raised.exception.code, "no_profile")

    def test_an_open_contour_is_one_sentence(self):
        open_wire = self.solid(Part.makePolygon([App.Vector(0, 0, 0), App.Vector(10, 0, 0), App.Vector(10, 10, 0)]), "Open")
        with self.assertRaises(planish_workbench.Refusal) as raised:
            planish_workbench.transition(open_wire, self.circle(10, 50), 1.0)
        self.assertEqual((raised.exception.code, len(self.document.Objects)), ("no_profile", 2))

    def test_saved_and_opened_it_follows_still(self):
        planish_workbench.transition(self.circle(80, 0), self.circle(40, 100, "High"), 1.0, press_angle=0)
        document = self.reopened()
        document.getObject("High").Radius = 60
        document.recompute()
        self.assert_near(document.getObject("Transition").Area.Value / self.cone(80, 60, 100), 1.0, 1e-4)


class BendPlan(Document):
    def test_the_strokes_are_those_of_planish(self):
        plan = planish_workbench.bend_plan(self.solid(inside.bracket()), k_factor=0.44)
        expected = planish.bend(inside.bracket().Solids[0], k=0.44).plan
        self.assertEqual(len(plan.Strokes), len(expected.strokes))
        for said, stroke in zip(plan.Strokes, expected.strokes):
            self.assertIn(stroke.punch, said)
        planish_workbench.write(plan, inside.SCRATCH / "plan.pdf")
        self.assertTrue((inside.SCRATCH / "plan.pdf").read_bytes().startswith(b"%PDF"))

    def test_it_follows_and_is_there_again(self):
        source = self.solid(inside.bracket())
        planish_workbench.bend_plan(source)
        document = self.reopened()
        document.getObject("Solid").Shape = inside.bent()[0]
        document.recompute()
        self.assertEqual(len(document.getObject("BendPlan").Strokes), 1)


inside.run(Unfold, Findings, Connect, Transition, BendPlan)
