"""Solids as STEP text (AP214), written from the entity definitions of ISO 10303-42, without a CAD
kernel. Every solid is a product of its own, in millimetres or in inches."""

from .solid import Arc, Cone, Cylinder, Line, Plane, Ruled, Sphere
from .vectors import scale, sub, unit

HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('parts of known size'),'2;1');
FILE_NAME('{name}','2026-01-01T00:00:00',(''),(''),'known_parts','known_parts','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
"""
MM_PER_INCH = 25.4


def number(x):
    """A REAL of ISO 10303-21: always with a point, the exponent in capitals."""
    mantissa, _, exponent = f"{x + 0.0:.15G}".partition("E")
    point = "" if "." in mantissa else "."
    return mantissa + point + (f"E{exponent}" if exponent else "")


def numbers(values):
    return ",".join(number(0.0 if abs(v) < 1e-15 else v) for v in values)


class StepText:
    def __init__(self, name):
        self.name, self.entities, self.known = name, [], {}
        self.unit = 1.0  # mm
        self.application = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('','automotive_design',2000,{self.application})")

    def add(self, entity):
        self.entities.append(entity)
        return f"#{len(self.entities)}"

    def once(self, entity):
        if entity not in self.known:
            self.known[entity] = self.add(entity)
        return self.known[entity]

    def text(self):
        lines = [f"#{i}={entity};" for i, entity in enumerate(self.entities, 1)]
        return HEADER.format(name=self.name) + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"

    # ---- units and products

    def _context(self, inch):
        length = self.once("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
        if inch:
            factor = self.once(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{length})")
            powers = self.once("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            length = self.once(f"(CONVERSION_BASED_UNIT('INCH',{factor})LENGTH_UNIT()"
                               f"NAMED_UNIT({powers}))")
        rad = self.once("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        sr = self.once("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        near = self.once(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{length},'','')")
        return self.once("(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
                         f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({near}))"
                         f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{rad},{sr}))"
                         "REPRESENTATION_CONTEXT('',''))")

    def product(self, name, solid, inch=False):
        self.unit = MM_PER_INCH if inch else 1.0
        self.known = {}
        context = self._context(inch)
        body = self.add(f"MANIFOLD_SOLID_BREP('{name}',{self._shell(solid)})")
        axes = self._place((0, 0, 0), (0, 0, 1), (1, 0, 0))
        shape = self.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('{name}',({axes},{body}),{context})")
        kind = self.add(f"PRODUCT_CONTEXT('',{self.application},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({kind}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        design = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{self.application},"
                          "'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
        of = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({of},{shape})")

    # ---- geometry

    def _point(self, p):
        return self.once(f"CARTESIAN_POINT('',({numbers(scale(p, 1 / self.unit))}))")

    def _direction(self, d):
        return self.once(f"DIRECTION('',({numbers(unit(d))}))")

    def _place(self, origin, axis, ref):
        return self.once(f"AXIS2_PLACEMENT_3D('',{self._point(origin)},{self._direction(axis)},"
                         f"{self._direction(ref)})")

    def _radius(self, r):
        return number(r / self.unit)

    def _curve(self, c):
        if isinstance(c, Line):
            along = sub(c.end, c.start)
            vector = self.once(f"VECTOR('',{self._direction(along)},1.)")
            return self.add(f"LINE('',{self._point(c.start)},{vector})")
        if isinstance(c, Arc):
            spoke = sub(c.start, c.center)
            place = self._place(c.center, c.axis, spoke)
            radius = sum(x * x for x in spoke) ** 0.5
            return self.add(f"CIRCLE('',{place},{self._radius(radius)})")
        points = ",".join(self._point(p) for p in c.controls)
        return self.add(f"B_SPLINE_CURVE_WITH_KNOTS('',3,({points}),.UNSPECIFIED.,.F.,.F.,"
                        f"{self._knots(c)},.UNSPECIFIED.)")

    def _knots(self, spline):
        pieces = spline.pieces()
        multiplicities = ",".join(["4"] + ["3"] * (pieces - 1) + ["4"])
        return f"({multiplicities}),({numbers(range(pieces + 1))})"

    def _surface(self, s):
        if isinstance(s, Ruled):
            rows = ",".join(f"({self._point(p)},{self._point(q)})"
                            for p, q in zip(s.first.controls, s.second.controls))
            knots_u, knots_v = self._knots(s.first).split("),(")
            return self.add(f"B_SPLINE_SURFACE_WITH_KNOTS('',3,1,({rows}),.UNSPECIFIED.,.F.,.F.,"
                            f".F.,{knots_u}),(2,2),({knots_v},(0.,1.),.UNSPECIFIED.)")
        if isinstance(s, Plane):
            return self.add(f"PLANE('',{self._place(s.origin, s.normal, s.ref)})")
        place = self._place(s.origin, s.axis, s.ref)
        if isinstance(s, Cone):
            return self.add(f"CONICAL_SURFACE('',{place},{self._radius(s.radius)},"
                            f"{number(s.half_angle)})")
        kind = {Cylinder: "CYLINDRICAL_SURFACE", Sphere: "SPHERICAL_SURFACE"}[type(s)]
        return self.add(f"{kind}('',{place},{self._radius(s.radius)})")

    # ---- topology

    def _shell(self, solid):
        vertices = [self.add(f"VERTEX_POINT('',{self._point(p)})") for p in solid.vertices]
        edges = [self.add(f"EDGE_CURVE('',{vertices[a]},{vertices[b]},{self._curve(curve)},.T.)")
                 for a, b, _, curve in solid.edges]
        faces = ",".join(self._face(face, edges) for face in solid.faces)
        return self.add(f"CLOSED_SHELL('',({faces}))")

    def _face(self, face, edges):
        bounds = []
        for loop in face.loops:
            ring = [self.add(f"ORIENTED_EDGE('',*,*,{edges[i]},.{'T' if forward else 'F'}.)")
                    for i, forward in loop]
            kind = "FACE_BOUND" if bounds else "FACE_OUTER_BOUND"
            loop = self.add(f"EDGE_LOOP('',({','.join(ring)}))")
            bounds.append(self.add(f"{kind}('',{loop},.T.)"))
        sense = "T" if face.outward else "F"
        return self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{self._surface(face.surface)},"
                        f".{sense}.)")


def step_text(name, products):
    """`products`: (name, solid, in inches)."""
    text = StepText(name)
    for part in products:
        text.product(*part)
    return text.text()


