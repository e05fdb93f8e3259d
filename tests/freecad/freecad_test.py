"""The workbench of FreeCAD, inside FreeCAD: documents without a window, a window under Xvfb, real parts against the program.

The tests themselves are inside_*.py, which FreeCAD's own Python runs. tools/install-packages.sh test
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", HERE.parents[1])).resolve()
FOLDER = pathlib.Path(os.environ.get("PLANISH_PYTHON_FOLDER", SOURCE / "build/release/python")).resolve()
PLANISH = os.environ.get("PLANISH_CLI", "build/release/apps/planish")
PARTS = pathlib.Path(os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts")
WORKBENCH = SOURCE / "integrations/freecad"
ENOUGH_PARTS = 30
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
        process = subprocess.Popen([*program, "-u", str(self.path / "user.cfg"), str(HERE / script)], env=environment,
                                   cwd=self.path, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True,
                                   stderr=subprocess.STDOUT, errors="replace", start_new_session=True)
        try:
            said, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # xvfb-run alone would leave FreeCAD behind
            said, _ = process.communicate()
            raise AssertionError(f"{script} took more than {seconds} s:\n{said[-3000:]}") from None
        result = self.path / "result.json"
        return said, json.loads(result.read_text()) if result.is_file() else None


def command(*names):
    """The path of the first of some programs that is there."""
    return next((path for path in map(shutil.which, names) if path), None)


CONSOLE = command("freecadcmd", "FreeCADCmd")
WINDOW = command("freecad", "FreeCAD")


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
