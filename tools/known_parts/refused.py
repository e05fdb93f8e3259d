"""Solids that no blank of one thickness bends into, with the reasons that are right."""

import math

from .part import Part
from .solid import Arc, Plane, Solid, Sphere
from .strips import prism
from .thick_sheet import Frame, Round, Side, ThickSheet, circle, hole, polygon, rectangle, turned_round


def refusal(family, text, thickness, solid, *reasons):
    return Part(family, text, thickness, solid, refused=list(reasons))


def block(side):
    return refusal("block", "A solid cube.", None, prism(rectangle(0, 0, side, side), side),
                   "not_a_sheet")


def round_tube(thickness, radius, length):
    return refusal("round_tube", "A round tube without a seam: there is no cut to open it by.",
                   thickness, prism(circle((0, 0), radius + thickness), length,
                                    hole((0, 0), radius)), "closed_loop")


def round_rectangle(x, y, radius):
    """Half sides x and y."""
    r, quarter = radius, math.pi / 2
    return [Side((r - x, -y), (x - r, -y)), Round((x - r, -y), (x, r - y), (x - r, r - y), quarter),
            Side((x, r - y), (x, y - r)), Round((x, y - r), (x - r, y), (x - r, y - r), quarter),
            Side((x - r, y), (r - x, y)), Round((r - x, y), (-x, y - r), (r - x, y - r), quarter),
            Side((-x, y - r), (-x, r - y)), Round((-x, r - y), (r - x, -y), (r - x, r - y), quarter)]


def box_tube(thickness, radius, width, height, length):
    x, y, t = width / 2, height / 2, thickness
    inside = turned_round(round_rectangle(x - t, y - t, radius))
    return refusal("box_tube", "A rectangular tube without a seam.", thickness,
                   prism(round_rectangle(x, y, radius + t), length, inside), "closed_loop")


def dome(thickness, radius):
    """Half a hollow sphere: curved in two directions."""
    solid, origin, z = Solid(), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)

    def rim(r):
        a, b = (r, 0.0, 0.0), (-r, 0.0, 0.0)
        return [Arc(a, b, origin, z, math.pi), Arc(b, a, origin, z, math.pi)]
    outer, inner = rim(radius + thickness), rim(radius)
    solid.face(Sphere(origin, z, (1, 0, 0), radius + thickness), True, [outer])
    solid.face(Sphere(origin, z, (1, 0, 0), radius), False,
               [[(c, False) for c in reversed(inner)]])
    solid.face(Plane(origin, (0, 0, -1), (1, 0, 0)), True,
               [[(c, False) for c in reversed(outer)], inner])
    return refusal("dome", "Half a hollow sphere.", thickness, solid, "doubly_curved")


def uneven_angle(first, second, leg, depth):
    outline = polygon((0, 0), (leg, 0), (leg, first), (second, first), (second, leg), (0, leg))
    return refusal("uneven_angle", f"An angle with legs {first:g} and {second:g} mm thick.", None,
                   prism(outline, depth), "thickness_not_constant", "not_a_sheet")


def wedge(thin, thick, length, depth):
    outline = polygon((0, 0), (length, 0), (length, thick), (0, thin))
    return refusal("wedge", f"A plate {thin:g} mm thick at one end, {thick:g} mm at the other.", None,
                   prism(outline, depth), "thickness_not_constant", "not_a_sheet")


def tee(thickness, width, height, depth):
    x, t = width / 2, thickness
    outline = polygon((-x, 0), (x, 0), (x, t), (t / 2, t), (t / 2, height), (-t / 2, height),
                      (-t / 2, t), (-x, t))
    return refusal("tee", "A T profile: three plates meet in one line.", thickness,
                   prism(outline, depth), "not_a_sheet", "thickness_not_constant")


def shelled_box(thickness, length, width, height):
    """Walls closed around their corners, as a drawn or a shelled box has them."""
    a, b, c, t = length, width, height, thickness

    def ring(x0, y0, x1, y1, z):
        return [(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)]
    low, top = ring(0, 0, a, b, 0), ring(0, 0, a, b, c)
    floor, mouth = ring(t, t, a - t, b - t, t), ring(t, t, a - t, b - t, c)
    solid = Solid()
    solid.polygon(low[::-1])
    solid.polygon(floor)
    solid.polygon(top, mouth[::-1])
    for i in range(4):
        j = (i + 1) % 4
        solid.polygon([low[i], low[j], top[j], top[i]])
        solid.polygon([floor[j], floor[i], mouth[i], mouth[j]])
    return refusal("shelled_box", "A box whose walls are closed around the corners.", thickness, solid,
                   "closed_loop", "doubly_curved")


def crossing_walls(thickness, radius, length, notch, height):
    """Two walls beside a corner that points in: each would be cut from where the other lies."""
    a, n = length, notch
    outline = polygon((0, 0), (a, 0), (a, n), (n, n), (n, a), (0, a))
    sheet, base = ThickSheet(thickness), Frame()
    sheet.flat(base, outline)
    for side in (2, 3):
        sheet.wall_on(base.rim(outline[side]), a - n, math.pi / 2, radius, True, height)
    return refusal("crossing_walls", "Two walls beside a re-entrant corner need the same place of the "
                   "blank.", thickness, sheet.solid(), "overlap")
