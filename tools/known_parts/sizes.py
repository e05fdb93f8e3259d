"""What textbooks say about the size of a blank: bend allowance, DIN 6935, developed cones and
cylinders, and the smallest rectangle around an outline. Nothing here sees a solid."""

import dataclasses
import math


# ---- K-factors

@dataclasses.dataclass
class Rule:
    """Where K comes from: a constant, or DIN 6935."""
    name: str
    constant: float = None

    def k(self, radius, thickness):
        """None where the rule says nothing: DIN 6935 with a sharp inside edge."""
        if self.constant is not None:
            return self.constant
        ratio = radius / thickness
        if ratio < 0.1:
            return None
        # DIN 6935: the factor k of the standard counts half the thickness, K counts all of it.
        return 0.5 * (1.0 if ratio > 5 else 0.65 + 0.5 * math.log10(ratio))


RULES = [Rule("k=0.44", 0.44), Rule("k=0.33", 0.33), Rule("k=0.5", 0.5), Rule("din6935")]
MIDDLE = RULES[2]  # lengths of the middle of the sheet are true, so that area × thickness = volume


def neutral_radius(radius, thickness, rule):
    """Of the neutral line of a bend: r + K t."""
    return radius + rule.k(radius, thickness) * thickness


@dataclasses.dataclass
class Bend:
    """`angle`: degrees that the sheet is turned through; `radius` inside; `length` along the line."""
    angle: float
    radius: float
    length: float
    up: bool = True
    measured: bool = True  # False: allowance and radius vary along the bend

    def allowance(self, thickness, rule):
        return math.radians(self.angle) * neutral_radius(self.radius, thickness, rule)

    def deduction(self, thickness, rule):
        """Both legs to where the outsides meet, less the allowance; they must meet."""
        set_back = (self.radius + thickness) * math.tan(math.radians(self.angle) / 2)
        return 2 * set_back - self.allowance(thickness, rule)


# ---- flat patterns

@dataclasses.dataclass
class Flat:
    area: float
    outer: float  # length of the outer contour
    size: tuple = None  # of the smallest rectangle around it, longer side first; None: not unique
    openings: list = dataclasses.field(default_factory=list)  # length of each contour


def rectangle_flat(length, width):
    return Flat(length * width, 2 * (length + width), tuple(sorted((length, width), reverse=True)))


def circle_opening(radius):
    """(area, length of the contour), as the two below."""
    return math.pi * radius ** 2, 2 * math.pi * radius


def obround_opening(length, width):
    straight = length - width
    return straight * width + math.pi * width ** 2 / 4, 2 * straight + math.pi * width


def ellipse_opening(a, b):
    return math.pi * a * b, ellipse_length(a, b)


def with_openings(flat, openings):
    return dataclasses.replace(flat, area=flat.area - sum(area for area, _ in openings),
                               openings=flat.openings + [length for _, length in openings])


def ellipse_length(a, b):
    """2π (M₂ of the arithmetic-geometric mean), after Gauss: exact to rounding."""
    x, y = max(a, b), min(a, b)
    total, power = (x * x + y * y) / 2, 0.5
    while x - y > 1e-15 * x:
        x, y, half = (x + y) / 2, math.sqrt(x * y), (x - y) / 2
        power *= 2
        total -= power * half * half
    return 2 * math.pi * total / ((x + y) / 2)


def integral(f, a, b, panels=4000):
    """Simpson's rule; f is smooth."""
    h = (b - a) / panels
    inner = sum((4 if i % 2 else 2) * f(a + i * h) for i in range(1, panels))
    return (f(a) + inner + f(b)) * h / 3


# ---- the smallest rectangle around points

def hull(points):
    points = sorted(set(points))

    def half(run):
        chain = []
        for p in run:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    return half(points) + half(points[::-1])


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _extent(points, angle):
    c, s = math.cos(angle), math.sin(angle)
    along = [c * x + s * y for x, y in points]
    across = [c * y - s * x for x, y in points]
    return max(along) - min(along), max(across) - min(across)


def smallest_rectangle(points):
    """Of straight-sided outlines: one side lies on a side of the hull (Freeman and Shapira)."""
    ring = hull(points)
    sizes = []
    for p, q in zip(ring, ring[1:] + ring[:1]):
        width, height = _extent(ring, math.atan2(q[1] - p[1], q[0] - p[0]))
        sizes.append((width * height, tuple(sorted((width, height), reverse=True))))
    return _only(sizes)


def smallest_rectangle_of_curve(points):
    """Of outlines with curved sides, as many points on them: the same over all directions."""
    ring = hull(points)
    few, steps = _coarse(ring), 180
    step = math.pi / 2 / steps

    def area(angle, ring=ring):
        width, height = _extent(ring, angle)
        return width * height
    values = [area(i * step, few) for i in range(steps)]
    sizes = []
    for i, value in enumerate(values):
        if value <= values[i - 1] and value <= values[(i + 1) % steps]:
            angle = _golden(area, (i - 1) * step, (i + 1) * step)
            sizes.append((area(angle), tuple(sorted(_extent(ring, angle), reverse=True))))
    return _only(sizes)


def _coarse(ring):
    """About 400 of the points, and every end of a long side."""
    every, around = 1 + len(ring) // 400, sum(math.dist(p, q) for p, q in zip(ring, ring[1:]))
    long = 4 * around / len(ring)
    return [p for i, p in enumerate(ring)
            if i % every == 0 or math.dist(p, ring[i - 1]) > long
            or math.dist(p, ring[(i + 1) % len(ring)]) > long]


def _golden(f, a, b):
    ratio = (math.sqrt(5) - 1) / 2
    while b - a > 1e-9:
        c, d = b - ratio * (b - a), a + ratio * (b - a)
        a, b = (a, d) if f(c) < f(d) else (c, b)
    return (a + b) / 2


def _only(sizes):
    """The size of least area, unless another of about that area differs."""
    least, size = min(sizes)
    rivals = [s for area, s in sizes if area < least * (1 + 1e-4) and abs(s[0] - size[0]) > 1e-3]
    return None if rivals else size


def annular_sector(inner, outer, angle, count=4000):
    """(area, length of the contour, points on it)."""
    at = [i * angle / count for i in range(count + 1)]
    points = [(r * math.cos(a), r * math.sin(a)) for r in (inner, outer) for a in at]
    area = angle / 2 * (outer ** 2 - inner ** 2)
    return area, angle * (inner + outer) + 2 * (outer - inner), points
