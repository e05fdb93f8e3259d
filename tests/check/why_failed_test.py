#!/usr/bin/python3
"""What ./test says last: tools/why_failed.py, of what ctest, GoogleTest, unittest and Ninja really print."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
GOOGLETEST = """\
Running main() from gtest_main.cc
[==========] Running 1 test from 1 test suite.
[ RUN      ] Cone.Unrolls
/src/tests/cone_test.cpp:12: Failure
Expected equality of these values:
  angle
    Which is: 2
  3
the apex
[  FAILED  ] Cone.Unrolls (0 ms)
[  FAILED  ] 1 test, listed below:
"""
UNITTEST = """\
import unittest
def deeper(self): self.assertEqual([1], [2], "much is said\\n" * 200)
class T(unittest.TestCase):
    def test_wrong(self): deeper(self)
    def test_described(self):
        "It is described."
        raise ValueError("a wrong value")
    def test_quoting(self): self.assertEqual(1, 0, "TAP\\nok 1\\n" * 40 + "not ok 3 - folds\\n  error: 'crypto is not defined'")
    def test_left_out(self): self.skipTest("no terminal")
unittest.main(verbosity=2)
"""


class WhyFailed(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-why-")
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.dir / name).write_text(text, encoding="utf-8")
        return self.dir / name

    def why(self, what, path):
        done = subprocess.run([SOURCE / "tools" / "why_failed.py", what, path], capture_output=True, text=True, check=True)
        lines = done.stdout.splitlines()
        self.assertLessEqual(len(lines), 60, done.stdout)
        self.assertLessEqual(max(map(len, lines), default=0), 210)
        return done.stdout

    def said_of(self, tests, end_after=None):
        """What is said of these tests, run by ctest; it is killed after so many seconds."""
        self.write("CTestTestfile.cmake", "".join(f'add_test({name} "{sys.executable}" "{self.write(name + "_test.py", text)}")\n'
                                                  for name, text in tests.items()))
        with open(self.dir / "log", "w", encoding="utf-8") as log, \
                subprocess.Popen(["ctest", "--output-on-failure", "--parallel", "2"], cwd=self.dir, stdout=log, stderr=log,
                                 start_new_session=True) as process:
            if end_after:
                time.sleep(end_after)
                os.killpg(process.pid, signal.SIGKILL)
            process.wait(60)
        return self.why("tests", self.dir / "log")

    def test_each_failed_test_is_named_with_its_reason(self):
        said = self.said_of({"passes": "print('fine')", "cone": f"import sys; print({GOOGLETEST!r}); sys.exit(1)", "scripts": UNITTEST,
                           "crashes": "import os; print('assertion x > 0 failed', flush=True); os.abort()"})
        for part in ("3 tests failed:", "cone  (Failed)", "/src/tests/cone_test.cpp:12: Failure", "Which is: 2", "the apex",
                     "scripts  (Failed)", "FAIL: test_wrong", "AssertionError: Lists differ: [1] != [2]", 'scripts_test.py", line 2, in deeper',
                     "ERROR: test_described", "ValueError: a wrong value", "not ok 3 - folds", "error: 'crypto is not defined'",
                     "crashes  (Subprocess aborted)", "assertion x > 0 failed", "./test -R '^cone$' -V"):
            self.assertIn(part, said)
        for part in ("passes", "Running main", "[  FAILED"):
            self.assertNotIn(part, said)

    def test_many_failures_fit(self):
        said = self.said_of({f"test{number}": UNITTEST for number in range(40)})
        self.assertIn("40 tests failed:", said)
        self.assertIn("24 more, the last ", said)

    def test_a_killed_run_names_what_was_running(self):
        said = self.said_of({"fails": "raise SystemExit('in vain')", "sleeps": "import time; time.sleep(60)"}, end_after=3)
        self.assertIn("ctest did not come to its end; it had done 1 tests.\n  was running: sleeps\n", said)
        self.assertIn("fails  (Failed)\n  | in vain\n", said)

    def test_what_was_left_out_is_said(self):
        self.said_of({"scripts": UNITTEST})
        self.assertEqual(self.why("skipped", self.dir / "Testing/Temporary/LastTest.log"),
                         "Left out (1):\n  scripts, test_left_out: no terminal\n")

    def test_a_build_says_its_errors(self):
        self.write("a.cpp", "int f() { return undeclared; }\n")
        self.write("build.ninja", "rule cxx\n  command = c++ -c $in -o $out && : " + "x" * 3000 + "\nbuild a.o: cxx a.cpp\n")
        done = subprocess.run(["ninja"], cwd=self.dir, capture_output=True, text=True, check=False)
        said = self.why("step", self.write("log", done.stdout + done.stderr))
        self.assertIn("FAILED: a.o", said)
        self.assertRegex(said, r"a\.cpp:1:18: error: .undeclared. was not declared")
        self.assertNotIn("xxx", said)

    def test_a_configuration_says_its_errors(self):
        self.write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\nproject(x NONE)\nfind_package(nonsense REQUIRED)\n")
        done = subprocess.run(["cmake", "-S", self.dir, "-B", self.dir / "build"], capture_output=True, text=True, check=False)
        said = self.why("step", self.write("log", done.stdout + done.stderr))
        self.assertIn("CMake Error at CMakeLists.txt:3 (find_package):", said)


if __name__ == "__main__":
    unittest.main(verbosity=2)
