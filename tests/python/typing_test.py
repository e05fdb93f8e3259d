"""The types of the package: mypy over its sources, its stub against the library, and programs that use it."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PYTHON = "/usr/bin/python3"
FOLDER = pathlib.Path(os.environ.get("PLANISH_PYTHON_FOLDER", "build/release/python")).resolve()
RIGHT = '''
import numpy as np
from numpy.typing import NDArray
import planish

def area(path: str) -> float:
    part: planish.Part = planish.unfold(path, k=0.44, extruded="pilot", bend_k={"B1": 0.4})
    outline: NDArray[np.float64] = part.flat.outline
    part.write("x.dxf", profile="inventor")
    for bend in part.flat.bends:
        lines: NDArray[np.float64] = bend.lines
    try:
        plan: planish.BendPlan = planish.bend(path, metal="steel", progress=lambda stage, share: share < 0.5)
    except planish.Refused as refused:
        code: str = refused.code
    return part.flat.area + float(outline.sum())
'''
WRONG = ["planish.unfold('x.step', k='much')", "planish.unfold('x.step', extruded='round')",
         "planish.unfold('x.step', no_such_option=1)", "planish.connect({}, k=0.4).flat.outline.nothing",
         "x: int = planish.unfold('x.step').flat.area", "planish.unfold()"]


def mypy(*arguments, folder, module="mypy"):
    environment = {**os.environ, "MYPYPATH": str(FOLDER), "PYTHONPATH": str(FOLDER)}
    done = subprocess.run([PYTHON, "-m", module, *arguments], cwd=folder, env=environment, capture_output=True,
                          text=True, check=False, timeout=600)
    return done.returncode, done.stdout + done.stderr


class Typing(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-")
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)

    def test_the_package_is_typed_throughout(self):
        status, said = mypy("--strict", "-p", "planish", folder=self.dir)
        self.assertEqual(status, 0, said)

    def test_the_stub_is_that_of_the_library(self):
        # What pybind11 gives every class: a metaclass, and an __init__ that refuses.
        of_pybind = [f"planish._planish.{name}{end}" for name in ("Mesh", "Part") for end in ("", ".__init__")]
        (self.dir / "allowed").write_text("\n".join(of_pybind))
        status, said = mypy("planish._planish", "--allowlist", "allowed", folder=self.dir, module="mypy.stubtest")
        self.assertEqual(status, 0, said)

    def test_programs_that_use_it(self):
        (self.dir / "right.py").write_text(RIGHT)
        status, said = mypy("--strict", "right.py", folder=self.dir)
        self.assertEqual(status, 0, said)
        for number, line in enumerate(WRONG):
            (self.dir / f"wrong{number}.py").write_text(f"import planish\n{line}\n")
        status, said = mypy("--strict", *(f"wrong{number}.py" for number in range(len(WRONG))), folder=self.dir)
        self.assertEqual(status, 1)
        for number, line in enumerate(WRONG):
            self.assertIn(f"wrong{number}.py:2: error", said, line)


if __name__ == "__main__":
    unittest.main()
