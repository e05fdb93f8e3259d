"""Runs what docs/python.md and the README tell people to write."""

import html
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

FOLDER = pathlib.Path(os.environ.get("PLANISH_PYTHON_FOLDER", "build/release/python")).resolve()
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))


def blocks_of(name):
    return re.findall(r"^```python\n(.*?)^```", (SOURCE / name).read_text(), re.M | re.S)


class Tutorial(unittest.TestCase):
    def run_blocks(self, name):
        with tempfile.TemporaryDirectory(prefix="planish-") as folder:
            (pathlib.Path(folder) / "examples").symlink_to(SOURCE / "examples")
            done = subprocess.run(["/usr/bin/python3", "-W", "error::SyntaxWarning", "-c", "\n".join(blocks_of(name))],
                                  cwd=folder, env={**os.environ, "PYTHONPATH": str(FOLDER)}, text=True,
                                  capture_output=True, check=False, timeout=300)
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stdout, {path.name for path in pathlib.Path(folder).iterdir()}

    def test_the_tutorial(self):
        said, files = self.run_blocks("docs/python.md")
        self.assertGreaterEqual(len(blocks_of("docs/python.md")), 10)
        self.assertTrue({"bracket.dxf", "bracket.svg", "bracket.pdf", "bracket_flat.step", "folded.step", "plan.pdf",
                         "flat", "shop"} <= files, files)
        self.assertIn("B1 up 90.0", said)
        self.assertIn("no_such_body", said)

    def test_the_notebook(self):
        cells = json.loads((SOURCE / "docs/python/notebook.ipynb").read_text())["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        with tempfile.TemporaryDirectory(prefix="planish-") as folder:
            (pathlib.Path(folder) / "examples").symlink_to(SOURCE / "examples")
            done = subprocess.run(["/usr/bin/python3", "-c", "\n".join(code)], cwd=folder, text=True, check=False,
                                  capture_output=True, timeout=300, env={**os.environ, "PYTHONPATH": str(FOLDER)})
        self.assertEqual(done.returncode, 0, done.stderr)
        page = html.unescape((SOURCE / "docs/python/notebook.html").read_text())
        for line in done.stdout.splitlines():
            self.assertIn(line, page, "tools/make_notebook.sh makes the page again")
        self.assertGreaterEqual(page.count("<svg"), 3)

    def test_the_lines_of_the_readme(self):
        said, files = self.run_blocks("README.md")
        self.assertEqual(len(blocks_of("README.md")[0].splitlines()), 5)
        self.assertIn("part.dxf", files)
        self.assertRegex(said, r"\d")


if __name__ == "__main__":
    unittest.main()
