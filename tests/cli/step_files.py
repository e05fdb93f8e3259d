"""STEP files in closed form: prisms over profiles of lines and arcs, so that the flat pattern of
each is known by a formula. Written from the standard's entity definitions, without a CAD kernel."""

import math
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from known_parts.boxes import tab_plate  # noqa: E402
from known_parts.step_text import step_text  # noqa: E402

HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('{description}'),'2;1');
FILE_NAME('{name}','2024-01-01T00:00:00',(''),(''),'planish tests','planish tests','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
"""


class Line:
    def __init__(self, end):
        self.end = end


class Arc:
    def __init__(self, end, center, ccw):
        self.end, self.center, self.ccw = end, center, ccw


class StepFile:
    def __init__(self):
        self.entities = []
        self.application = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('','automotive_design',2000,{self.application})")
        mm = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
        rad = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        sr = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        tolerance = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{mm},'','')")
        self.context = self.add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
            f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({tolerance}))"
            f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({mm},{rad},{sr}))REPRESENTATION_CONTEXT('',''))")

    def add(self, entity):
        self.entities.append(entity)
        return f"#{len(self.entities)}"

    def text(self):
        lines = [f"#{i}={entity};" for i, entity in enumerate(self.entities, 1)]
        return (HEADER.format(description="", name="") + "\n".join(lines)
                + "\nENDSEC;\nEND-ISO-10303-21;\n")

    # --- geometry

    def point(self, p):
        return self.add("CARTESIAN_POINT('',({:.12f},{:.12f},{:.12f}))".format(*p))

    def direction(self, d):
        return self.add("DIRECTION('',({:.15f},{:.15f},{:.15f}))".format(*d))

    def placement(self, origin, axis, ref):
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(origin)},{self.direction(axis)},"
                        f"{self.direction(ref)})")

    def line_edge(self, a, b, vertex_a, vertex_b):
        d = [q - p for p, q in zip(a, b)]
        n = math.hypot(*d)
        vector = self.add(f"VECTOR('',{self.direction([c / n for c in d])},1.)")
        line = self.add(f"LINE('',{self.point(a)},{vector})")
        return self.add(f"EDGE_CURVE('',{vertex_a},{vertex_b},{line},.T.)")

    def arc_edge(self, a, vertex_a, vertex_b, center, ccw, z):
        r = math.dist(a[:2], center)
        circle = self.add(
            f"CIRCLE('',{self.placement((*center, z), (0, 0, 1), (1, 0, 0))},{r:.12f})")
        return self.add(f"EDGE_CURVE('',{vertex_a},{vertex_b},{circle},.{'T' if ccw else 'F'}.)")

    def face(self, surface, edges, same_sense=True):
        """edges: (edge, forward) in order, the face on their left seen from outside."""
        bound = self._bound("FACE_OUTER_BOUND", edges)
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},.{'T' if same_sense else 'F'}.)")

    # --- solids

    def prism(self, start, curves, depth, at=(0.0, 0.0, 0.0)):
        """Closed shell over a counter-clockwise profile, extruded from z = 0 to `depth`."""
        def moved(p):
            return (p[0] + at[0], p[1] + at[1])
        points = [moved(start)] + [moved(c.end) for c in curves[:-1]]
        n = len(points)
        levels = (at[2], at[2] + depth)
        vertices = [[self.add(f"VERTEX_POINT('',{self.point((*p, z))})") for p in points]
                    for z in levels]
        rims = [[self._rim(points, vertices[k], curves[i], i, levels[k], at) for i in range(n)]
                for k in (0, 1)]
        posts = [self.line_edge((*points[i], levels[0]), (*points[i], levels[1]),
                                vertices[0][i], vertices[1][i]) for i in range(n)]
        faces = [self._side(points, curves[i], i, levels[0], at,
                            [(rims[0][i], True), (posts[(i + 1) % n], True), (rims[1][i], False),
                             (posts[i], False)]) for i in range(n)]
        bottom = self.add(f"PLANE('',{self.placement((*points[0], levels[0]), (0, 0, -1), (1, 0, 0))})")
        faces.append(self.face(bottom, [(edge, False) for edge in reversed(rims[0])]))
        top = self.add(f"PLANE('',{self.placement((*points[0], levels[1]), (0, 0, 1), (1, 0, 0))})")
        faces.append(self.face(top, [(edge, True) for edge in rims[1]]))
        return self.add(f"CLOSED_SHELL('',({','.join(faces)}))")

    def _rim(self, points, vertices, curve, i, z, at):
        j = (i + 1) % len(points)
        a, b = (*points[i], z), (*points[j], z)
        if isinstance(curve, Line):
            return self.line_edge(a, b, vertices[i], vertices[j])
        center = (curve.center[0] + at[0], curve.center[1] + at[1])
        return self.arc_edge(a, vertices[i], vertices[j], center, curve.ccw, z)

    def _side(self, points, curve, i, z, at, edges):
        a, b = points[i], points[(i + 1) % len(points)]
        if isinstance(curve, Line):
            n = math.dist(a, b)
            d = ((b[0] - a[0]) / n, (b[1] - a[1]) / n, 0)
            plane = self.add(f"PLANE('',{self.placement((*a, z), (d[1], -d[0], 0), d)})")
            return self.face(plane, edges)
        center = (curve.center[0] + at[0], curve.center[1] + at[1])
        place = self.placement((*center, z), (0, 0, 1), (1, 0, 0))
        cylinder = self.add(f"CYLINDRICAL_SURFACE('',{place},{math.dist(a, center):.12f})")
        return self.face(cylinder, edges, same_sense=curve.ccw)

    # --- plates with round forms

    def ring(self, center, z, radius):
        """A circle about a vertical axis, as one edge: (edge, its vertex, where that lies)."""
        at = (center[0] + radius, center[1], z)
        vertex = self.add(f"VERTEX_POINT('',{self.point(at)})")
        return self.arc_edge(at, vertex, vertex, center, True, z), vertex, at

    def round_wall(self, surface, low, high, outwards):
        """A cylinder or cone between two rings; `outwards`: the material is within it."""
        seam = self.line_edge(low[2], high[2], low[1], high[1])
        edges = [(low[0], True), (seam, True), (high[0], False), (seam, False)]
        if not outwards:
            edges = [(edge, not forward) for edge, forward in reversed(edges)]
        return self.face(surface, edges, same_sense=outwards)

    def level(self, z, up, outer, holes=()):
        """A horizontal face: `outer` its loop as for a face that looks up, `holes` rings."""
        normal = (0, 0, 1 if up else -1)
        turned = outer if up else [(edge, not forward) for edge, forward in reversed(outer)]
        bounds = [self._bound("FACE_OUTER_BOUND", turned)]
        bounds += [self._bound("FACE_BOUND", [(ring[0], not up)]) for ring in holes]
        plane = self.add(f"PLANE('',{self.placement((0, 0, z), normal, (1, 0, 0))})")
        return self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{plane},.T.)")

    def _bound(self, kind, edges):
        oriented = [self.add(f"ORIENTED_EDGE('',*,*,{edge},.{'T' if forward else 'F'}.)")
                    for edge, forward in edges]
        loop = self.add(f"EDGE_LOOP('',({','.join(oriented)}))")
        return self.add(f"{kind}('',{loop},.T.)")

    # --- products

    def product(self, name, shell, entity="MANIFOLD_SOLID_BREP"):
        if entity == "MANIFOLD_SOLID_BREP":
            item = self.add(f"MANIFOLD_SOLID_BREP('{name}',{shell})")
            kind = "ADVANCED_BREP_SHAPE_REPRESENTATION"
        else:
            item = self.add(f"SHELL_BASED_SURFACE_MODEL('{name}',({shell}))")
            kind = "MANIFOLD_SURFACE_SHAPE_REPRESENTATION"
        axes = self.placement((0, 0, 0), (0, 0, 1), (1, 0, 0))
        shape = self.add(f"{kind}('{name}',({axes},{item}),{self.context})")
        context = self.add(f"PRODUCT_CONTEXT('',{self.application},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({context}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        design = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{self.application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
        of = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({of},{shape})")
        return definition, item


    def material(self, definition, name, density, exponent=-3):
        """What a product is made of, as CAD systems write it: a name and kg/m³."""
        kilogram = self.add("(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.))")
        metre = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))")
        unit = self.add(f"DERIVED_UNIT(({self.add(f'DERIVED_UNIT_ELEMENT({kilogram},1.)')},"
                        f"{self.add(f'DERIVED_UNIT_ELEMENT({metre},{exponent}.)')}))")
        for kind, item in (("material name", f"DESCRIPTIVE_REPRESENTATION_ITEM('{name}','{name}')"),
                           ("density", "MEASURE_REPRESENTATION_ITEM('density measure',"
                                       f"POSITIVE_RATIO_MEASURE({density:.6f}),{unit})")):
            of = self.add(f"PROPERTY_DEFINITION('material property','{kind}',{definition})")
            shape = self.add(f"REPRESENTATION('{kind}',({self.add(item)}),{self.context})")
            self.add(f"PROPERTY_DEFINITION_REPRESENTATION({of},{shape})")

    def colour(self, item, red, green, blue):
        """The colour of a solid or face; shares of one."""
        rgb = self.add(f"COLOUR_RGB('',{red:.9f},{green:.9f},{blue:.9f})")
        fill = self.add(f"FILL_AREA_STYLE('',({self.add(f'FILL_AREA_STYLE_COLOUR({chr(39)*2},{rgb})')}))")
        side = self.add(f"SURFACE_SIDE_STYLE('',({self.add(f'SURFACE_STYLE_FILL_AREA({fill})')}))")
        style = self.add(f"PRESENTATION_STYLE_ASSIGNMENT(({self.add(f'SURFACE_STYLE_USAGE(.BOTH.,{side})')}))")
        styled = self.add(f"STYLED_ITEM('color',({style}),{item})")
        self.add(f"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({styled}),{self.context})")


def angle_profile(leg, thickness, radius):
    """An L: both legs `leg` outside, one 90° bend. Flat length: 2 (leg − t − r) + π/2 (r + k t)."""
    t, r = thickness, radius
    s = t + r
    return (s, 0.0), [Line((leg, 0.0)), Line((leg, t)), Line((s, t)), Arc((t, s), (s, s), False),
                      Line((t, leg)), Line((0.0, leg)), Line((0.0, s)), Arc((s, 0.0), (s, s), True)]


def rectangle_profile(width, height):
    return (0.0, 0.0), [Line((width, 0.0)), Line((width, height)), Line((0.0, height)),
                        Line((0.0, 0.0))]


def angle(name="angle", leg=50.0, thickness=2.0, radius=2.0, depth=60.0):
    file = StepFile()
    file.product(name, file.prism(*angle_profile(leg, thickness, radius), depth))
    return file.text()


def block(side=30.0):
    file = StepFile()
    file.product("block", file.prism(*rectangle_profile(side, side), side))
    return file.text()


def square_tube(side=40.0, thickness=2.0, length=120.0):
    """Closed: as faces 1 to 4 its outside, 5 and 6 its ends, 7 to 10 its inside."""
    file, low, high = StepFile(), thickness, side - thickness
    outside = file.prism(*rectangle_profile(side, side), length)
    inside = file.prism((low, low), [Line(p) for p in ((low, high), (high, high), (high, low), (low, low))], length)

    def faces_of(shell):
        return re.findall(r"#(\d+)", file.entities[int(shell[1:]) - 1])

    own, other = faces_of(outside), faces_of(inside)
    for end in (-2, -1):
        bound = re.search(r"\((#\d+)\)", file.entities[int(other[end]) - 1])[1]
        file.entities[int(own[end]) - 1] = file.entities[int(own[end]) - 1].replace("),", f",{bound}),", 1)
    file.entities[int(outside[1:]) - 1] = f"CLOSED_SHELL('',({','.join(f'#{f}' for f in own + other[:-2])}))"
    file.product("tube", outside)
    return file.text()


def stepped_angle(leg=60.0, thickness=2.0, thick=3.0, depth=50.0):
    """A sharp angle whose upright leg (on the left) grows to `thick` halfway: no sheet, by its faces 4 and 6 inside."""
    file, half = StepFile(), leg / 2
    corners = ((leg, 0), (leg, thickness), (thickness, thickness), (thickness, half), (thick, half), (thick, leg), (0, leg), (0, 0))
    file.product("stepped angle", file.prism((0, 0), [Line(p) for p in corners], depth))
    return file.text()


def pressed_plate():
    """100 × 60 × 3 mm with a hole of Ø 5, countersunk to Ø 10, and a knob of Ø 20 pushed up 1 mm."""
    file = StepFile()
    corners = [(0, 0), (100, 0), (100, 60), (0, 60)]
    vertices = [[file.add(f"VERTEX_POINT('',{file.point((*p, z))})") for p in corners] for z in (0, 3)]

    def edge(i, j, low, high):
        return file.line_edge((*corners[i], 3 * low), (*corners[j], 3 * high), vertices[low][i], vertices[high][j])

    rims = [[edge(i, (i + 1) % 4, level, level) for i in range(4)] for level in (0, 1)]
    posts = [edge(i, i, 0, 1) for i in range(4)]
    faces = [file._side(corners, Line(None), i, 0, (0, 0), [(rims[0][i], True), (posts[(i + 1) % 4], True),
                                                          (rims[1][i], False), (posts[i], False)]) for i in range(4)]
    hole, knob = (25, 30), (70, 30)
    drilled, neck, sunk = file.ring(hole, 0, 2.5), file.ring(hole, 0.5, 2.5), file.ring(hole, 3, 5)
    foot, cap, brim, floor = (file.ring(knob, z, 10) for z in (3, 4, 0, 1))

    def axis(center, z):
        return file.placement((*center, z), (0, 0, 1), (1, 0, 0))

    faces += [
        file.round_wall(file.add(f"CYLINDRICAL_SURFACE('',{axis(hole, 0)},2.5)"), drilled, neck, False),
        file.round_wall(file.add(f"CONICAL_SURFACE('',{axis(hole, 0.5)},2.5,{math.pi / 4:.15f})"), neck, sunk, False),
        file.round_wall(file.add(f"CYLINDRICAL_SURFACE('',{axis(knob, 3)},10.)"), foot, cap, True),
        file.round_wall(file.add(f"CYLINDRICAL_SURFACE('',{axis(knob, 0)},10.)"), brim, floor, False),
        file.level(4, True, [(cap[0], True)]),
        file.level(1, False, [(floor[0], True)]),
        file.level(3, True, [(e, True) for e in rims[1]], [sunk, foot]),
        file.level(0, False, [(e, True) for e in rims[0]], [drilled, brim])]
    file.product("pressed plate", file.add(f"CLOSED_SHELL('',({','.join(faces)}))"))
    return file.text()


def channel_profile(width, height, thickness, radius):
    """A U, outside `width` wide and `height` high. Flat length: width + 2 height − 4 (t + r) + π (r + k t)."""
    w, h, t, s = width, height, thickness, thickness + radius
    return (s, 0.0), [Line((w - s, 0.0)), Arc((w, s), (w - s, s), True), Line((w, h)), Line((w - t, h)), Line((w - t, s)),
                      Arc((w - s, t), (w - s, s), False), Line((s, t)), Arc((t, s), (s, s), False), Line((t, h)), Line((0.0, h)),
                      Line((0.0, s)), Arc((s, 0.0), (s, s), True)]


def strip_profile(thickness, *moves):
    """A strip that is bent to its left: lengths of flanges, and (inside radius, degrees) of bends."""
    outside, inside = [], []
    at, way = (0.0, 0.0), 0.0

    def across(off):
        return (at[0] - off * math.sin(way), at[1] + off * math.cos(way))

    starts = [(across(0.0), across(thickness))]
    for move in moves:
        center = None
        if isinstance(move, tuple):
            radius, turn = move[0], math.radians(move[1])
            center = across(thickness + radius)
            way += turn
            at = (center[0] + (thickness + radius) * math.sin(way), center[1] - (thickness + radius) * math.cos(way))
        else:
            at = (at[0] + move * math.cos(way), at[1] + move * math.sin(way))
        starts.append((across(0.0), across(thickness)))
        outside.append(Arc(starts[-1][0], center, True) if center else Line(starts[-1][0]))
        inside.append(Arc(starts[-2][1], center, False) if center else Line(starts[-2][1]))
    return starts[0][0], [*outside, Line(starts[-1][1]), *reversed(inside), Line(starts[0][0])]


def curled():
    """Two flanges with a bend of 120° between them, and a curl of 200° at the end."""
    file = StepFile()
    file.product("curled", file.prism(*strip_profile(2.0, 30.0, (2.0, 120.0), 20.0, (3.0, 200.0)), 40.0))
    return file.text()


class Lying(StepFile):
    """Prisms drawn out along x, their profiles in (y, z), with vertical holes."""

    lies = False

    def point(self, p):
        return super().point((p[2], p[0], p[1]) if self.lies else p)

    def direction(self, d):
        return super().direction((d[2], d[0], d[1]) if self.lies else d)


def perforated_channel(width=280.0, height=30.0, thickness=2.0, radius=2.0, depth=420.0, holes=(), hole=2.5):
    """A channel along x, its base at z = 0 to `thickness`, y from 0 to `width`; round `holes` (x, y) of radius `hole` in the base."""
    file = Lying()
    walls, rings = [], {}
    for center in holes:
        low, high = file.ring(center, 0.0, hole), file.ring(center, thickness, hole)
        axis = file.placement((*center, 0.0), (0, 0, 1), (1, 0, 0))
        walls.append(file.round_wall(file.add(f"CYLINDRICAL_SURFACE('',{axis},{hole:.12f})"), low, high, False))
        rings[center] = (file._bound("FACE_BOUND", [(low[0], True)]), file._bound("FACE_BOUND", [(high[0], False)]))
    file.lies = True
    shell = file.prism(*channel_profile(width, height, thickness, radius), depth)
    # The base has its holes: its faces are those of the first side and of the seventh.
    faces = [int(f[1:]) for f in file.entities[int(shell[1:]) - 1].split("(")[2].rstrip(")").split(",")]
    for side, level in ((0, 0), (6, 1)):
        file.entities[faces[side] - 1] = file.entities[faces[side] - 1].replace(
            "),", "".join(f",{bounds[level]}" for bounds in rings.values()) + "),", 1)
    file.entities[int(shell[1:]) - 1] = f"CLOSED_SHELL('',({','.join([f'#{f}' for f in faces] + walls)}))"
    file.lies = False
    file.product("perforated channel", shell)
    return file.text()


def thousand_openings():
    """A channel with 40 × 25 holes of Ø 5 at a pitch of 10."""
    return perforated_channel(holes=[(15.0 + 10 * i, 20.0 + 10 * j) for i in range(40) for j in range(25)])


def lanced(slit=0.01):
    """A plate of 80 × 50 × 2 mm, a tab of 20 mm bent up out of a side with R 2, between slits 12 mm deep to its tangent line."""
    return step_text("lanced", [("lanced", tab_plate(2, 2, 80, 50, 20, 25, slit, 12, 90, True).solid, False)])


def surface_only():
    file = StepFile()
    shell = file.prism(*rectangle_profile(30.0, 20.0), 10.0)
    file.product("skin", shell, entity="SHELL_BASED_SURFACE_MODEL")
    return file.text()


def angle_beside_a_skin():
    """An angle, and a shell that belongs to no solid."""
    file = StepFile()
    file.product("angle", file.prism(*angle_profile(50.0, 2.0, 2.0), 60.0))
    file.product("skin", file.prism(*rectangle_profile(30.0, 20.0), 10.0, at=(100, 0, 0)),
                 entity="SHELL_BASED_SURFACE_MODEL")
    return file.text()


def two_angles_and_a_block():
    """Two identical angles, one other angle and a block: three different bodies, four pieces."""
    file = StepFile()
    same = angle_profile(50.0, 2.0, 2.0)
    file.product("angle", file.prism(*same, 60.0))
    file.product("angle copy", file.prism(*same, 60.0, at=(100.0, 20.0, -7.0)))
    file.product("door, \"left\"", file.prism(*angle_profile(40.0, 1.5, 3.0), 25.0, at=(300, 0, 0)))
    file.product("block", file.prism(*rectangle_profile(30.0, 30.0), 30.0, at=(500, 0, 0)))
    return file.text()


def two_angles_one_short():
    """A block, an angle, and an angle whose legs are shorter than a die takes."""
    file = StepFile()
    file.product("block", file.prism(*rectangle_profile(20.0, 30.0), 30.0))
    file.product("angle", file.prism(*angle_profile(30.0, 2.0, 2.0), 40.0, at=(0, 200, 0)))
    file.product("short", file.prism(*angle_profile(4.3, 2.0, 2.0), 40.0, at=(0, 400, 0)))
    return file.text()


def assembly_of_sixty():
    """Angles of sizes of their own, each seventh body, from the fourth, a block."""
    file = StepFile()
    for i in range(60):
        at = (0, 200 * i, 0)
        if i % 7 == 3:
            file.product(f"block {i + 1}", file.prism(*rectangle_profile(20.0 + i, 30.0), 30.0, at=at))
        else:
            profile = angle_profile(30.0 + i, 1.0 + i % 3, 1.0 + i % 3)
            file.product(f"bracket {i + 1}", file.prism(*profile, 40.0 + 3 * i, at=at))
    return file.text()


def assembly_of_file(part, uses=2):
    """An assembly of one product whose shape is in another file, `uses` times 100 mm apart."""
    file = StepFile()
    context = file.add(f"PRODUCT_CONTEXT('',{file.application},'mechanical')")
    design = file.add(
        f"PRODUCT_DEFINITION_CONTEXT('part definition',{file.application},'design')")

    def product(name):
        product = file.add(f"PRODUCT('{name}','{name}','',({context}))")
        formation = file.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        return file.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")

    def shape(name, definition, placements):
        representation = file.add(
            f"SHAPE_REPRESENTATION('{name}',({','.join(placements)}),{file.context})")
        of = file.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        file.add(f"SHAPE_DEFINITION_REPRESENTATION({of},{representation})")
        return representation

    def placement(x):
        return file.placement((x, 0, 0), (0, 0, 1), (1, 0, 0))

    whole, child = product("assembly"), product("child")
    places = [placement(100.0 * i) for i in range(uses)]
    origin = placement(0.0)
    whole_shape = shape("assembly", whole, places)
    child_shape = shape("child", child, [origin])
    kind = file.add("DOCUMENT_TYPE('')")
    document = file.add(f"DOCUMENT_FILE('{part}','','',{kind},'',$)")
    role = file.add("IDENTIFICATION_ROLE('external document id and location',$)")
    source = file.add("EXTERNAL_SOURCE(IDENTIFIER(''))")
    file.add(f"APPLIED_DOCUMENT_REFERENCE({document},'',({child}))")
    file.add(f"APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT('{part}',{role},{source},({document}))")
    for i, place in enumerate(places):
        use = file.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{i}','use {i}','',{whole},{child},$)")
        of = file.add(f"PRODUCT_DEFINITION_SHAPE('','',{use})")
        there = file.add(f"ITEM_DEFINED_TRANSFORMATION('','',{origin},{place})")
        relation = file.add(f"(REPRESENTATION_RELATIONSHIP('','',{child_shape},{whole_shape})"
                            f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({there})"
                            "SHAPE_REPRESENTATION_RELATIONSHIP())")
        file.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{of})")
    return file.text()


def deep_channel(leg=250):
    """Plates whose legs cannot pass the upper beam of a press brake, whichever is bent first."""
    upright = lambda x: [[x, 0, 5], [x, 100, 5], [x, 100, leg], [x, 0, leg]]
    return {"thickness": 2, "defaults": {"inside_radius": 2},
            "plates": [{"id": "web", "outline": [[5, 0, 0], [55, 0, 0], [55, 100, 0], [5, 100, 0]]},
                       {"id": "left", "outline": upright(0)}, {"id": "right", "outline": upright(60)}],
            "bends": [{"between": ["web", "left"]}, {"between": ["web", "right"]}]}
