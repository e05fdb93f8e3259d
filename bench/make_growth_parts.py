#!/usr/bin/python3
"""make_growth_parts.py FOLDER: STEP files of plates with many openings and of staircases with many
flanges, to see how the time that they take grows. Written without a CAD kernel.

holes-N.step   N round openings of 6 mm on a square grid, 15 mm apart, plate 2 mm thick
slots-N.step   N obround openings of 8 × 4 mm, the same
stairs-N.step  N flanges of 20 mm that a bend of radius 1 joins to the next, up and down by turns
folds-N.step   the same with sharp inside corners, rounded outside
"""

import argparse
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "tests/cli"))
from step_files import Arc, Line, StepFile  # noqa: E402

OPENINGS = (100, 1000, 3000, 10000)
FLANGES = (10, 100, 300, 1000, 3000)
PITCH = 15.0


class Plate(StepFile):
    """A plate from z = 0 to its thickness, with openings from one skin to the other."""

    def __init__(self, width, height, thickness):
        super().__init__()
        self.thickness = thickness
        self.walls = []
        self.loops = ([], [])  # on both skins: those of openings
        corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
        self.outline = self._ring([(p, None) for p in corners])

    def _ring(self, path):
        """Edges at both skins along a closed path of (start, centre of the arc or None), the
        material on its left, and walls along it."""
        points = [p for p, _ in path]
        levels = (0.0, self.thickness)
        vertices = [[self.add(f"VERTEX_POINT('',{self.point((*p, z))})") for p in points]
                    for z in levels]
        rings = ([], [])
        posts = [self.line_edge((*p, 0.0), (*p, self.thickness), a, b)
                 for p, a, b in zip(points, *vertices)]
        for i, (a, centre) in enumerate(path):
            j = (i + 1) % len(path)
            b = points[j]
            for ring, v, z in zip(rings, vertices, levels):
                ring.append(self.line_edge((*a, z), (*b, z), v[i], v[j]) if centre is None
                            else self.arc_edge((*a, z), v[i], v[j], centre, False, z))
            edges = [(rings[0][i], True), (posts[j], True), (rings[1][i], False), (posts[i], False)]
            self.walls.append(self._wall(a, b, centre, edges))
        return rings

    def _wall(self, a, b, centre, edges):
        if centre is not None:
            place = self.placement((*centre, 0.0), (0, 0, 1), (1, 0, 0))
            surface = self.add(f"CYLINDRICAL_SURFACE('',{place},{math.dist(a, centre):.12f})")
            return self.face(surface, edges, same_sense=False)
        n = math.dist(a, b)
        d = ((b[0] - a[0]) / n, (b[1] - a[1]) / n, 0)
        plane = self.add(f"PLANE('',{self.placement((*a, 0.0), (d[1], -d[0], 0), d)})")
        return self.face(plane, edges)

    def hole(self, centre, radius):
        """Two half circles, clockwise."""
        x, y = centre
        self._open([((x + radius, y), centre), ((x - radius, y), centre)])

    def slot(self, centre, length, width):
        x, y = centre
        r, s = width / 2, (length - width) / 2
        self._open([((x - s, y + r), None), ((x + s, y + r), (x + s, y)),
                    ((x + s, y - r), None), ((x - s, y - r), (x - s, y))])

    def _open(self, path):
        for loops, ring in zip(self.loops, self._ring(path)):
            loops.append(ring)

    def _bound(self, kind, edges, forward):
        order = edges if forward else list(reversed(edges))
        sense = "T" if forward else "F"
        uses = [self.add(f"ORIENTED_EDGE('',*,*,{edge},.{sense}.)") for edge in order]
        loop = self.add(f"EDGE_LOOP('',({','.join(uses)}))")
        return self.add(f"{kind}('',{loop},.T.)")

    def _skin(self, level):
        up = level == 1
        bounds = [self._bound("FACE_OUTER_BOUND", self.outline[level], up)]
        bounds += [self._bound("FACE_BOUND", ring, up) for ring in self.loops[level]]
        place = self.placement((0, 0, level * self.thickness), (0, 0, 1 if up else -1), (1, 0, 0))
        plane = self.add(f"PLANE('',{place})")
        return self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{plane},.T.)")

    def finished(self, name):
        faces = [self._skin(0), self._skin(1), *self.walls]
        self.product(name, self.add(f"CLOSED_SHELL('',({','.join(faces)}))"))
        return self.text()


def plate(count, cut):
    columns = math.ceil(math.sqrt(count))
    rows = math.ceil(count / columns)
    made = Plate((columns + 1) * PITCH, (rows + 1) * PITCH, 2.0)
    for i in range(count):
        cut(made, ((i % columns + 1) * PITCH, (i // columns + 1) * PITCH))
    return made.finished("plate")


def side_of(steps, offset, inner, outer):
    """One side of a staircase's section, from its start on: (end, centre or None, ccw). Bends to the
    left have the radius `inner`, those to the right `outer`; a radius of 0 is a corner."""
    curves = []
    x, y, along_x = 0.0, offset, True
    for step in range(steps):
        left = step % 2 == 0
        x, y = (x + 20.0, y) if along_x else (x, y + 20.0)
        if step == steps - 1:
            curves.append(Line((x, y)))
            break
        radius = inner if left else outer
        curves.append(Line((x, y)))
        if radius > 0.0:
            centre = (x, y + radius) if left else (x + radius, y)
            x, y = x + radius, y + radius
            curves.append(Arc((x, y), centre, left))
        along_x = not along_x
    return (0.0, offset), curves


def backwards(start, curves):
    starts = [start] + [c.end for c in curves[:-1]]
    return [Line(a) if isinstance(c, Line) else Arc(a, c.center, not c.ccw)
            for a, c in zip(reversed(starts), reversed(curves))]


def stairs(flanges, radius):
    """The section's lower side turns left about centres one radius away, its upper side, on the left
    and 1 mm away, about the same centres."""
    thickness = 1.0
    lower_start, lower = side_of(flanges, 0.0, radius + thickness, radius)
    upper_start, upper = side_of(flanges, thickness, radius, radius + thickness)
    # Both sides start and end level, so their flanges are 20 mm long alike.
    file = StepFile()
    curves = [*lower, Line(upper[-1].end), *backwards(upper_start, upper), Line(lower_start)]
    file.product("stairs", file.prism(lower_start, curves, 30.0))
    return file.text()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for n in OPENINGS:
        (folder / f"holes-{n}.step").write_text(plate(n, lambda p, c: p.hole(c, 3.0)))
        (folder / f"slots-{n}.step").write_text(plate(n, lambda p, c: p.slot(c, 8.0, 4.0)))
    for n in FLANGES:
        (folder / f"stairs-{n}.step").write_text(stairs(n, 1.0))
        (folder / f"folds-{n}.step").write_text(stairs(n, 0.0))


if __name__ == "__main__":
    main()
