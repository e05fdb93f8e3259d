#!/usr/bin/python3
"""The page's own tests of what it computes: folding, decoding of shapes, undo."""

import os
import pathlib
import re
import subprocess
import unittest

WEB = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2])) / "web"


class Page(unittest.TestCase):
    def test_its_types(self):
        done = subprocess.run(["npm", "run", "--silent", "typecheck"], cwd=WEB, capture_output=True, text=True, timeout=280)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_its_functions(self):
        done = subprocess.run(["npm", "test"], cwd=WEB, capture_output=True, text=True, timeout=280)
        failed = re.findall(r"^not ok .*?^  \.\.\.$", done.stdout, flags=re.M | re.S)
        self.assertEqual(done.returncode, 0, "\n".join(failed) or done.stdout[-4000:] + done.stderr[-4000:])
        self.assertRegex(done.stdout, r"# pass [1-9]")


if __name__ == "__main__":
    unittest.main(verbosity=2)
