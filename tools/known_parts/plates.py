"""Flat plates, and openings in flanges and across bends."""

import math

from .part import Part
from .sizes import (Bend, Flat, circle_opening, ellipse_opening, obround_opening, rectangle_flat,
                    with_openings)
from .thick_sheet import (BendPatch, Frame, Path, Round, Side, ThickSheet, circle, hole, obround,
                          polygon, rectangle, turned_round)


def plate_with_holes(thickness, length, width, diameter, slot_length, slot_width):
    """Two round holes and an obround turned by 30°."""
    sheet = ThickSheet(thickness)
    sheet.flat(Frame(), rectangle(0, 0, length, width),
               hole((0.2 * length, 0.5 * width), diameter / 2),
               hole((0.85 * length, 0.25 * width), diameter / 3),
               obround((0.55 * length, 0.6 * width), slot_length, slot_width, math.pi / 6))
    openings = [circle_opening(diameter / 2), circle_opening(diameter / 3),
                obround_opening(slot_length, slot_width)]
    return Part("plate_with_holes", "A flat plate with two round holes and an oblique obround.",
                thickness, sheet.solid(),
                lambda rule: with_openings(rectangle_flat(length, width), openings))


def perforated_plate(thickness, length, width, pitch, diameter):
    """Round holes in rows, a pitch and a quarter from the edges at least."""
    counts = [int((size - 2.5 * pitch) / pitch) + 1 for size in (length, width)]
    centers = [(1.25 * pitch + i * pitch, 1.25 * pitch + j * pitch)
               for i in range(counts[0]) for j in range(counts[1])]
    sheet = ThickSheet(thickness)
    sheet.flat(Frame(), rectangle(0, 0, length, width), *[hole(c, diameter / 2) for c in centers])
    openings = [circle_opening(diameter / 2)] * len(centers)
    return Part("perforated_plate", f"A flat plate with {len(centers)} round holes.", thickness,
                sheet.solid(), lambda rule: with_openings(rectangle_flat(length, width), openings))


def ring(thickness, outer, inner):
    sheet = ThickSheet(thickness)
    sheet.flat(Frame(), circle((0, 0), outer), hole((0, 0), inner))
    disc = Flat(math.pi * outer ** 2, 2 * math.pi * outer, (2 * outer, 2 * outer))
    return Part("ring", "A disc with a round hole: no straight edge at all.", thickness,
                sheet.solid(), lambda rule: with_openings(disc, [circle_opening(inner)]))


def rounded_plate(thickness, length, width, corner):
    l, w, r, quarter = length, width, corner, math.pi / 2
    outline = [Side((r, 0), (l - r, 0)), Round((l - r, 0), (l, r), (l - r, r), quarter),
               Side((l, r), (l, w - r)), Round((l, w - r), (l - r, w), (l - r, w - r), quarter),
               Side((l - r, w), (r, w)), Round((r, w), (0, w - r), (r, w - r), quarter),
               Side((0, w - r), (0, r)), Round((0, r), (r, 0), (r, r), quarter)]
    sheet = ThickSheet(thickness)
    sheet.flat(Frame(), outline)
    flat = Flat(l * w - (4 - math.pi) * r * r, 2 * (l + w) - (8 - 2 * math.pi) * r,
                tuple(sorted((l, w), reverse=True)))
    return Part("rounded_plate", "A flat plate with round corners.", thickness, sheet.solid(),
                lambda rule: flat)


# ---- an angle `first | bend | second`, opened in several ways

class Angle:
    def __init__(self, thickness, radius, turn, first, second, width, up=True):
        self.thickness, self.radius, self.turn, self.width = thickness, radius, turn, width
        self.first, self.second = first, second
        self.sheet, self.alpha = ThickSheet(thickness), math.radians(turn)
        self.patch = BendPatch(Frame((first, 0, 0)), radius, up, thickness)
        self.behind = self.patch.behind(self.alpha)
        self.bend = Bend(turn, radius, width, up)

    def allowance(self, rule):
        return self.bend.allowance(self.thickness, rule)

    def whole(self, rule):
        return rectangle_flat(self.first + self.second + self.allowance(rule), self.width)

    def part(self, family, text, openings):
        """`openings`: Rule -> list of (area, contour length)."""
        return Part(family, text, self.thickness, self.sheet.solid(),
                    lambda rule: with_openings(self.whole(rule), openings(rule)), [self.bend])


def angle_with_holes(thickness, radius, first, second, width, diameter, slot_length, slot_width):
    a = Angle(thickness, radius, 90, first, second, width)
    a.sheet.flat(Frame(), rectangle(0, 0, first, width), hole((first / 2, width / 2), diameter / 2))
    a.sheet.add(a.patch, rectangle(0, 0, a.alpha, width))
    a.sheet.flat(a.behind, rectangle(0, 0, second, width),
                 obround((second / 2, width / 2), slot_length, slot_width, math.pi / 2))
    openings = [circle_opening(diameter / 2), obround_opening(slot_length, slot_width)]
    return a.part("angle_with_holes", "An angle with a round hole in one flange and an obround in "
                  "the other.", lambda rule: openings)


def slotted_angle(thickness, radius, turn, first, second, width, slot, reach, round_ends):
    """A slot centred across the whole bend, `reach` into both flanges; its ends may be round."""
    a = Angle(thickness, radius, turn, first, second, width)
    low, high = (width - slot) / 2, (width + slot) / 2
    r = slot / 2
    near = first - reach
    if round_ends:
        end_1 = [Side((first, low), (near + r, low)), Round((near + r, low), (near + r, high),
                                                           (near + r, width / 2), -math.pi),
                 Side((near + r, high), (first, high))]
        tip = reach - r
        end_2 = [Side((0, high), (tip, high)), Round((tip, high), (tip, low), (tip, width / 2),
                                                    -math.pi), Side((tip, low), (0, low))]
    else:
        end_1 = polygon((first, low), (near, low), (near, high), (first, high))[:3]
        end_2 = polygon((0, high), (reach, high), (reach, low), (0, low))[:3]
    a.sheet.flat(Frame(), [Side((0, 0), (first, 0)), Side((first, 0), (first, low)), *end_1,
                           Side((first, high), (first, width)), Side((first, width), (0, width)),
                           Side((0, width), (0, 0))])
    a.sheet.add(a.patch, rectangle(0, 0, a.alpha, low))
    a.sheet.add(a.patch, rectangle(0, high, a.alpha, width))
    a.sheet.flat(a.behind, [Side((0, 0), (second, 0)), Side((second, 0), (second, width)),
                            Side((second, width), (0, width)), Side((0, width), (0, high)), *end_2,
                            Side((0, low), (0, 0))])
    a.bend.length = width - slot

    def openings(rule):
        length = 2 * reach + a.allowance(rule)
        if round_ends:
            return [obround_opening(length, slot)]
        return [(length * slot, 2 * (length + slot))]
    return a.part("obround_across_bend" if round_ends else "slot_across_bend",
                  "A slot across the whole bend: the bend is in two pieces of one line.", openings)


def slot_into_bend(thickness, radius, first, second, width, slot, reach):
    """From `reach` before the bend to half-way round it."""
    a = Angle(thickness, radius, 90, first, second, width)
    low, high, near, half = (width - slot) / 2, (width + slot) / 2, first - reach, a.alpha / 2
    a.sheet.flat(Frame(), polygon((0, 0), (first, 0), (first, low), (near, low), (near, high),
                                  (first, high), (first, width), (0, width)))
    a.sheet.add(a.patch, polygon((0, 0), (a.alpha, 0), (a.alpha, width), (0, width), (0, high),
                                 (half, high), (half, low), (0, low)))
    a.sheet.flat(a.behind, rectangle(0, 0, second, width))

    def openings(rule):
        length = reach + a.allowance(rule) / 2
        return [(length * slot, 2 * (length + slot))]
    a.bend.length = None
    return a.part("slot_into_bend", "A slot that ends half-way round the bend.", openings)


def hole_in_bend(thickness, radius, first, second, width, share, half_width):
    """An opening within the bend, an ellipse in (angle, length): an ellipse in every pattern."""
    a = Angle(thickness, radius, 90, first, second, width)
    reach = share * a.alpha / 2

    def at(s):
        return a.alpha / 2 + reach * math.cos(s), width / 2 + half_width * math.sin(s)

    def slope(s):
        return -reach * math.sin(s), half_width * math.cos(s)
    outline = [Path(at, slope, 0, math.pi), Path(at, slope, math.pi, 2 * math.pi)]
    a.sheet.flat(Frame(), rectangle(0, 0, first, width))
    a.sheet.add(a.patch, rectangle(0, 0, a.alpha, width), turned_round(outline))
    a.sheet.flat(a.behind, rectangle(0, 0, second, width))
    a.bend.length = width - 2 * half_width

    def openings(rule):
        return [ellipse_opening(reach * (radius + rule.k(radius, thickness) * thickness),
                                half_width)]
    return a.part("hole_in_bend", "A round opening in the middle of the bend.", openings)


def notched_angle(thickness, radius, first, second, width, depth, reach):
    """A rectangular notch across the end of the bend."""
    a = Angle(thickness, radius, 90, first, second, width)
    near = first - reach
    a.sheet.flat(Frame(), polygon((0, 0), (near, 0), (near, depth), (first, depth), (first, width),
                                  (0, width)))
    a.sheet.add(a.patch, rectangle(0, depth, a.alpha, width))
    a.sheet.flat(a.behind, polygon((0, depth), (reach, depth), (reach, 0), (second, 0),
                                   (second, width), (0, width)))
    a.bend.length = width - depth

    def flat(rule):
        whole = a.whole(rule)
        cut = depth * (2 * reach + a.allowance(rule))
        return Flat(whole.area - cut, whole.outer + 2 * depth, whole.size)
    return Part("notched_angle", "A notch across one end of the bend, open to the edge.", thickness,
                a.sheet.solid(), flat, [a.bend])
