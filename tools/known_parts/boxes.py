"""Walls on the sides of a base: boxes, trays, tabs."""

import math

from .part import Part
from .sizes import Bend, Flat, smallest_rectangle
from .thick_sheet import Frame, Side, ThickSheet, hole, polygon, rectangle


def side_frame(base, outline, index, inset=0.0):
    """The rim on a side of the outline, begun `inset` after its start."""
    rim = base.rim(outline[index])
    return Frame(rim.at(0, inset), rim.x, rim.y)


def box(thickness, radius, length, width, heights, relief, turn=90.0, up=True, diameter=0.0):
    """A base `length` × `width` between tangent lines, its corners cut out square by `relief`, and
    four walls of their own heights. `diameter`: a hole in the base."""
    a, b, c = length, width, relief
    outline = polygon((c, 0), (a - c, 0), (a - c, c), (a, c), (a, b - c), (a - c, b - c), (a - c, b),
                      (c, b), (c, b - c), (0, b - c), (0, c), (c, c))
    sheet, base = ThickSheet(thickness), Frame()
    sheet.flat(base, outline, *([hole((a / 2, b / 2), diameter / 2)] if diameter else []))
    spans = [a - 2 * c, b - 2 * c] * 2
    for i, (span, height) in enumerate(zip(spans, heights)):
        sheet.wall_on(base.rim(outline[3 * i]), span, math.radians(turn), radius, up, height)
    bends = [Bend(turn, radius, span, up) for span in spans]

    def flat(rule):
        out = [h + bend.allowance(thickness, rule) for h, bend in zip(heights, bends)]
        area = a * b - 4 * c * c + sum(span * o for span, o in zip(spans, out))
        south, east, north, west = out
        corners = [(c, -south), (a - c, -south), (a + east, c), (a + east, b - c), (a - c, b + north),
                   (c, b + north), (-west, b - c), (-west, c)]
        whole = Flat(area, 2 * (a + b + south + east + north + west), smallest_rectangle(corners))
        opening = math.pi * diameter ** 2 / 4
        return whole if not diameter else Flat(area - opening, whole.outer, whole.size,
                                               [math.pi * diameter])
    return Part("box", f"An open box with square corner reliefs, walls at {turn:g}°.", thickness,
                sheet.solid(), flat, bends)


def lipped_box(thickness, radius, length, width, height, relief, lip, inset):
    """Lips turned in on all walls, `inset` shorter than these at both ends."""
    a, b, c = length, width, relief
    outline = polygon((c, 0), (a - c, 0), (a - c, c), (a, c), (a, b - c), (a - c, b - c), (a - c, b),
                      (c, b), (c, b - c), (0, b - c), (0, c), (c, c))
    sheet, base = ThickSheet(thickness), Frame()
    sheet.flat(base, outline)
    spans, bends = [a - 2 * c, b - 2 * c] * 2, []
    for i, span in enumerate(spans):
        frame = sheet.bend(base.rim(outline[3 * i]), span, math.pi / 2, radius, True)
        wall = polygon((0, 0), (height, 0), (height, inset), (height, span - inset), (height, span),
                       (0, span))
        sheet.flat(frame, wall)
        sheet.wall_on(frame.rim(wall[2]), span - 2 * inset, math.pi / 2, radius, True, lip)
        bends += [Bend(90, radius, span), Bend(90, radius, span - 2 * inset)]

    def flat(rule):
        allowance = bends[0].allowance(thickness, rule)
        wall, all_ = height + allowance, height + lip + 2 * allowance
        area = a * b - 4 * c * c + sum(s * wall + (s - 2 * inset) * (lip + allowance) for s in spans)
        far = c + inset
        corners = [(far, -all_), (a - far, -all_), (a + all_, far), (a + all_, b - far),
                   (a - far, b + all_), (far, b + all_), (-all_, b - far), (-all_, far),
                   (c, -wall), (a - c, -wall), (a + wall, c), (a + wall, b - c), (a - c, b + wall),
                   (c, b + wall), (-wall, b - c), (-wall, c)]
        return Flat(area, 2 * (a + b + 4 * all_), smallest_rectangle(corners))
    return Part("lipped_box", "A box whose walls have lips turned in.", thickness, sheet.solid(), flat,
                bends)


def polygon_tray(thickness, radius, corners, side, relief, height, turn):
    """A regular base with a wall on every side, `relief` shorter than it at both ends."""
    n, around = corners, side / (2 * math.sin(math.pi / corners))
    points = [(around * math.cos(2 * math.pi * i / n), around * math.sin(2 * math.pi * i / n))
              for i in range(n)]
    outline = []
    for p, q in zip(points, points[1:] + points[:1]):
        on = [tuple(x + (y - x) * s / side for x, y in zip(p, q)) for s in (relief, side - relief)]
        outline += [Side(p, on[0]), Side(on[0], on[1]), Side(on[1], q)]
    sheet, base, span = ThickSheet(thickness), Frame(), side - 2 * relief
    sheet.flat(base, outline)
    for i in range(n):
        sheet.wall_on(base.rim(outline[3 * i + 1]), span, math.radians(turn), radius, True, height)
    bends = [Bend(turn, radius, span) for _ in range(n)]

    def flat(rule):
        out = height + bends[0].allowance(thickness, rule)
        apothem = around * math.cos(math.pi / n)
        tips = []
        for i in range(n):
            middle = 2 * math.pi * (i + 0.5) / n
            for y in (-span / 2, span / 2):
                x = apothem + out
                tips.append((x * math.cos(middle) - y * math.sin(middle),
                             x * math.sin(middle) + y * math.cos(middle)))
        return Flat(n * (side * apothem / 2 + span * out), n * (2 * relief + 2 * out + span),
                    smallest_rectangle(points + tips))
    return Part("polygon_tray", f"A base with {n} equal sides and a wall on each.", thickness,
                sheet.solid(), flat, bends)


def tab_plate(thickness, radius, length, width, tab, height, slit, depth, turn, up):
    """A tab bent out of the middle of a side, between two relief slits."""
    a, b = length, width
    low, high = (b - tab) / 2, (b + tab) / 2
    rim = a - depth
    outline = polygon((0, 0), (a, 0), (a, low - slit), (rim, low - slit), (rim, low), (rim, high),
                      (rim, high + slit), (a, high + slit), (a, b), (0, b))
    sheet, base = ThickSheet(thickness), Frame()
    sheet.flat(base, outline)
    sheet.wall_on(base.rim(outline[4]), tab, math.radians(turn), radius, up, height)
    bend = Bend(turn, radius, tab, up)

    def flat(rule):
        out = height + bend.allowance(thickness, rule)
        area = a * b - depth * (tab + 2 * slit) + tab * out
        corners = [(0, 0), (a, 0), (a, b), (0, b), (rim + out, low), (rim + out, high)]
        return Flat(area, 2 * (a + b) + 2 * depth + 2 * out, smallest_rectangle(corners))
    return Part("tab_plate", "A tab between two relief slits, bent out of a side.", thickness,
                sheet.solid(), flat, [bend])


def trapezoid_flange(thickness, radius, length, width, height, taper):
    sheet, base = ThickSheet(thickness), Frame()
    outline = rectangle(0, 0, length, width)
    sheet.flat(base, outline)
    frame = sheet.bend(base.rim(outline[1]), width, math.pi / 2, radius, True)
    sheet.flat(frame, polygon((0, 0), (height, taper), (height, width - taper), (0, width)))
    bend = Bend(90, radius, width)

    def flat(rule):
        long = length + bend.allowance(thickness, rule)
        area = long * width + height * (width - taper)
        contour = 2 * long + width + width - 2 * taper + 2 * math.hypot(height, taper)
        corners = [(0, 0), (long, 0), (long + height, taper), (long + height, width - taper),
                   (long, width), (0, width)]
        return Flat(area, contour, smallest_rectangle(corners))
    return Part("trapezoid_flange", "An angle with a tapered flange.", thickness, sheet.solid(), flat,
                [bend])


def oblique_bend(thickness, radius, length, width, skew, height, turn):
    """A base with one side `skew` out of square, a rectangular flange on that side."""
    rim = math.hypot(skew, width)
    outline = polygon((0, 0), (length, 0), (length - skew, width), (0, width))
    sheet, base = ThickSheet(thickness), Frame()
    sheet.flat(base, outline)
    sheet.wall_on(base.rim(outline[1]), rim, math.radians(turn), radius, True, height)
    bend = Bend(turn, radius, rim)

    def flat(rule):
        out = height + bend.allowance(thickness, rule)
        area = (length - skew / 2) * width + rim * out
        contour = length + width + (length - skew) + 2 * out + rim
        across = (out * width / rim, out * skew / rim)
        corners = [(0, 0), (length, 0), (length + across[0], across[1]),
                   (length - skew + across[0], width + across[1]), (length - skew, width), (0, width)]
        return Flat(area, contour, smallest_rectangle(corners))
    return Part("oblique_bend", "A bend that is not square to the base.", thickness, sheet.solid(),
                flat, [bend])
