#!/usr/bin/python3
"""Outside lengths of the bend table, of real parts that have one bend: less the deduction, they are the blank."""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_studio import SOURCE, Shape, StudioTest, main  # noqa: E402

PARTS = pathlib.Path(os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts")
WITHIN = 0.005  # mm
FINE = 1e-4  # mm; how far outlines may lie from curves
# The bend ends at the edge of the sheet, or is all of it.
WITHOUT = ("sm029", "sm126")


def size_across(shape, bend):
    """The size of the blank across the line of its bend, mm."""
    (x0, y0), (x1, y1) = bend["line"]
    length = math.hypot(x1 - x0, y1 - y0)
    points = shape.arrays["contour_points"]
    along = [(x * (y1 - y0) - y * (x1 - x0)) / length for x, y in zip(points[::2], points[1::2])]
    return max(along) - min(along)


class FlangeLengths(StudioTest):
    def one_bend_parts(self):
        if not PARTS.is_dir():
            self.skipTest("the real parts are absent: tools/fetch_parts.py brings them")
        rows = json.loads((PARTS / "manifest.json").read_text())
        rows = rows if isinstance(rows, list) else rows["parts"]
        return [PARTS / f"{row['id']}.step" for row in rows if row["n_bends"] == 1 and row["class"] != "assembly"]

    def test_less_the_deduction_they_are_the_blank(self):
        with tempfile.TemporaryDirectory() as folder:
            checked = []
            for path in self.one_bend_parts():
                document = self.studio.open(path.name, path.read_bytes()).json()["id"]
                shown = self.studio.post(document, "result").body
                shape = Shape(shown)
                bends = (shape.report["flat"] or {}).get("bends", [])
                if len(bends) == 1:
                    request = json.dumps({"options": {}, "chord": FINE})
                    fine = Shape(self.studio.ask("POST", f"/api/documents/{document}/result", request).body)
                    self.assertEqual(shape.report["units"], "mm", path.name)
                    saved = pathlib.Path(folder) / path.name
                    saved.write_bytes(shown)
                    checked.append((path.name, saved, bends[0], size_across(fine, bends[0])))
                self.tearDown()
            done = subprocess.run(["npx", "tsx", "test/flange-lengths-of.ts", *(str(saved) for _, saved, *_ in checked)],
                                  cwd=SOURCE / "web", capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(len(checked), 20)
        for (name, _, bend, blank), lengths in zip(checked, json.loads(done.stdout), strict=True):
            with self.subTest(name):
                outside = lengths[bend["id"]]
                if name.startswith(WITHOUT):
                    self.assertIn("no flange on one of its sides", outside)
                    continue
                self.assertAlmostEqual(sum(row["length"] for row in outside) - bend["deduction"], blank, delta=WITHIN)


if __name__ == "__main__":
    main()
