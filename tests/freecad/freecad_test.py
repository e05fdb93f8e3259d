"""The workbench of FreeCAD, inside FreeCAD: documents without a window, a window under Xvfb, real parts against the program.

The tests themselves are inside_*.py, which FreeCAD's own Python runs. tools/install-packages.sh test
"""

import collections
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", HERE.parents[1])).resolve()
FOLDER = pathlib.Path(os.environ.get("PLANISH_PYTHON_FOLDER", SOURCE / "build/release/python")).resolve()
PLANISH = os.environ.get("PLANISH_CLI", "build/release/apps/planish")
PARTS = pathlib.Path(os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts")
WORKBENCH = SOURCE / "integrations/freecad"
ENOUGH_PARTS = 30
MOST_PARTS = int(os.environ.get("PLANISH_MOST", "90"))
ENOUGH_BESIDE = 20  # with bends
CONFIGURATION = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PlanishWorkbench</FCText></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


class Home:
    """A home in which the workbench is installed, as a user installs it: one folder in Mod."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="planish-")
        self.path = pathlib.Path(self._folder.name)
        mod = self.path / ".local/share/FreeCAD/Mod"
        mod.mkdir(parents=True)
        shutil.copytree(WORKBENCH, mod / "Planish", ignore=shutil.ignore_patterns("__pycache__"))
        (self.path / "user.cfg").write_text(CONFIGURATION)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._folder.cleanup()

    def run(self, program, script, *, seconds, **more):
        """Runs a script in FreeCAD; returns its output and what it left in result.json."""
        environment = {**os.environ, "HOME": str(self.path), "XDG_RUNTIME_DIR": str(self.path), "LIBGL_ALWAYS_SOFTWARE": "1",
                       "XDG_DATA_HOME": str(self.path / ".local/share"), "PLANISH_PYTHON_FOLDER": str(FOLDER),
                       "PLANISH_SOURCE_DIR": str(SOURCE), "PLANISH_RESULT": str(self.path / "result.json"),
                       "PLANISH_SCRATCH": str(self.path), **more}
        result = self.path / "result.json"
        result.unlink(missing_ok=True)
        process = subprocess.Popen([*program, "-u", str(self.path / "user.cfg"), str(HERE / script)], env=environment,
                                   cwd=self.path, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True,
                                   stderr=subprocess.STDOUT, errors="replace", start_new_session=True)
        try:
            said, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # xvfb-run alone would leave FreeCAD behind
            said, _ = process.communicate()
            raise AssertionError(f"{script} took more than {seconds} s:\n{said[-3000:]}") from None
        return said, json.loads(result.read_text()) if result.is_file() else None


def command(*names):
    """The path of the first of some programs that is there."""
    return next((path for path in map(shutil.which, names) if path), None)


def sheetmetal():
    """The folder of the workbench SheetMetal: the one that is named, or that of the user or the system."""
    if os.environ.get("PLANISH_SHEETMETAL"):
        return pathlib.Path(os.environ["PLANISH_SHEETMETAL"]).resolve()
    data = pathlib.Path(os.environ.get("XDG_DATA_HOME") or pathlib.Path.home() / ".local/share") / "FreeCAD"
    folders = [data, *sorted(data.glob("v*")), pathlib.Path.home() / ".FreeCAD",
               *(pathlib.Path(base) / "freecad" for base in ("/usr/local/share", "/usr/local/lib", "/usr/share", "/usr/lib"))]
    found = (folder / "Mod/SheetMetal" for folder in folders)
    return next((folder for folder in found if (folder / "SheetMetalNewUnfolder.py").is_file()), None)


CONSOLE = command("freecadcmd", "FreeCADCmd")
WINDOW = command("freecad", "FreeCAD")
SHEETMETAL = sheetmetal()


class Package(unittest.TestCase):
    def test_its_version_is_that_of_the_program(self):
        written = re.search(r"<version>(.*)</version>", (WORKBENCH / "package.xml").read_text())[1]
        said = subprocess.run([PLANISH, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(written, said.split()[-1])


@unittest.skipUnless(CONSOLE, "FreeCAD is not installed: tools/install-packages.sh test")
class WithoutWindow(unittest.TestCase):
    def assert_all_passed(self, said, result):
        self.assertIsNotNone(result, said[-3000:])
        self.assertFalse(result["failures"], "\n".join(result["failures"]))
        self.assertEqual(result["skipped"], [])

    def test_documents(self):
        with Home() as home:
            said, result = home.run([CONSOLE], "inside_documents.py", seconds=300)
            self.assert_all_passed(said, result)
            self.assertGreaterEqual(result["run"], 20)

    def test_without_the_package_it_says_how_to_get_it(self):
        with Home() as home:
            said, result = home.run([CONSOLE], "inside_missing.py", seconds=60, PLANISH_PYTHON_FOLDER="/nowhere",
                                    PYTHONPATH="")
            self.assertIsNotNone(result, said[-3000:])
            self.assertEqual(result["code"], "no_planish")
            self.assertIn("apt install", result["message"])
            self.assertIn("Preferences", result["message"])
            self.assertEqual(result["objects"], 1)

    @unittest.skipUnless(PARTS.is_dir(), f"there is no folder {PARTS}")
    def test_real_parts_are_as_large_as_by_the_program(self):
        with Home() as home:
            said, made = home.run([CONSOLE], "inside_parts.py", seconds=500, PLANISH_PARTS=str(PARTS))
            self.assertIsNotNone(made, said[-3000:])
            self.assertGreaterEqual(len([one for one in made if "area" in one]), ENOUGH_PARTS)
            for one in made:
                with self.subTest(one["file"]):
                    done = subprocess.run([PLANISH, "unfold", str(PARTS / one["file"]), "--k", "0.44", "--json",
                                           str(home.path / "report.json"), "-o", str(home.path / "part.dxf")],
                                          capture_output=True, text=True, timeout=120, check=False)
                    report = json.loads((home.path / "report.json").read_text())
                    if report["flat"] is None or done.returncode:
                        self.assertEqual(one.get("code"), report["reason"]["code"])
                        continue
                    self.assertNotIn("code", one)
                    # FreeCAD reads surfaces its own way, and where walls are uneven so is the mean thickness.
                    even = report["sheet"]["thickness_spread"] < 1e-6
                    self.assertAlmostEqual(one["report"] / report["flat"]["area"], 1.0, delta=1e-9 if even else 1e-7)
                    # The face is measured by FreeCAD: holes are holes, curves are exact.
                    self.assertAlmostEqual(one["area"] / report["flat"]["area"], 1.0, delta=1e-6)
                    self.assertTrue(one["valid"])
                    self.assertEqual(one["holes"], report["flat"]["openings"])

    @unittest.skipUnless(PARTS.is_dir(), f"there is no folder {PARTS}")
    @unittest.skipUnless(SHEETMETAL, "the workbench SheetMetal is not installed, and PLANISH_SHEETMETAL does not name its folder")
    def test_patterns_are_as_large_as_those_of_sheetmetal(self):
        counts = collections.Counter()
        with Home() as home:
            for path in sorted(PARTS.glob("*.step")):
                if path.name.startswith("neg") or counts["parts"] == MOST_PARTS:
                    continue
                try:  # a process for each: what stops FreeCAD stops one part
                    _, result = home.run([CONSOLE], "inside_sheetmetal.py", seconds=60, PLANISH_PART=str(path),
                                         PLANISH_SHEETMETAL=str(SHEETMETAL))
                except AssertionError:
                    result = None
                result = result or {"solids": 1}
                if "missing" in result:
                    stop = self.fail if os.environ.get("PLANISH_SHEETMETAL") else self.skipTest
                    stop(f"the unfolder in {SHEETMETAL} cannot be loaded (python3-networkx?): {result['missing']}")
                if result["solids"] != 1:
                    continue
                counts["parts"] += 1
                theirs, ours = result.get("sheetmetal"), result.get("planish")
                counts[theirs is not None, ours is not None] += 1
                # Where SheetMetal's pattern for K = 1/2 holds the whole part it is right, and so it is for every K.
                if theirs and theirs["valid"] and abs(theirs["filled"] - 1) < 1e-8:
                    with self.subTest(path.name):
                        self.assertIsNotNone(ours, result.get("planish_reason"))
                        self.assertAlmostEqual(ours["area"] / theirs["area"], 1.0, delta=1e-8)
                        counts["agree"] += ours["bends"] > 0
        print(f"\nof {counts['parts']} parts both unfold {counts[True, True]}, SheetMetal alone {counts[True, False]}, Planish alone "
              f"{counts[False, True]}; whole and the same, with bends: {counts['agree']}", file=sys.stderr)
        self.assertGreaterEqual(counts["agree"], ENOUGH_BESIDE)


@unittest.skipUnless(WINDOW and shutil.which("xvfb-run"), "FreeCAD or Xvfb is not installed: tools/install-packages.sh test")
class InAWindow(unittest.TestCase):
    def test_commands_panels_and_undo(self):
        keep = os.environ.get("PLANISH_PICTURES")
        with Home() as home:
            said, result = home.run(["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", WINDOW], "inside_window.py", seconds=240)
            self.assertIsNotNone(result, said[-3000:])
            self.assertFalse(result["failures"], "\n".join(result["failures"]))
            self.assertGreaterEqual(result["run"], 8)
            for picture in sorted(home.path.glob("*.png")):
                self.assertGreater(picture.stat().st_size, 5000, picture.name)
                if keep:
                    shutil.copy(picture, keep)


if __name__ == "__main__":
    unittest.main()
