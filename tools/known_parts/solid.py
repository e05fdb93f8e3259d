"""A solid as faces, edges and vertices that share each other: what a STEP file holds. It knows
curves and surfaces by their equations and computes nothing but which edges are the same."""

import dataclasses
import math

from .vectors import add, combine, cross, scale, sub, unit

SAME = 1e-7  # mm: points closer than this are one vertex


# ---- curves, each running from its start to its end

@dataclasses.dataclass
class Line:
    start: tuple
    end: tuple

    def middle(self):
        return scale(add(self.start, self.end), 0.5)


@dataclasses.dataclass
class Arc:
    """Less than a full turn, counter-clockwise about `axis`."""
    start: tuple
    end: tuple
    center: tuple
    axis: tuple
    sweep: float

    def at(self, angle):
        spoke = sub(self.start, self.center)
        return combine((1, self.center), (math.cos(angle), spoke),
                       (math.sin(angle), cross(self.axis, spoke)))

    def middle(self):
        return self.at(self.sweep / 2)


@dataclasses.dataclass
class Spline:
    """Cubic Bézier pieces, three control points a piece and the last end."""
    controls: list

    @property
    def start(self):
        return self.controls[0]

    @property
    def end(self):
        return self.controls[-1]

    def pieces(self):
        return (len(self.controls) - 1) // 3

    def middle(self):
        at = 3 * (self.pieces() // 2)
        return self.controls[at]


def spline_through(points, slopes, step):
    """The cubic pieces with these points and derivatives at parameters `step` apart."""
    controls = [points[0]]
    for p, q, dp, dq in zip(points, points[1:], slopes, slopes[1:]):
        controls += [combine((1, p), (step / 3, dp)), combine((1, q), (-step / 3, dq)), q]
    return Spline(controls)


# ---- surfaces; `outward` of a face says whether the surface's own normal leaves the solid

@dataclasses.dataclass
class Plane:
    origin: tuple
    normal: tuple
    ref: tuple


@dataclasses.dataclass
class Cylinder:
    origin: tuple
    axis: tuple
    ref: tuple
    radius: float


@dataclasses.dataclass
class Cone:
    """Opens along `axis`; `radius` at the origin."""
    origin: tuple
    axis: tuple
    ref: tuple
    radius: float
    half_angle: float


@dataclasses.dataclass
class Sphere:
    origin: tuple
    axis: tuple
    ref: tuple
    radius: float


@dataclasses.dataclass
class Ruled:
    """Straight lines between two splines with equally many pieces."""
    first: Spline
    second: Spline


@dataclasses.dataclass
class Face:
    surface: object
    outward: bool
    loops: list  # of (edge index, forward), the face on the left seen from outside


class Solid:
    def __init__(self):
        self.vertices, self.edges, self.faces = [], [], []
        self._middles = []

    def _index(self, points, p):
        for i, q in enumerate(points):
            if math.dist(p, q) < SAME:
                return i
        points.append(p)
        return len(points) - 1

    def vertex(self, p):
        return self._index(self.vertices, p)

    def edge(self, curve):
        """(edge, forward): the edge that lies there already, or a new one."""
        a, b = self.vertex(curve.start), self.vertex(curve.end)
        middle = self._index(self._middles, curve.middle())
        for i, (c, d, m, _) in enumerate(self.edges):
            if m == middle and {a, b} == {c, d}:
                return i, (a, b) == (c, d)
        self.edges.append((a, b, middle, curve))
        return len(self.edges) - 1, True

    def face(self, surface, outward, loops):
        """`loops` of curves or of (curve, forward)."""
        self.faces.append(Face(surface, outward, [[self._directed(c) for c in loop]
                                                  for loop in loops]))

    def _directed(self, curve):
        if not isinstance(curve, tuple):
            return self.edge(curve)
        index, forward = self.edge(curve[0])
        return index, forward == curve[1]

    def polygon(self, *loops):
        """A flat face with straight edges, counter-clockwise from outside; holes clockwise."""
        a, b = loops[0][0], loops[0][1]
        area = (0.0, 0.0, 0.0)
        for p, q in zip(loops[0], loops[0][1:] + loops[0][:1]):
            area = add(area, cross(sub(p, a), sub(q, a)))
        plane = Plane(a, unit(area), unit(sub(b, a)))
        self.face(plane, True, [[Line(p, q) for p, q in zip(loop, loop[1:] + loop[:1])]
                                for loop in loops])

    def move(self, turn, shift):
        """Turns directions by `turn`, and points by it before they are shifted."""
        def point(p):
            return add(turn(p), shift)

        surfaces = [face.surface for face in self.faces]
        splines = [s for ruled in surfaces if isinstance(ruled, Ruled)
                   for s in (ruled.first, ruled.second)]
        curves = [edge[3] for edge in self.edges]
        for item in {id(item): item for item in curves + surfaces + splines}.values():
            for field in dataclasses.fields(item):
                value = getattr(item, field.name)
                if field.name in ("start", "end", "center", "origin"):
                    setattr(item, field.name, point(value))
                elif field.name in ("axis", "ref", "normal"):
                    setattr(item, field.name, turn(value))
                elif field.name == "controls":
                    item.controls = [point(p) for p in value]
        self.vertices = [point(p) for p in self.vertices]
        self._middles = [point(p) for p in self._middles]

    def open_edges(self):
        """Edges that are not met exactly once in each direction: none in a closed solid."""
        met = {}
        for face in self.faces:
            for loop in face.loops:
                for index, forward in loop:
                    met.setdefault(index, []).append(forward)
        return [i for i in range(len(self.edges)) if sorted(met.get(i, [])) != [False, True]]
