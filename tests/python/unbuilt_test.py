"""A tree in which the package for Python is not built yet says so, and how to build it."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))


class Unbuilt(unittest.TestCase):
    def test_importing_it_names_the_command_that_builds_it(self):
        with tempfile.TemporaryDirectory(prefix="planish-unbuilt-") as build:
            subprocess.run(["cmake", "-G", "Ninja", "-S", SOURCE, "-B", build, "-DPLANISH_TESTS=OFF", "-DPLANISH_STUDIO=OFF"],
                           capture_output=True, check=True)
            done = subprocess.run(["/usr/bin/python3", "-c", "import planish"], env={"PYTHONPATH": f"{build}/python"},
                                  capture_output=True, text=True, check=False)
            command = f"ninja -C {build} planish_python"
            self.assertEqual(done.stderr.splitlines()[-1], f"ImportError: planish is not built here yet. Build it: {command}")
            (pathlib.Path(build) / "plan.ninja").symlink_to("build.ninja")  # which is not to be made again first
            planned = subprocess.run([*command.split(), "-f", "plan.ninja", "-n"], capture_output=True, text=True, check=True).stdout
            # Its place is taken when everything else is there.
            self.assertGreater(planned.index("python/planish/__init__.py"), planned.index("Writing the makers"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
