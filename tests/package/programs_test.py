#!/usr/bin/python3
"""The programs of examples/programs, built against an installed planish: programs_test.py FOLDER EXAMPLES.

A square tube is closed all round: its refusal names walls, and no end of it."""

import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
import step_files  # noqa: E402

folder, examples = map(pathlib.Path, sys.argv[1:])
with tempfile.TemporaryDirectory() as scratch:
    tube = pathlib.Path(scratch) / "tube.step"
    tube.write_text(step_files.square_tube())
    batch = subprocess.run([folder / "own_batch", examples / "bracket.step", tube], capture_output=True, text=True, check=False)
    assert batch.returncode == 4, batch
    head, bracket, refused = batch.stdout.splitlines()
    cells = dict(zip(head.split(";"), bracket.split(";"), strict=True))
    assert float(cells["thickness"]) == 2 and int(cells["bends"]) == 2, cells
    assert 0.5 < float(cells["area"]) / (float(cells["length"]) * float(cells["width"])) <= 1, cells
    assert refused.startswith(f"{tube};;;;;;;") and "face" in refused, refused

    shown = subprocess.run([folder / "show_refusal", tube], capture_output=True, text=True, check=False)
    assert shown.returncode == 0, shown
    groups = {}
    points = []
    for line in shown.stdout.splitlines():
        kind, *words = line.split()
        if kind == "v":
            points.append(tuple(map(float, words)))
        elif kind == "g":
            groups[words[0]] = []
            last = groups[words[0]]
        else:
            last.append([points[int(word) - 1] for word in words])
    assert groups["named"] and groups["other"], shown.stderr
    low, high = (f(p[2] for p in points) for f in (min, max))
    ends = [t for t in groups["named"] if all(p[2] == low for p in t) or all(p[2] == high for p in t)]
    assert not ends, "the ends of the tube are not what is closed"
