"""The memory of the package: AddressSanitizer over threads, errors and objects that outlive others; leaks; growth."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PYTHON = "/usr/bin/python3"
FOLDER = pathlib.Path(os.environ.get("PLANISH_PYTHON_FOLDER", "build/release/python")).resolve()
SANITIZED = FOLDER.parent / "python_sanitized/planish/_planish.so"
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))

WORK = """
import gc, json, os, sys, threading
import planish

examples = sys.argv[1]
bracket = os.path.join(examples, "bracket.step")
plates = os.path.join(examples, "connect/a_folded.json")

def everything(turn):
    part = planish.unfold(bracket, progress=lambda stage, share: None)
    outline, lines, points = part.flat.outline, part.flat.bends[0].lines, part.mesh().points
    finer = part.flat.polygons(0.5).outline
    part.artifact("dxf", profile="inventor"), part.artifact("svg"), part.flat.curves()
    del part
    gc.collect()
    assert outline.sum() != 0 and lines.sum() != 0 and points.sum() != 0 and finer.sum() != 0
    def fails(stage, share):
        raise RuntimeError(stage)
    for wrong in (lambda: planish.unfold(bracket, progress=fails), lambda: planish.unfold(bracket, k=9),
                  lambda: planish.unfold(b"rubbish"), lambda: planish.unfold("nowhere.step"),
                  lambda: planish.unfold(bracket, progress=lambda stage, share: False),
                  lambda: planish.connect({"format": "planish/plates"}), lambda: planish.bend(plates, clearance=100)):
        try:
            wrong()
        except (planish.Error, RuntimeError):
            pass
        else:
            raise AssertionError("nothing was raised")
    planish.connect(plates), planish.info(bracket, sheets=True)
"""
SANITIZED_RUN = WORK + """
threads = [threading.Thread(target=everything, args=(turn,)) for turn in range(8)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
everything(8)
print("done")
"""
GROWTH = WORK + """
import ctypes

class Mallinfo2(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in
                ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks",
                 "keepcost")]

libc = ctypes.CDLL("libc.so.6")
libc.mallinfo2.restype = Mallinfo2

def in_use():
    gc.collect()
    now = libc.mallinfo2()
    return now.uordblks + now.hblkhd

for turn in range(5):
    everything(turn)
before = in_use()
for turn in range(12):
    everything(turn)
print((in_use() - before) / 12)
"""


def without_planish_frames(text):
    """Leaks whose stack goes through the library after it was loaded."""
    leaks = []
    for leak in re.split(r"\n\n", text):
        if "leak of" not in leak or "_planish" not in leak:
            continue
        if "PyInit__planish" in leak or "pybind11_init__planish" in leak:
            continue
        leaks.append(leak)
    return leaks


class Memory(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-")
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)

    def run_python(self, script, **environment):
        return subprocess.run([PYTHON, "-c", script, str(SOURCE / "examples")], cwd=self.dir, check=False, text=True,
                              capture_output=True, timeout=240, env={**os.environ, **environment})

    @unittest.skipUnless(SANITIZED.exists(), "the sanitized library is not built")
    def test_is_sound_in_eight_threads(self):
        package = self.dir / "planish"
        shutil.copytree(FOLDER / "planish", package, ignore=shutil.ignore_patterns("_planish*.so", "__pycache__"))
        shutil.copy(SANITIZED, package / "_planish.so")
        # The library of exceptions comes with it: the interpreter itself has none to be watched.
        preloaded = [subprocess.run(["g++", f"-print-file-name={name}"], capture_output=True, text=True,
                                    check=True).stdout.strip() for name in ("libasan.so", "libstdc++.so")]
        done = self.run_python(SANITIZED_RUN, PYTHONPATH=str(self.dir), PYTHONMALLOC="malloc",
                               LD_PRELOAD=" ".join(preloaded), ASAN_OPTIONS="detect_leaks=1:exitcode=23")
        self.assertIn("done", done.stdout, done.stderr[-5000:])
        self.assertNotIn("ERROR: AddressSanitizer", done.stderr, done.stderr[-5000:])
        self.assertEqual(without_planish_frames(done.stderr), [])

    def test_does_not_grow(self):
        done = self.run_python(GROWTH, PYTHONPATH=str(FOLDER))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(float(done.stdout), 2000.0, "bytes a turn")


if __name__ == "__main__":
    unittest.main()
