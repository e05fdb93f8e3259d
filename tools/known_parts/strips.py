"""Strips: straight pieces and bends one after the other, as wide all along."""

import math

from .part import Part
from .sizes import Bend, rectangle_flat
from .thick_sheet import Frame, ThickSheet, polygon, rectangle


def S(length):
    return length


def B(angle, radius, direction="up"):
    return (angle, radius, direction == "up")


def is_bend(piece):
    return isinstance(piece, tuple)


def strip_sheet(pieces, width, thickness):
    sheet, at = ThickSheet(thickness), Frame()
    for piece in pieces:
        if is_bend(piece):
            at = sheet.bend(at, width, math.radians(piece[0]), piece[1], piece[2])
        else:
            sheet.flat(at, rectangle(0, 0, piece, width))
            at = Frame(at.at(piece, 0), at.x, at.y)
    return sheet


def strip(family, text, thickness, width, pieces):
    """Flat: a rectangle, Σ straight lengths + Σ α (r + K t) long."""
    bends = [Bend(p[0], p[1], width, p[2]) for p in pieces if is_bend(p)]
    straight = sum(p for p in pieces if not is_bend(p))

    def flat(rule):
        return rectangle_flat(straight + sum(b.allowance(thickness, rule) for b in bends), width)
    return Part(family, text, thickness, strip_sheet(pieces, width, thickness).solid(), flat, bends)


def angle(thickness, radius, first, second, turn, width, direction="up"):
    return strip("angle", f"One bend of {turn:g}° {direction} between two flanges.", thickness, width,
                 [S(first), B(turn, radius, direction), S(second)])


def channel(thickness, radius, web, leg, width):
    bend = B(90, radius)
    return strip("channel", "A U: two bends of 90° the same way.", thickness, width,
                 [S(leg), bend, S(web), bend, S(leg)])


def zed(thickness, first_radius, second_radius, first, web, second, width):
    return strip("zed", "A Z: 90° up, then 90° down, radii may differ.", thickness, width,
                 [S(first), B(90, first_radius), S(web), B(90, second_radius, "down"), S(second)])


def hat(thickness, radius, brim, side, top, width):
    up, down = B(90, radius), B(90, radius, "down")
    return strip("hat", "A hat profile: up, down, down, up.", thickness, width,
                 [S(brim), up, S(side), down, S(top), down, S(side), up, S(brim)])


def lipped_channel(thickness, radius, lip, leg, web, width):
    bend = B(90, radius)
    return strip("lipped_channel", "A C section: four bends of 90° the same way.", thickness, width,
                 [S(lip), bend, S(leg), bend, S(web), bend, S(leg), bend, S(lip)])


def staircase(thickness, radius, step, steps, width):
    pieces = [S(step)]
    for _ in range(steps):
        pieces += [B(90, radius), S(step), B(90, radius, "down"), S(step)]
    return strip("staircase", f"{steps} steps: 90° up and down in turn.", thickness, width, pieces)


def hem(thickness, radius, length, back, width):
    return strip("hem", "An open hem: 180°.", thickness, width,
                 [S(length), B(180, radius), S(back)])


def jog(thickness, radius, turn, between, length, width):
    """`between` 0: one bend passes into the other without a straight piece."""
    middle = [S(between)] if between else []
    return strip("jog", f"A jog: {turn:g}° up and down, {between:g} mm straight between them.",
                 thickness, width,
                 [S(length), B(turn, radius), *middle, B(turn, radius, "down"), S(length)])


def rolled_cylinder(thickness, radius, turn, width):
    return strip("rolled_cylinder", f"A cylinder rolled through {turn:g}°, without a flange.",
                 thickness, width, [B(turn, radius)])


def sharp(thickness, first, web, second, width):
    return strip("sharp", "Two creases without inside radius, the outside round: up and down.",
                 thickness, width,
                 [S(first), B(90, 0.0), S(web), B(90, 0.0, "down"), S(second)])


def mitred_angle(thickness, first, second, turn, width):
    """Inside and outside both sharp, as many models have it; bent without inside radius."""
    half = math.radians(turn) / 2
    c, s = math.cos(2 * half), math.sin(2 * half)
    far = (first + second * c, second * s)
    corner = (first + thickness * math.tan(half), -thickness)
    profile = polygon((0, 0), (0, -thickness), corner,
                      (far[0] + thickness * s, far[1] - thickness * c), far, (first, 0))
    bend = Bend(turn, 0.0, width)

    def flat(rule):
        return rectangle_flat(first + second + bend.allowance(thickness, rule), width)
    volume = width * thickness * (first + second + thickness * math.tan(half))
    part = Part("mitred_angle", "Two flanges that meet in sharp edges inside and outside.", thickness,
                prism(profile, width), flat, [bend])
    part.volume = volume
    return part


def prism(outline, depth, *holes):
    """Any profile, as deep as one likes: a very thick flat patch."""
    sheet = ThickSheet(depth)
    sheet.flat(Frame(), outline, *holes)
    return sheet.solid()

