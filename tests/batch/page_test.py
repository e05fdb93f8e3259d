#!/usr/bin/python3
"""The page of a batch of 2,000 parts in a browser without a window, opened as a file."""

import json
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from batch_case import SOURCE, BatchTest, main, step_files  # noqa: E402

PARTS = 2000


class PageOfABatch(BatchTest):
    def setUp(self):
        super().setUp()
        if not (SOURCE / "web" / "node_modules").is_dir() or not shutil.which("node"):
            self.skipTest("the browser is driven by node packages that are not installed here")

    def test_it_is_usable(self):
        (self.dir / "in").mkdir()
        for i in range(PARTS - 3):
            self.write(f"in/part-{i:04}.step", step_files.angle(leg=40.0 + 0.05 * i, depth=30.0))
        self.write("in/copy.step", step_files.angle(leg=40.0, depth=30.0))
        self.write("in/block <b>&amp;.step", step_files.block())
        self.write("in/umlaut # ü%20.step", step_files.angle(leg=45.025, depth=31.0))
        self.write("in/drawing.pdf", "%PDF")
        self.batch("in", "-o", "out", "-q", seconds=300)
        pictures = self.dir / "pictures"
        pictures.mkdir()
        done = subprocess.run(["node", "test/batch-page.mjs", str(self.dir / "out" / "index.html"), str(pictures)],
                              cwd=SOURCE / "web", capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        seen = json.loads(done.stdout)
        self.assertEqual(seen["said"], [], "nothing on the console")
        self.assertEqual(seen["firstStatus"], "ok", "results first")
        self.assertEqual(seen["sums"], [f"{PARTS - 1} ok", "0 with warnings", "1 refused"])
        self.assertEqual(seen["why"], "refused: not a sheet")
        self.assertEqual(seen["passed"], "1 file or folder was passed over")
        # Pictures are loaded as one scrolls, not all at once.
        self.assertGreater(seen["first"]["pictures"], 4)
        self.assertLess(seen["first"]["rows"], 300)
        self.assertGreater(seen["scrolled"]["pictures"], seen["first"]["pictures"])
        self.assertEqual((seen["first"]["broken"], seen["scrolled"]["broken"]), (0, 0))
        self.assertEqual(seen["all"], f"{PARTS} of {PARTS} parts")
        self.assertEqual(seen["refused"], f"1 of {PARTS} parts")
        self.assertEqual(seen["ok"], f"{PARTS - 1} of {PARTS} parts")
        self.assertEqual(seen["named"], ["part-0012.step"])
        # Lengths are 2 leg + a constant, 0.1 mm apart: those from 100 to 110 are 101, give or take one.
        self.assertRegex(seen["sized"], rf"^(99|100|101|102) of {PARTS} parts$")
        self.assertEqual(seen["sorted"], "ascending copy.step")
        self.assertEqual(seen["down"], f"part-{PARTS - 4:04}.step")
        self.assertEqual(sorted(seen["same"]), ["copy.step", "part-0000.step"])
        self.assertEqual(seen["reasons"], ["", "not_a_sheet"])


if __name__ == "__main__":
    main()
