"""Sheets of one thickness in space: flat, cylindrical and conical patches, each with a border in its
own plane coordinates (u, v), thickened along its normal. All cut edges are square to the sheet.
Nothing here unfolds anything; a flat pattern is never computed from a patch."""

import dataclasses
import math

from .solid import Arc, Cone, Cylinder, Line, Plane, Ruled, Solid, spline_through
from .vectors import add, combine, cross, scale, sub, turned, unit

QUARTER = math.pi / 2


# ---- borders in (u, v)

@dataclasses.dataclass
class Side:
    """Straight in (u, v)."""
    start: tuple
    end: tuple


@dataclasses.dataclass
class Round:
    """An arc of less than a full turn, on flat patches: `sweep` > 0 is counter-clockwise."""
    start: tuple
    end: tuple
    center: tuple
    sweep: float


@dataclasses.dataclass
class Path:
    """Any curve on a cylindrical patch: `at(s)` and `slope(s)` give (u, v) and its derivative."""
    at: object
    slope: object
    begin: float
    finish: float
    pieces: int = 64

    @property
    def start(self):
        return self.at(self.begin)

    @property
    def end(self):
        return self.at(self.finish)


def polygon(*points):
    return [Side(p, q) for p, q in zip(points, points[1:] + points[:1])]


def rectangle(u0, v0, u1, v1):
    return polygon((u0, v0), (u1, v0), (u1, v1), (u0, v1))


def turned_round(loop):
    """The same loop run through backwards: an outline becomes an opening."""
    back = []
    for s in reversed(loop):
        if isinstance(s, Side):
            back.append(Side(s.end, s.start))
        elif isinstance(s, Round):
            back.append(Round(s.end, s.start, s.center, -s.sweep))
        else:
            back.append(Path(lambda x, s=s: s.at(-x),
                             lambda x, s=s: tuple(-d for d in s.slope(-x)),
                             -s.finish, -s.begin, s.pieces))
    return back


def circle(center, radius):
    """An outline; turn it round for a hole."""
    left, right = (center[0] - radius, center[1]), (center[0] + radius, center[1])
    return [Round(right, left, center, math.pi), Round(left, right, center, math.pi)]


def hole(center, radius):
    return turned_round(circle(center, radius))


def obround(center, length, width, angle=0.0):
    """An opening with half-round ends, `length` over all."""
    c, s, r, half = math.cos(angle), math.sin(angle), width / 2, (length - width) / 2

    def at(x, y):
        return (center[0] + c * x - s * y, center[1] + s * x + c * y)
    loop = [Side(at(-half, -r), at(half, -r)), Round(at(half, -r), at(half, r), at(half, 0), math.pi),
            Side(at(half, r), at(-half, r)), Round(at(-half, r), at(-half, -r), at(-half, 0), math.pi)]
    return turned_round(loop)


# ---- patches

@dataclasses.dataclass
class Frame:
    """u along x, v along y, thickness along n."""
    origin: tuple = (0.0, 0.0, 0.0)
    x: tuple = (1.0, 0.0, 0.0)
    y: tuple = (0.0, 1.0, 0.0)

    @property
    def n(self):
        return cross(self.x, self.y)

    def at(self, u, v, w=0.0):
        return combine((1, self.origin), (u, self.x), (v, self.y), (w, self.n))

    def rim(self, side):
        """The frame on a straight border of an outline: x leaves the patch, y runs along."""
        y = unit(sub(self.at(*side.end), self.at(*side.start)))
        return Frame(self.at(*side.start), cross(y, self.n), y)


class FlatPatch:
    def __init__(self, frame):
        self.frame = frame

    def point(self, u, v, w):
        return self.frame.at(u, v, w)

    def normal(self, u, v):
        return self.frame.n

    def curve(self, s, w):
        a, b = self.point(*s.start, w), self.point(*s.end, w)
        if isinstance(s, Side):
            return Line(a, b)
        axis = scale(self.frame.n, math.copysign(1.0, s.sweep))
        return Arc(a, b, self.point(*s.center, w), axis, abs(s.sweep))

    def skin(self, w):
        """(surface, whether its normal points along the thickness)."""
        return Plane(self.point(0, 0, w), self.frame.n, self.frame.x), True

    def wall(self, s, bottom, top):
        if isinstance(s, Side):
            return flat_wall(bottom, self.normal(*s.start))
        spoke = sub(bottom.start, bottom.center)
        radius = math.hypot(*spoke)
        return Cylinder(bottom.center, self.frame.n, unit(spoke), radius), s.sweep > 0


def flat_wall(bottom, normal):
    along = (sub(bottom.end, bottom.start) if isinstance(bottom, Line)
             else cross(bottom.axis, sub(bottom.start, bottom.center)))
    return Plane(bottom.start, unit(cross(along, normal)), unit(along)), True


class BendPatch:
    """A circular bend behind a rim: u is the angle turned through, v runs along the rim. `up` bends
    towards the normal. `radius` is that of the skin inside."""

    def __init__(self, rim, radius, up, thickness):
        self.rim, self.sign = rim, 1.0 if up else -1.0
        self.r0 = radius + (thickness if up else 0.0)
        self.center = combine((1, rim.origin), (self.sign * self.r0, rim.n))
        self.axis = scale(rim.y, -self.sign)

    def radius(self, w):
        return self.r0 - self.sign * w

    def spoke(self, u):
        return combine((-self.sign * math.cos(u), self.rim.n), (math.sin(u), self.rim.x))

    def point(self, u, v, w):
        return combine((1, self.center), (self.radius(w), self.spoke(u)), (v, self.rim.y))

    def normal(self, u, v):
        return scale(self.spoke(u), -self.sign)

    def behind(self, angle):
        """The rim at the far tangent line."""
        n = self.normal(angle, 0)
        return Frame(self.point(angle, 0, 0), cross(self.rim.y, n), self.rim.y)

    def curve(self, s, w):
        """None where the skin is a sharp edge."""
        if isinstance(s, Path):
            return self._spline(s, w)
        a, b = self.point(*s.start, w), self.point(*s.end, w)
        if s.start[0] == s.end[0]:
            return Line(a, b)
        if self.radius(w) < 1e-9:
            return None
        turn = s.end[0] - s.start[0]
        center = combine((1, self.center), (s.start[1], self.rim.y))
        return Arc(a, b, center, scale(self.axis, math.copysign(1.0, turn)), abs(turn))

    def _spline(self, s, w):
        step = (s.finish - s.begin) / s.pieces
        at = [s.begin + i * step for i in range(s.pieces + 1)]
        points = [self.point(*s.at(x), w) for x in at]
        slopes = [self._slope(s.at(x), s.slope(x), w) for x in at]
        return spline_through(points, slopes, step)

    def _slope(self, uv, duv, w):
        along = combine((self.sign * math.sin(uv[0]), self.rim.n), (math.cos(uv[0]), self.rim.x))
        return combine((duv[0] * self.radius(w), along), (duv[1], self.rim.y))

    def skin(self, w):
        if self.radius(w) < 1e-9:
            return None
        return Cylinder(self.center, self.axis, self.spoke(0), self.radius(w)), self.sign < 0

    def wall(self, s, bottom, top):
        if isinstance(s, Path):
            return Ruled(bottom, top), True
        if bottom is None:  # the same plane from the curve above
            return flat_wall(top, self.normal(*s.start))
        return flat_wall(bottom, self.normal(*s.start))


class ConePatch:
    """A conical bend behind a rim: u is the angle turned about the cone's axis, v runs along the
    ruling. `apex` is the distance along the lower skin from the cone's apex to the rim's origin."""

    def __init__(self, rim, half_angle, apex, up):
        self.rim, self.half_angle, self.up = rim, half_angle, up
        self.sign = 1.0 if up else -1.0
        self.apex = combine((1, rim.origin), (-apex, rim.y))
        self.axis = combine((math.cos(half_angle), rim.y), (self.sign * math.sin(half_angle), rim.n))

    def point(self, u, v, w):
        away = sub(self.rim.at(0, v, w), self.apex)
        return add(self.apex, turned(away, self.axis, -self.sign * u))

    def normal(self, u, v):
        return turned(self.rim.n, self.axis, -self.sign * u)

    def behind(self, angle):
        y = turned(self.rim.y, self.axis, -self.sign * angle)
        return Frame(self.point(angle, 0, 0), cross(y, self.normal(angle, 0)), y)

    def foot(self, p):
        """The point of the axis beside p."""
        away = sub(p, self.apex)
        height = sum(a * b for a, b in zip(away, self.axis))
        return combine((1, self.apex), (height, self.axis))

    def curve(self, s, w):
        a, b = self.point(*s.start, w), self.point(*s.end, w)
        if s.start[0] == s.end[0]:
            return Line(a, b)
        turn = s.end[0] - s.start[0]
        axis = scale(self.axis, -self.sign * math.copysign(1.0, turn))
        return Arc(a, b, self.foot(a), axis, abs(turn))

    def _cone(self, p, axis, half_angle):
        spoke = sub(p, self.foot(p))
        return Cone(self.foot(p), axis, unit(spoke), math.hypot(*spoke), half_angle)

    def skin(self, w):
        return self._cone(self.point(0, 0, w), self.axis, self.half_angle), self.sign < 0

    def wall(self, s, bottom, top):
        if s.start[0] == s.end[0]:
            return flat_wall(bottom, self.normal(*s.start))
        far = s.end[0] < s.start[0]  # an outline runs backwards along its far side
        back = scale(self.axis, -1.0)
        return self._cone(self.point(*s.start, 0), back, QUARTER - self.half_angle), far


# ---- the sheet

class ThickSheet:
    def __init__(self, thickness):
        self.thickness, self.patches = thickness, []

    def add(self, patch, *loops):
        self.patches.append((patch, loops))
        return patch

    def flat(self, frame, *loops):
        return self.add(FlatPatch(frame), *loops)

    def bend(self, rim, length, angle, radius, up):
        """A whole bend along a rim; gives the rim behind it."""
        patch = BendPatch(rim, radius, up, self.thickness)
        self.add(patch, rectangle(0, 0, angle, length))
        return patch.behind(angle)

    def wall_on(self, rim, length, angle, radius, up, height):
        """A bend and a rectangular wall; gives the wall's frame (u away from the bend)."""
        frame = self.bend(rim, length, angle, radius, up)
        self.flat(frame, rectangle(0, 0, height, length))
        return frame

    def solid(self):
        solid = Solid()
        strips = [_Strip(solid, patch, s, self.thickness)
                  for patch, loops in self.patches for loop in loops for s in loop]
        met = {}
        for strip in strips:
            met[strip.key] = met.get(strip.key, 0) + 1
        for strip in strips:
            if met[strip.key] == 1:
                strip.add_wall(solid)
        for patch, loops in self.patches:
            for w, top in ((0.0, False), (self.thickness, True)):
                self._add_skin(solid, patch, loops, w, top)
        return solid

    def _add_skin(self, solid, patch, loops, w, top):
        skin = patch.skin(w)
        if skin is None:
            return
        surface, along = skin
        curves = [[patch.curve(s, w) for s in loop] for loop in loops]
        rings = [[(c, True) for c in ring] if top else [(c, False) for c in reversed(ring)]
                 for ring in curves]
        solid.face(surface, along == top, rings)


class _Strip:
    """What stands on one piece of a border: a joint where two patches have it, else a cut edge."""

    def __init__(self, solid, patch, s, thickness):
        self.patch, self.s = patch, s
        self.bottom, self.top = patch.curve(s, 0.0), patch.curve(s, thickness)
        self.corners = [patch.point(*end, w) for end, w in
                        ((s.start, 0.0), (s.end, 0.0), (s.end, thickness), (s.start, thickness))]
        edges = [solid.edge(c)[0] if c else -1 for c in (self.bottom, self.top)]
        self.key = (*edges, frozenset(solid.vertex(p) for p in self.corners))

    def add_wall(self, solid):
        a, b, c, d = self.corners
        surface, outward = self.patch.wall(self.s, self.bottom, self.top)
        ring = [(self.bottom, True), (Line(b, c), True), (self.top, False), (Line(d, a), True)]
        solid.face(surface, outward, [[(curve, way) for curve, way in ring if curve is not None]])
