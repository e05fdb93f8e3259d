#!/usr/bin/python3
"""Draws folded parts for the documentation: binary STL in, PNG out.

    tools/draw_folded.py part.stl part.png --view 30,25 --size 900

Parallel projection, hidden surfaces by depth buffer. Dark lines: edges where neighbouring facets turn
by more than 20 degrees, and outlines. Thin lines: tangent lines, where a flat piece goes over into a
bend. Needs nothing but Python 3.
"""

import argparse
import collections
import math
import struct
import sys
import zlib

SUPERSAMPLING = 2
SHARP = math.radians(20)      # from here on an edge is drawn dark
COPLANAR = math.radians(0.5)  # up to here two facets are one flat piece
FLAT_TO_BEND = 3.0            # a flat piece is so much wider than a bend's first facet

LIGHT_FROM = (-0.35, 0.55, 0.76)  # to the right, up, towards the viewer
STEEL = (176, 190, 204)
DARK, THIN = (22, 30, 40), (96, 110, 126)
WHITE = (255, 255, 255)
SHADES = 240
INK, THIN_INK, PAPER = SHADES, SHADES + 1, SHADES + 2


# Vectors are tuples (x, y, z).

def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def norm(a):
    return math.sqrt(dot(a, a))


def angle_between(a, b):
    return math.atan2(norm(cross(a, b)), dot(a, b))


Facet = collections.namedtuple("Facet", "corners normal area")


def upright(p):
    """From y up to z up."""
    return (p[0], -p[2], p[1])


def turned_upright(facet):
    return Facet(tuple(upright(p) for p in facet.corners), upright(facet.normal), facet.area)


def read_stl(path):
    """The facets of a binary STL file, those without area left out."""
    with open(path, "rb") as file:
        data = file.read()
    if len(data) < 84 or len(data) != 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        sys.exit(f"{path}: not a binary STL file")
    facets = []
    for at in range(84, len(data), 50):
        v = struct.unpack_from("<12f", data, at)
        corners = (v[3:6], v[6:9], v[9:12])
        n = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        if norm(n) > 0:
            facets.append(Facet(corners, tuple(x / norm(n) for x in n), norm(n) / 2))
    return facets


def neighbours(facets):
    """Side (its two ends, sorted) -> the facets that have it."""
    sides = collections.defaultdict(list)
    for index, facet in enumerate(facets):
        for i in range(3):
            sides[tuple(sorted((facet.corners[i - 1], facet.corners[i])))].append(index)
    return sides


def flat_pieces(facets, sides):
    """For every facet the area of the flat piece that it belongs to."""
    parent = list(range(len(facets)))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for pair in sides.values():
        if len(pair) == 2 and angle_between(*(facets[i].normal for i in pair)) < COPLANAR:
            parent[root(pair[0])] = root(pair[1])
    area = collections.Counter()
    for i, facet in enumerate(facets):
        area[root(i)] += facet.area
    return [area[root(i)] for i in range(len(facets))]


def lines_of(facets, towards_viewer):
    """Sides to draw: (ends, ink)."""
    sides = neighbours(facets)
    piece_area = flat_pieces(facets, sides)
    sharp, outlines, smooth = [], [], []
    for ends, pair in sides.items():
        a, b = pair[0], pair[-1]
        turn = angle_between(facets[a].normal, facets[b].normal)
        small, large = sorted((piece_area[a], piece_area[b]))
        if len(pair) != 2 or turn > SHARP:
            sharp.append(ends)
        elif turn > COPLANAR and large > FLAT_TO_BEND * small:
            smooth.append(ends)
        if turn > COPLANAR and (dot(facets[a].normal, towards_viewer) > 0) != \
                (dot(facets[b].normal, towards_viewer) > 0):
            outlines.append(ends)
    return [(ends, THIN_INK) for ends in border_to_border(smooth, sharp)] + \
        [(ends, INK) for ends in sharp + outlines]


def border_to_border(smooth, sharp):
    """Of the smooth sides those in a straight row from one sharp edge to another, as tangent lines
    are; others come from the way a curved face was cut into triangles."""
    border = {point for ends in sharp for point in ends}
    sides_at = collections.defaultdict(list)
    for ends in smooth:
        for point in ends:
            sides_at[point].append(ends)

    def row_from(start, side):
        row, at = [side], side[1] if side[0] == start else side[0]
        while at not in border:
            along = minus(at, start)
            on = [s for s in sides_at[at] if s != row[-1] and
                  angle_between(along, minus(s[1] if s[0] == at else s[0], at)) < COPLANAR]
            if not on:
                return []
            row.append(on[0])
            at = on[0][1] if on[0][0] == at else on[0][0]
        return row

    return {side for start in border for first in sides_at[start] for side in row_from(start, first)}


class View:
    """Where a point of space lies in the picture: x to the right, y down (pixels), depth towards the
    viewer (pixels too)."""

    def __init__(self, azimuth, elevation, facets, size):
        a, e = math.radians(azimuth), math.radians(elevation)
        self.towards = (math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e))
        self.right = (-math.sin(a), math.cos(a), 0.0)
        self.up = cross(self.towards, self.right)
        xs = [dot(self.right, p) for f in facets for p in f.corners]
        ys = [dot(self.up, p) for f in facets for p in f.corners]
        margin = 0.03 * size
        self.scale = (size - 2 * margin) / max(max(xs) - min(xs), max(ys) - min(ys))
        self.width = math.ceil((max(xs) - min(xs)) * self.scale + 2 * margin)
        self.height = math.ceil((max(ys) - min(ys)) * self.scale + 2 * margin)
        self.left, self.top = margin - min(xs) * self.scale, margin + max(ys) * self.scale

    def point(self, p):
        return (self.left + self.scale * dot(self.right, p), self.top - self.scale * dot(self.up, p),
                self.scale * dot(self.towards, p))

    def shade(self, normal):
        """0 … SHADES - 1, by how much the facet faces the light."""
        n = (dot(self.right, normal), dot(self.up, normal), dot(self.towards, normal))
        lit = 0.5 + 0.5 * dot(n, LIGHT_FROM) / norm(LIGHT_FROM)  # the far side gets some light too
        return round(lit ** 1.4 * (SHADES - 1))


class Picture:
    """Rows of ink with the depth of what is seen there; pixel (i, j) has its middle at + ½."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.ink = [bytearray([PAPER]) * width for _ in range(height)]
        self.depth = [[-math.inf] * width for _ in range(height)]

    def fill(self, triangle, ink):
        (x0, y0, z0), (x1, y1, z1), (x2, y2, z2) = triangle
        det = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if det == 0:
            return
        dz_dx = ((z1 - z0) * (y2 - y0) - (z2 - z0) * (y1 - y0)) / det
        dz_dy = ((z2 - z0) * (x1 - x0) - (z1 - z0) * (x2 - x0)) / det
        top, bottom = min(y0, y1, y2), max(y0, y1, y2)
        for j in range(max(0, math.ceil(top - 0.5)), min(self.height, math.ceil(bottom - 0.5))):
            y = j + 0.5
            xs = [xa + (y - ya) * (xb - xa) / (yb - ya)
                  for (xa, ya, _), (xb, yb, _) in zip(triangle, triangle[1:] + triangle[:1])
                  if (ya <= y) != (yb <= y)]
            if len(xs) < 2:
                continue
            begin = max(0, math.ceil(min(xs) - 0.5))
            end = min(self.width, math.ceil(max(xs) - 0.5))
            z = z0 + (begin + 0.5 - x0) * dz_dx + (y - y0) * dz_dy
            depths, inks = self.depth[j], self.ink[j]
            for i in range(begin, end):
                if z > depths[i]:
                    depths[i] = z
                    inks[i] = ink
                z += dz_dx

    def stroke(self, a, b, width, ink):
        """A line with round ends, where nothing lies before it."""
        nearer = 2.0 * width  # the facets beside the line may be this much nearer to the viewer
        steps = max(1, math.ceil(2 * math.hypot(b[0] - a[0], b[1] - a[1])))
        reach = math.ceil(width / 2)
        for step in range(steps + 1):
            x, y, z = (p + (q - p) * step / steps for p, q in zip(a, b))
            for j in range(math.floor(y) - reach, math.floor(y) + reach + 1):
                for i in range(math.floor(x) - reach, math.floor(x) + reach + 1):
                    if not (0 <= i < self.width and 0 <= j < self.height):
                        continue
                    if math.hypot(i + 0.5 - x, j + 0.5 - y) <= width / 2 and \
                            self.depth[j][i] <= z + nearer:
                        self.ink[j][i] = ink

    def png(self):
        """With SUPERSAMPLING² pixels made one."""
        s = SUPERSAMPLING
        rows = []
        above = bytes(3 * (self.width // s))
        for j in range(0, self.height - s + 1, s):
            row = bytearray()
            for i in range(0, self.width - s + 1, s):
                inks = [k for line in self.ink[j:j + s] for k in line[i:i + s]]
                row += bytes(COLORS[inks[0]]) if min(inks) == max(inks) else \
                    bytes(sum(channel) // len(inks) for channel in zip(*(COLORS[k] for k in inks)))
            # Filter 2: the difference from the row above.
            rows.append(b"\x02" + bytes((x - y) & 255 for x, y in zip(row, above)))
            above = row
        return png_file(self.width // s, len(rows), b"".join(rows))


def mixed(a, b, share):
    return tuple(round(x + (y - x) * share) for x, y in zip(a, b))


COLORS = [mixed(mixed(STEEL, (0, 0, 0), 0.62), mixed(STEEL, WHITE, 0.62), k / (SHADES - 1))
          for k in range(SHADES)] + [DARK, THIN, WHITE]


def png_file(width, height, filtered_rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    eight_bit_rgb = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", eight_bit_rgb) +
            chunk(b"IDAT", zlib.compress(filtered_rows, 9)) + chunk(b"IEND", b""))


def drawn(facets, azimuth, elevation, size):
    view = View(azimuth, elevation, facets, size * SUPERSAMPLING)
    picture = Picture(view.width, view.height)
    for facet in facets:
        # Of solids no back is seen; of open surfaces it is the inside.
        normal = facet.normal if dot(facet.normal, view.towards) > 0 else minus((0, 0, 0), facet.normal)
        picture.fill([view.point(p) for p in facet.corners], view.shade(normal))
    width = {INK: max(2.2, size / 400) * SUPERSAMPLING / 1.25,
             THIN_INK: max(1.2, size / 800) * SUPERSAMPLING / 1.25}
    for (a, b), ink in sorted(lines_of(facets, view.towards), key=lambda line: -line[1]):
        picture.stroke(view.point(a), view.point(b), width[ink], ink)
    return picture.png()


def degrees_pair(text):
    azimuth, elevation = text.split(",")
    return float(azimuth), float(elevation)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stl", nargs="+", help="binary STL files, drawn together")
    parser.add_argument("png", help="the picture to write")
    parser.add_argument("--view", type=degrees_pair, default=(-55.0, 28.0), metavar="AZ,EL",
                        help="where the viewer stands: degrees from +x towards +y, degrees above "
                             "(default -55,28; write --view=AZ,EL when AZ is negative)")
    parser.add_argument("--size", type=int, default=900, help="longer side, pixels (default 900)")
    parser.add_argument("--up", choices=("y", "z"), default="z", help="which axis is up in the files (default z)")
    arguments = parser.parse_args()
    facets = [facet for path in arguments.stl for facet in read_stl(path)]
    if arguments.up == "y":
        facets = [turned_upright(facet) for facet in facets]
    if not facets:
        sys.exit("nothing to draw")
    with open(arguments.png, "wb") as file:
        file.write(drawn(facets, *arguments.view, arguments.size))


if __name__ == "__main__":
    main()
