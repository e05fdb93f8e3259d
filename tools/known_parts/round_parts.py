"""Cones, and cylinders cut otherwise than straight."""

import math

from .part import Part
from .sizes import (Bend, Flat, annular_sector, ellipse_length, integral, neutral_radius,
                    smallest_rectangle_of_curve)
from .thick_sheet import BendPatch, ConePatch, Frame, Path, Side, ThickSheet, rectangle


class ConeSize:
    """A conical bend: half angle and turn about the axis in degrees; `apex` along the lower skin from
    the apex to the near end; `width` along the ruling. Developed (Monge; any book on pattern
    drafting): an annular sector of turn · sin ω between the radii at which the neutral cone ends.
    The ends are square to the sheet, so that on a skin d higher they lie d cot ω nearer to the apex
    where the cone is bent up, farther where down."""

    def __init__(self, thickness, half_angle, turn, apex, width, up):
        self.thickness, self.apex, self.width, self.up = thickness, apex, width, up
        self.half_angle, self.turn = math.radians(half_angle), math.radians(turn)

    def sector(self, rule):
        """(inner radius, angle) of the development."""
        k = rule.k(self.apex * math.tan(self.half_angle), self.thickness)
        height = self.thickness * (1 - k if self.up else k)  # of the neutral skin above the lower
        shift = height / math.tan(self.half_angle) * (-1 if self.up else 1)
        return self.apex + shift, self.turn * math.sin(self.half_angle)

    def patch(self, rim):
        return ConePatch(rim, self.half_angle, self.apex, self.up)

    def bend(self, flanges):
        """`angle`: between the flanges' normals, which make ω with the plane square to the axis."""
        angle = 0.0
        if flanges:
            s, c = math.sin(self.half_angle), math.cos(self.half_angle)
            angle = math.degrees(math.acos(s * s + c * c * math.cos(self.turn)))
            if self.turn > math.pi:
                angle = 360.0 - angle
        return Bend(angle, 0.0, self.width, self.up, measured=False)


def cone_joint(thickness, half_angle, turn, apex, width, first, second, direction="up"):
    cone = ConeSize(thickness, half_angle, turn, apex, width, direction == "up")
    sheet, outline = ThickSheet(thickness), rectangle(0, 0, first, width)
    sheet.flat(Frame(), outline)
    patch = cone.patch(Frame().rim(outline[1]))
    sheet.add(patch, rectangle(0, 0, cone.turn, width))
    sheet.flat(patch.behind(cone.turn), rectangle(0, 0, second, width))

    def flat(rule):
        near, angle = cone.sector(rule)
        far = near + width
        area, _, points = annular_sector(near, far, angle)
        contour = 2 * (first + second + width) + angle * (near + far)
        ends = [(near, -first), (far, -first)]
        c, s = math.cos(angle), math.sin(angle)
        ends += [(r * c - second * s, r * s + second * c) for r in (near, far)]
        return Flat(area + width * (first + second), contour,
                    smallest_rectangle_of_curve(points + ends))
    return Part("cone_joint", f"Two flanges with a conical bend {direction} between them.", thickness,
                sheet.solid(), flat, [cone.bend(flanges=True)])


def rolled_cone(thickness, half_angle, turn, apex, width):
    cone = ConeSize(thickness, half_angle, turn, apex, width, True)
    sheet = ThickSheet(thickness)
    sheet.add(cone.patch(Frame()), rectangle(0, 0, cone.turn, width))

    def flat(rule):
        near, angle = cone.sector(rule)
        area, contour, points = annular_sector(near, near + width, angle)
        return Flat(area, contour, smallest_rectangle_of_curve(points))
    return Part("rolled_cone", f"A truncated cone rolled through {turn:g}°.", thickness, sheet.solid(),
                flat, [cone.bend(flanges=False)])


def cut_tube(family, text, thickness, radius, turn, low, high):
    """A rolled cylinder whose ends are curves: `low` and `high` are (height, slope) over the angle
    in radians, measured from the middle of the roll. Developed: the same heights over arc length."""
    alpha = math.radians(turn)
    middle = alpha / 2
    patch = BendPatch(Frame(), radius, True, thickness)

    def path(end, begin, finish):
        sign = 1.0 if finish > begin else -1.0
        return Path(lambda s: (sign * s, end[0](sign * s - middle)),
                    lambda s: (sign, sign * end[1](sign * s - middle)), sign * begin, sign * finish, 96)
    bottom, top = path(low, 0.0, alpha), path(high, alpha, 0.0)
    sheet = ThickSheet(thickness)
    sheet.add(patch, [bottom, Side(bottom.end, top.start), top, Side(top.end, bottom.start)])

    def flat(rule):
        rho = neutral_radius(radius, thickness, rule)
        area = rho * integral(lambda a: high[0](a) - low[0](a), -middle, middle)
        contour = sum(high[0](a) - low[0](a) for a in (-middle, middle))
        contour += sum(integral(lambda a, end=end: math.hypot(rho, end[1](a)), -middle, middle)
                       for end in (low, high))
        at = [-middle + alpha * i / 3000 for i in range(3001)]
        points = [(rho * a, end[0](a)) for a in at for end in (low, high)]
        return Flat(area, contour, smallest_rectangle_of_curve(points))
    bend = Bend(turn, radius, high[0](0.0) - low[0](0.0))
    return Part(family, text, thickness, sheet.solid(), flat, [bend])


STRAIGHT = (lambda a: 0.0, lambda a: 0.0)


def oblique_half_tube(thickness, radius, height, rise):
    """A half tube cut obliquely: develops to a cosine. Its length is that of half the ellipse with
    semi-axes ρ and √(ρ² + rise²), its area ρ π · height: both checked here against the integrals."""
    high = (lambda a: height + rise * math.sin(a), lambda a: rise * math.cos(a))
    part = cut_tube("oblique_half_tube", "Half a tube, one end cut obliquely: a sinusoid when flat.",
                    thickness, radius, 180.0, STRAIGHT, high)
    by_integrals = part.flat

    def flat(rule):
        rho, found = neutral_radius(radius, thickness, rule), by_integrals(rule)
        half = ellipse_length(rho, math.hypot(rho, rise)) / 2
        contour = math.pi * rho + 2 * height + half
        assert math.isclose(found.area, math.pi * rho * height, rel_tol=1e-11)
        assert math.isclose(found.outer, contour, rel_tol=1e-11)
        return Flat(math.pi * rho * height, contour, found.size)
    part.flat = flat
    return part


def elbow_gore(thickness, radius, turn, height, rise):
    """A segment of a tube elbow: both ends cut obliquely, against each other."""
    high = (lambda a: height + rise * math.cos(a), lambda a: -rise * math.sin(a))
    low = (lambda a: -rise * math.cos(a), lambda a: rise * math.sin(a))
    return cut_tube("elbow_gore", "A segment of an elbow: both ends of the tube cut obliquely.",
                    thickness, radius, turn, low, high)


def saddle_tube(thickness, radius, turn, height, main_radius):
    """A branch that sits on a pipe: its end at H − √(R² − (r sin a)²), r its inside radius."""
    def depth(a):
        return math.sqrt(main_radius ** 2 - (radius * math.sin(a)) ** 2)
    high = (lambda a: height - depth(a),
            lambda a: radius ** 2 * math.sin(a) * math.cos(a) / depth(a))
    return cut_tube("saddle_tube", "A branch pipe, its end cut to sit on a wider pipe.", thickness,
                    radius, turn, STRAIGHT, high)
