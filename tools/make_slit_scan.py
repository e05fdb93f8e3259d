#!/usr/bin/python3
"""Makes scans of a folded slit sheet, for examples and tests, as a scanner would have given them.

    planish slit chair.json --json report.json
    tools/make_slit_scan.py report.json --into scan --count 400 --noise 0.5 --seed 1

Writes scan0.xyz, scan1.xyz, …: for each strip points spread evenly over its quads, moved in a random
direction by a normal error of the given size (mm), one `x y z` a line. Equal seeds give equal files. Only the
ridges of the report are read. Needs nothing but Python 3.
"""

import argparse
import json
import math
import random


def between(a, b, share):
    return [p + share * (q - p) for p, q in zip(a, b)]


def area(near, far):
    """Of a plane quad, by its diagonals."""
    p = [b - a for a, b in zip(near[0], far[1])]
    q = [b - a for a, b in zip(far[0], near[1])]
    cross = (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])
    return 0.5 * math.hypot(*cross)


def points_of(ridges, count, noise, rng):
    quads = list(zip(ridges, ridges[1:]))
    weights = [area(near["folded"], far["folded"]) for near, far in quads]
    for near, far in rng.choices(quads, weights, k=count):
        along, across = rng.random(), rng.random()
        left = between(near["folded"][0], far["folded"][0], along)
        right = between(near["folded"][1], far["folded"][1], along)
        yield [x + rng.gauss(0.0, noise) for x in between(left, right, across)]


def main():
    parser = argparse.ArgumentParser(description="Makes scans of a folded slit sheet.")
    parser.add_argument("report", help="report of planish slit (JSON)")
    parser.add_argument("--into", default="scan", help="beginning of the files' names")
    parser.add_argument("--count", type=int, default=400, help="points a strip")
    parser.add_argument("--noise", type=float, default=0.5, help="standard deviation along each axis, mm")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    with open(arguments.report, encoding="utf-8") as file:
        strips = json.load(file)["slit"]["strips"]
    rng = random.Random(arguments.seed)
    for number, strip in enumerate(strips):
        with open(f"{arguments.into}{number}.xyz", "w", encoding="ascii") as file:
            for point in points_of(strip["ridges"], arguments.count, arguments.noise, rng):
                file.write("{:.2f} {:.2f} {:.2f}\n".format(*point))


if __name__ == "__main__":
    main()
