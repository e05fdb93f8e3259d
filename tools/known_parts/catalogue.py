"""The parts: a fixed list, and as many more as one wants, drawn by chance from the same families."""

import math
import random

from . import boxes, plates, refused, round_parts, strips
from .part import Part
from .strips import B, S, strip
from .vectors import turned, unit

INCH = 25.4


def fixed():
    """Name -> part. Names are the files' names, and do not change."""
    parts = {**bent(), **flat_and_opened(), **walled(), **rounded(), **refusals()}
    for name, part in parts.items():
        part.name = name
    return parts


def bent():
    a, z = strips.angle, strips.zed
    return {
        "angle": a(2, 3, 50, 30, 90, 40),
        "angle_down": a(2, 3, 55, 35, 90, 40, "down"),
        "angle_135": a(2, 2, 40, 30, 135, 25),
        "angle_150": a(3, 4, 60, 40, 150, 35),
        "angle_30": a(1.5, 6, 40, 40, 30, 55),
        "angle_5": a(2, 20, 60, 50, 5, 30),
        "angle_10_mm": a(10, 12, 120, 90, 90, 200),
        "angle_half_mm": a(0.5, 0.3, 12, 8, 90, 6),
        "angle_250": a(1, 8, 40, 4, 250, 20),
        "angle_inch": inch(a(0.0598 * INCH, 0.0625 * INCH, 2 * INCH, 1.5 * INCH, 90, 3 * INCH)),
        "angle_1_8_inch": inch(a(0.125 * INCH, 0.125 * INCH, 4 * INCH, INCH, 45, 1.25 * INCH, "down")),
        "channel": strips.channel(1.5, 2, 40, 30, 25),
        "channel_4_mm": strips.channel(4, 6, 100, 60, 300),
        "zed": z(1, 1, 1, 30, 20, 30, 25),
        "zed_two_radii": z(2, 1, 6, 30, 20, 30, 25),
        "hat": strips.hat(1.5, 2, 20, 25, 40, 60),
        "lipped_channel": strips.lipped_channel(1.5, 2, 10, 30, 60, 200),
        "staircase": strips.staircase(1, 1, 20, 3, 30),
        "hem": strips.hem(1, 0.5, 40, 15, 20),
        "hem_teardrop": strip("hem_teardrop", "A teardrop hem: 225°.", 1, 20,
                              [S(40), B(225, 2), S(3)]),
        "jog": strips.jog(1.5, 2, 45, 0, 30, 40),
        "joggle": strips.jog(1, 1, 60, 5, 30, 25),
        "wave": strip("wave", "Bends in turn, no straight piece between them.", 1, 40,
                      [S(20), B(60, 8), B(120, 8, "down"), B(120, 8), B(60, 8, "down"), S(20)]),
        "compound_radius": strip("compound_radius", "One bend of two radii, 3 and then 9 mm.", 2, 45,
                                 [S(30), B(40, 3), B(50, 9), S(30)]),
        "curled_ends": strip("curled_ends", "Both ends curled through 270°.", 1, 20,
                             [S(6), B(270, 10), S(60), B(270, 10), S(6)]),
        "curl": strip("curl", "An end curled through 300°, nothing behind it.", 1, 30,
                      [S(30), B(300, 6)]),
        "seamed_square_tube": strip("seamed_square_tube", "A square tube with an open seam of 1 mm.",
                                    2, 90, [S(20), *[B(90, 3), S(40)] * 3, B(90, 3), S(19)]),
        "rolled_cylinder": strips.rolled_cylinder(1.5, 20, 340, 50),
        "sharp_angle": strip("sharp_angle", "Sharp inside, round outside, bent up.", 2, 40,
                             [S(50), B(90, 0), S(30)]),
        "sharp_angle_down": strip("sharp_angle_down", "Sharp inside, round outside, bent down.", 2, 40,
                                  [S(50), B(60, 0, "down"), S(30)]),
        "sharp_angle_5": strip("sharp_angle", "Sharp inside, round outside, bent up by 5°.", 1, 30,
                               [S(20), B(5, 0), S(15)]),
        "nearly_sharp_angle_2": a(2, 0.01, 40, 32, 2, 30),
        "sharp_zed": strips.sharp(1, 50, 20, 30, 40),
        "mitred_angle": strips.mitred_angle(2, 50, 30, 90, 40),
        "mitred_angle_120": strips.mitred_angle(1.5, 40, 25, 120, 30),
    }


def flat_and_opened():
    return {
        "plate_with_holes": plates.plate_with_holes(3, 100, 60, 10, 20, 8),
        "perforated_plate": plates.perforated_plate(1, 135, 110, 8, 5),
        "ring": plates.ring(2, 40, 25),
        "rounded_plate": plates.rounded_plate(6, 120, 70, 15),
        "angle_with_holes": plates.angle_with_holes(2, 3, 50, 40, 60, 10, 24, 8),
        "slot_across_bend": plates.slotted_angle(2, 4, 90, 40, 30, 60, 12, 8, False),
        "obround_across_bend": plates.slotted_angle(1.5, 3, 60, 45, 35, 70, 14, 16, True),
        "slot_into_bend": plates.slot_into_bend(2, 8, 40, 30, 60, 12, 8),
        "hole_in_bend": plates.hole_in_bend(2, 12, 40, 30, 60, 0.6, 7),
        "notched_angle": plates.notched_angle(2, 3, 45, 30, 50, 9, 5),
    }


def walled():
    return {
        "box": boxes.box(1.5, 2, 80, 50, (25, 25, 25, 25), 4),
        "box_down": boxes.box(1, 1.5, 100, 70, (20, 20, 20, 20), 3, up=False),
        "box_uneven_walls": boxes.box(2, 3, 120, 80, (15, 40, 25, 10), 6, diameter=22),
        "box_sloped_walls": boxes.box(1.2, 2.5, 90, 60, (30, 30, 30, 30), 1.5, turn=55),
        "box_inch": inch(boxes.box(0.0478 * INCH, 0.03 * INCH, 6 * INCH, 4 * INCH, (1.5 * INCH,) * 4,
                                   0.125 * INCH)),
        "lipped_box": boxes.lipped_box(1, 1.5, 120, 90, 30, 3, 10, 14),
        "hexagon_tray": boxes.polygon_tray(1.5, 2, 6, 50, 4, 18, 60),
        "triangle_tray": boxes.polygon_tray(2, 3, 3, 110, 8, 20, 90),
        "tab_plate": boxes.tab_plate(2, 3, 80, 50, 20, 25, 3, 8, 90, True),
        "tab_plate_down": boxes.tab_plate(1, 1, 60, 40, 12, 15, 1.5, 3, 135, False),
        "trapezoid_flange": boxes.trapezoid_flange(2, 2.5, 60, 80, 30, 18),
        "oblique_bend": boxes.oblique_bend(1.5, 4, 70, 50, 22, 35, 75),
    }


def rounded():
    return {
        "cone_joint": round_parts.cone_joint(1.5, 20, 70, 60, 50, 40, 30),
        "cone_joint_250": round_parts.cone_joint(1.5, 10, 250, 180, 50, 12, 10),
        "cone_joint_down": round_parts.cone_joint(2, 12, 100, 80, 60, 25, 45, "down"),
        "rolled_cone": round_parts.rolled_cone(1.5, 20, 300, 60, 80),
        "half_cone": round_parts.rolled_cone(3, 35, 180, 50, 40),
        "oblique_half_tube": round_parts.oblique_half_tube(2, 30, 60, 25),
        "elbow_gore": round_parts.elbow_gore(1, 40, 350, 30, 15),
        "saddle_tube": round_parts.saddle_tube(1.5, 25, 340, 90, 45),
    }


def refusals():
    return {
        "block": refused.block(30),
        "round_tube": refused.round_tube(2, 18, 80),
        "box_tube": refused.box_tube(2, 4, 60, 40, 80),
        "dome": refused.dome(2, 40),
        "uneven_angle": refused.uneven_angle(2, 4, 50, 40),
        "wedge": refused.wedge(3, 5, 80, 60),
        "tee": refused.tee(3, 50, 40, 70),
        "shelled_box": refused.shelled_box(2, 60, 40, 20),
        "crossing_walls": refused.crossing_walls(1, 1, 80, 40, 20),
    }


def inch(part):
    """The same part, its file in inches."""
    part.inch = True
    return part


# ---- drawn by chance

METRIC = (0.5, 0.8, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
GAUGES = tuple(t * INCH for t in (0.0239, 0.0359, 0.0478, 0.0598, 0.0747, 0.1046, 0.125, 0.25))


class Draw:
    """Sizes in proportion to a thickness from either list."""

    def __init__(self, chance):
        self.chance = chance
        self.inch = chance.random() < 0.25
        self.t = chance.choice(GAUGES if self.inch else METRIC)
        self.r = self.size(0.4, 3.0)

    def size(self, low, high):
        """Between two multiples of the thickness, to 1/1000 mm."""
        return round(self.t * self.chance.uniform(low, high), 3)

    def turn(self, low, high):
        return float(self.chance.randint(low, high))

    def way(self):
        return self.chance.choice(("up", "down"))

    def put_anywhere(self, solid):
        """Turned about any axis, up to a metre away from the origin."""
        axis = unit(tuple(self.chance.gauss(0, 1) for _ in range(3)))
        angle = self.chance.uniform(0, 2 * math.pi)
        shift = tuple(self.chance.uniform(-1000, 1000) for _ in range(3))
        solid.move(lambda v: turned(v, axis, angle), shift)


def drawn_angle(d):
    return strips.angle(d.t, d.r, d.size(10, 40), d.size(10, 40), d.turn(5, 160), d.size(5, 60), d.way())


def drawn_channel(d):
    return strips.channel(d.t, d.r, d.size(20, 50), d.size(8, 30), d.size(5, 80))


def drawn_zed(d):
    return strips.zed(d.t, d.r, d.size(0.4, 5), d.size(8, 30), d.size(8, 30), d.size(8, 30),
                      d.size(5, 40))


def drawn_hat(d):
    return strips.hat(d.t, d.r, d.size(8, 20), d.size(8, 20), d.size(15, 30), d.size(5, 60))


def drawn_staircase(d):
    return strips.staircase(d.t, d.r, d.size(12, 20), d.chance.randint(1, 4), d.size(5, 30))


def drawn_hem(d):
    return strips.hem(d.t, d.r, d.size(20, 40), d.size(5, 15), d.size(10, 40))


def drawn_jog(d):
    between = d.chance.choice((0, d.size(1, 6)))
    return strips.jog(d.t, d.r, d.turn(15, 80), between, d.size(15, 30), d.size(8, 40))


def drawn_cylinder(d):
    return strips.rolled_cylinder(d.t, d.size(8, 30), d.turn(40, 345), d.size(10, 60))


def drawn_sharp(d):
    return strips.sharp(d.t, d.size(10, 30), d.size(8, 20), d.size(10, 30), d.size(8, 40))


def drawn_mitred(d):
    return strips.mitred_angle(d.t, d.size(10, 40), d.size(10, 40), d.turn(20, 120), d.size(8, 40))


def drawn_holes(d):
    return plates.angle_with_holes(d.t, d.r, d.size(20, 40), d.size(20, 40), d.size(25, 50), d.size(3, 8),
                                   d.size(10, 16), d.size(3, 7))


def drawn_slot(d):
    reach = d.size(4, 8)
    return plates.slotted_angle(d.t, d.r, d.turn(20, 120), reach + d.size(6, 20), reach + d.size(6, 20),
                                d.size(20, 40), d.size(3, 7), reach, d.chance.random() < 0.5)


def drawn_hole_in_bend(d):
    return plates.hole_in_bend(d.t, d.size(5, 9), d.size(10, 30), d.size(10, 30), d.size(20, 40),
                               d.chance.uniform(0.3, 0.8), d.size(2, 6))


def drawn_notch(d):
    return plates.notched_angle(d.t, d.r, d.size(12, 30), d.size(12, 30), d.size(20, 40), d.size(3, 8),
                                d.size(2, 5))


def drawn_box(d):
    return boxes.box(d.t, d.r, d.size(40, 80), d.size(30, 60), tuple(d.size(8, 20) for _ in range(4)),
                     d.size(1.5, 4) + d.r, d.turn(30, 90), d.chance.random() < 0.5)


def drawn_tray(d):
    return boxes.polygon_tray(d.t, d.r, d.chance.randint(3, 8), d.size(25, 40), d.size(2, 4) + d.r,
                              d.size(6, 12), d.turn(20, 80))


def drawn_tab(d):
    return boxes.tab_plate(d.t, d.r, d.size(30, 60), d.size(30, 50), d.size(8, 18), d.size(8, 20),
                           d.size(1, 3), d.r + d.size(1, 3), d.turn(20, 120), d.chance.random() < 0.5)


def drawn_oblique(d):
    return boxes.oblique_bend(d.t, d.r, d.size(30, 50), d.size(20, 40), d.size(3, 15), d.size(8, 25),
                              d.turn(20, 110))


def drawn_cone(d):
    return round_parts.cone_joint(d.t, d.turn(8, 30), d.turn(30, 110), d.size(25, 60), d.size(15, 40),
                                  d.size(10, 30), d.size(10, 30), d.way())


def drawn_rolled_cone(d):
    return round_parts.rolled_cone(d.t, d.turn(12, 40), d.turn(90, 330), d.size(25, 50), d.size(15, 40))


def drawn_half_tube(d):
    return round_parts.oblique_half_tube(d.t, d.size(8, 20), d.size(20, 30), d.size(2, 15))


def drawn_refusal(d):
    make = d.chance.choice((
        lambda: refused.block(d.size(3, 10)),
        lambda: refused.round_tube(d.t, d.size(3, 20), d.size(10, 60)),
        lambda: refused.box_tube(d.t, d.size(0.5, 3), d.size(15, 40), d.size(15, 40), d.size(20, 60)),
        lambda: refused.dome(d.t, d.size(10, 40)),
        lambda: refused.uneven_angle(d.t, 1.5 * d.t, d.size(15, 40), d.size(10, 40)),
        lambda: refused.wedge(d.t, 1.5 * d.t, d.size(20, 50), d.size(20, 50)),
        lambda: refused.tee(d.t, d.size(15, 30), d.size(15, 30), d.size(20, 50)),
        lambda: refused.shelled_box(d.t, d.size(20, 40), d.size(20, 40), d.size(8, 20)),
        lambda: refused.crossing_walls(d.t, d.r, d.size(50, 70), d.size(20, 30), d.size(12, 18))))
    return make()


DRAWN = [drawn_angle, drawn_channel, drawn_zed, drawn_hat, drawn_staircase, drawn_hem, drawn_jog,
         drawn_cylinder, drawn_sharp, drawn_mitred, drawn_holes, drawn_slot, drawn_hole_in_bend,
         drawn_notch, drawn_box, drawn_tray, drawn_tab, drawn_oblique, drawn_cone, drawn_rolled_cone,
         drawn_half_tube, drawn_refusal]


def drawn(count, seed):
    """`count` parts, each family in turn, anywhere in space; the same seed gives the same parts."""
    parts: dict[str, Part] = {}
    for i in range(count):
        draw = Draw(random.Random(f"{seed}/{i}"))
        part = DRAWN[i % len(DRAWN)](draw)
        draw.put_anywhere(part.solid)
        part.inch = draw.inch
        part.name = f"{part.family}_{seed}_{i:04d}"
        parts[part.name] = part
    return parts
