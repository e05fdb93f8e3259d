"""Runs the program as a user does."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import step_files

CLI = os.environ.get("PLANISH_CLI", "planish")
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
SECONDS = 120


class CliTest(unittest.TestCase):
    """Each test has an empty folder of its own, `self.dir`, in which the program runs."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-")
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)

    def run_cli(self, *arguments, stdin=b"", status=0):
        done = subprocess.run([CLI, *map(str, arguments)], cwd=self.dir, input=stdin,
                              capture_output=True, timeout=SECONDS, check=False)
        out, err = done.stdout.decode(), done.stderr.decode()
        self.assertEqual(done.returncode, status, f"{arguments}\n{out}\n{err}")
        self.assertEqual(leftovers(self.dir), [], "half-written files")
        return out, err

    def refused(self, *arguments, status, stdin=b""):
        """What a failed run says: a line, and commands that would help; nothing is on standard output."""
        out, err = self.run_cli(*arguments, status=status, stdin=stdin)
        self.assertEqual(out, "")
        self.assertTrue(err.startswith("planish: "), err)
        said, *commands = err.splitlines()
        for command in commands:
            self.assertTrue(command.startswith("try: planish "), err)
        return said + "\n"

    def write(self, name, content):
        path = self.dir / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def angle(self, name="part.step", **sizes):
        return self.write(name, step_files.angle(**sizes))

    def json(self, name):
        return json.loads((self.dir / name).read_text())

    def names(self):
        return sorted(str(p.relative_to(self.dir)) for p in self.dir.rglob("*") if p.is_file())


def leftovers(folder):
    """Whatever a writer may leave beside its target."""
    wanted = {".step", ".stp", ".stpz", ".gz", ".zip", ".brep", ".stl", ".obj", ".dxf", ".svg", ".json", ".csv", ".txt", ".pdf"}
    return [str(p) for p in folder.rglob("*") if p.is_file() and p.suffix.lower() not in wanted]


def main():
    unittest.main(verbosity=2)
