#!/usr/bin/python3
"""Compare the displacement of loaded strips with that of CalculiX (Debian: calculix-ccx).

The strip is built flat in quadratic bricks, one through the thickness, which is what CalculiX makes
of shells; its end is led to the symmetry plane along an arc, let go there, and loaded. Bricks know
that a sheet has width and stretches: strips of Planish bend only. The shape before the load differs
a little, so displacements are compared, from the unloaded shape to the loaded one.

    tools/compare_with_shells.py examples/slit/stool.json
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

GRAVITY = 9806.65  # mm/s²
ALONG, ACROSS = 48, 4  # bricks
SAMPLES = 24  # of the way to the symmetry plane


def rotation(vector):
    angle = np.linalg.norm(vector)
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def rotation_vector(turn):
    angle = math.acos(max(-1.0, min(1.0, (np.trace(turn) - 1) / 2)))
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    return angle * axis / max(np.linalg.norm(axis), 1e-12)


class Bricks:
    """A flat strip; its nodes by their place on a grid of half bricks."""

    def __init__(self, length, width, thickness):
        self.nodes, self.places, self.bricks = {}, {}, []
        for i in range(ALONG):
            for j in range(ACROSS):
                self.bricks.append(self.brick(2 * i, 2 * j))
        for (i, j, k), number in self.nodes.items():
            self.places[number] = np.array([length * i / (2 * ALONG),
                                            width * (j / (2 * ACROSS) - 0.5),
                                            thickness * (k / 2 - 0.5)])

    def node(self, *place):
        return self.nodes.setdefault(place, len(self.nodes) + 1)

    def brick(self, i, j):
        square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        middles = [(1, 0), (2, 1), (1, 2), (0, 1)]
        return ([self.node(i + a, j + b, 0) for a, b in square]
                + [self.node(i + a, j + b, 2) for a, b in square]
                + [self.node(i + a, j + b, 0) for a, b in middles]
                + [self.node(i + a, j + b, 2) for a, b in middles]
                + [self.node(i + a, j + b, 1) for a, b in square])

    def section(self, i):
        return [number for (a, _, _), number in self.nodes.items() if a == i]

    def skins(self, i):
        """Corners of bricks on both skins, which weigh alike."""
        return [number for (a, b, k), number in self.nodes.items()
                if a == i and b % 2 == 0 and k != 1]


class Strip:
    """A strip of a report: where it starts, and where its end is."""

    def __init__(self, report, number):
        self.ridges = report["slit"]["strips"][number]["ridges"]
        first, last, before = self.ridges[0], self.ridges[-1], self.ridges[-2]
        flat = np.array(first["flat"])
        self.length = last["flat"][0][0] - flat[:, 0].mean()
        self.width = abs(flat[1, 1] - flat[0, 1])
        self.start = self.middles()[0]
        up = np.array([0.0, 1.0, 0.0])  # the panel is upright
        self.first = self.frame(up, first["folded"])
        edge = np.array(last["folded"][0]) - np.array(before["folded"][0])
        self.last = self.frame(edge, last["folded"])

    @staticmethod
    def frame(along, ridge):
        across = np.array(ridge[1]) - np.array(ridge[0])
        across /= np.linalg.norm(across)
        along = along - along.dot(across) * across
        along = along / np.linalg.norm(along)
        return np.column_stack([along, across, np.cross(along, across)])

    def middles(self):
        return np.array([np.mean(ridge["folded"], axis=0) for ridge in self.ridges])

    def way(self):
        """Place and frame of the end on its way: an arc, then straight on."""
        turn = rotation_vector(self.last @ self.first.T)
        steps = 200
        for share in np.linspace(0, 1, SAMPLES):
            at = self.start + sum(rotation(share * turn * (s + 0.5) / steps) @ self.first[:, 0]
                                  for s in range(steps)) * self.length / steps
            yield share, at, rotation(share * turn) @ self.first
        for share in np.linspace(0, 1, SAMPLES)[1:]:
            yield 1 + share, at + share * (self.middles()[-1] - at), self.last


def mesh(bricks, place, material):
    out = ["*NODE"] + ["%d, %.9g, %.9g, %.9g" % (n, *at) for n, at in place.items()]
    out.append("*ELEMENT, TYPE=C3D20, ELSET=ALL")
    for i, brick in enumerate(bricks.bricks):
        out.append("%d, %s,\n%s" % (i + 1, ", ".join(map(str, brick[:10])),
                                    ", ".join(map(str, brick[10:]))))
    return out + ["*MATERIAL, NAME=SHEET", "*ELASTIC",
                  "%g, %g" % (material["young"], material.get("poisson", 0.3)),
                  "*DENSITY", "%g" % density_of(material),
                  "*SOLID SECTION, ELSET=ALL, MATERIAL=SHEET"]


def density_of(material):
    return material.get("density", 1.0) * 1e-9  # t/mm³


def led(bricks, place, strip):
    """How the nodes of the end go: the tables, and the conditions that name them."""
    tables, conditions = [], []
    way = list(strip.way())
    for n in bricks.section(2 * ALONG):
        local = bricks.places[n] - np.array([strip.length, 0, 0])
        goes = np.array([at + frame @ local - place[n] for _, at, frame in way])
        for axis in range(3):
            tables.append("*AMPLITUDE, NAME=A%d_%d, TIME=TOTAL TIME" % (n, axis))
            tables += ["%.6g, %.9g" % (time, goes[i, axis]) for i, (time, _, _) in enumerate(way)]
            conditions += ["*BOUNDARY, AMPLITUDE=A%d_%d" % (n, axis),
                           "%d, %d, %d, 1.0" % (n, axis + 1, axis + 1)]
    return tables, conditions


def forces(bricks, loads, mass, gravity):
    """Of the half of a strip: at nodes, and spread as a pull on its mass."""
    pull = np.array([0, -GRAVITY if gravity else 0.0, 0])
    out = ["*CLOAD"]
    for load in loads:
        force = 0.5 * np.array(load["force"], dtype=float)
        if "at" not in load:
            pull += force / mass
            continue
        nodes = bricks.skins(2 * round(load["at"] * ALONG))
        out += ["%d, %d, %.9g" % (n, axis + 1, force[axis] / len(nodes))
                for n in nodes for axis in range(3)]
    size = np.linalg.norm(pull)
    if size > 0:
        out += ["*DLOAD", "ALL, GRAV, %.9g, %.9g, %.9g, %.9g" % (size, *(pull / size))]
    return out


def deck(bricks, strip, design, loads):
    """The input of CalculiX: the end is led to its place, let go along the plane, and loaded."""
    place = {n: strip.start + strip.first @ at for n, at in bricks.places.items()}
    tables, conditions = led(bricks, place, strip)
    clamp = ["%d, 1, 3, 0" % n for n in bricks.section(0)]
    on_plane = ["%d, 1, 1, %.9g" % (n, -place[n][0]) for n in bricks.section(2 * ALONG)]
    done = ["*NODE PRINT, NSET=SKINS, FREQUENCY=9999", "U", "*END STEP"]
    step = ["*STEP, NLGEOM, INC=2000", "*STATIC"]
    skins = [n for i in range(ALONG + 1) for n in bricks.skins(2 * i)]
    mass = density_of(design["material"]) * strip.length * strip.width * design["thickness"]
    return "\n".join(mesh(bricks, place, design["material"]) + tables
                     + ["*NSET, NSET=SKINS"] + ["%d," % n for n in skins]
                     + step + ["0.01, 2.0, 1e-6, 0.05", "*BOUNDARY"] + clamp + conditions + done
                     + step + ["0.1, 1.0", "*BOUNDARY, OP=NEW"] + clamp + on_plane + done
                     + step + ["0.1, 1.0"]
                     + forces(bricks, loads, mass, design.get("gravity", False)) + done) + "\n"


def displacements(text):
    """Of each step's end: node to displacement."""
    steps = []
    for line in text.splitlines():
        words = line.split()
        if line.strip().startswith("displacements"):
            steps.append({})
        elif steps and len(words) == 4:
            steps[-1][int(words[0])] = np.array([float(w) for w in words[1:]])
    return steps


def bent(planish, design, folder, name):
    file = folder / (name + ".json")
    file.write_text(json.dumps(design))
    run = subprocess.run([planish, "slit", file, "--check", "--json", folder / "report.json"],
                         capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    return json.loads((folder / "report.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("design", help="slit file: symmetric, panels upright, no wishes, in mm")
    parser.add_argument("--planish", default="build/release/apps/planish")
    parser.add_argument("--ccx", default="ccx")
    parser.add_argument("--keep", help="folder for the files of CalculiX")
    options = parser.parse_args()
    design = json.loads(Path(options.design).read_text())
    folder = Path(options.keep or tempfile.mkdtemp())
    folder.mkdir(exist_ok=True)
    bare = {key: value for key, value in design.items() if key not in ("loads", "gravity")}
    unloaded = bent(options.planish, bare, folder, "unloaded")
    loaded = bent(options.planish, design, folder, "loaded")
    worst = 0.0
    for number in sorted({load["strip"] for load in design["loads"]}):
        strip, after = Strip(unloaded, number), Strip(loaded, number)
        bricks = Bricks(strip.length, strip.width, design["thickness"])
        loads = [load for load in design["loads"] if load["strip"] == number]
        job = folder / ("strip%d" % number)
        job.with_suffix(".inp").write_text(deck(bricks, strip, design, loads))
        run = subprocess.run([options.ccx, job.name], cwd=folder, capture_output=True, text=True)
        steps = displacements(job.with_suffix(".dat").read_text())
        if len(steps) < 3:
            sys.exit("CalculiX gave up:\n" + run.stdout[-2000:])
        count = len(after.ridges) - 1
        moved = after.middles() - strip.middles()
        shares = np.arange(count + 1) / count
        expected = np.array([np.mean([steps[2][n] - steps[1][n] for n in bricks.skins(2 * i)],
                                     axis=0) for i in range(ALONG + 1)])
        at = np.arange(ALONG + 1) / ALONG
        there = np.array([np.interp(shares, at, expected[:, axis]) for axis in range(3)]).T
        largest = np.linalg.norm(there, axis=1).max()
        off = np.linalg.norm(moved - there, axis=1).max() / largest
        worst = max(worst, off)
        print("strip %d: %.3f mm by CalculiX, %.3f mm by Planish; nowhere more than %.1f %% apart"
              % (number, largest, np.linalg.norm(moved, axis=1).max(), 100 * off))
    sys.exit(0 if worst <= 0.05 else 1)


if __name__ == "__main__":
    main()
