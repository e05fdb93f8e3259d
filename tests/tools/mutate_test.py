#!/usr/bin/python3
"""tools/mutate, with a module of one source in a project of its own."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR",
                                   pathlib.Path(__file__).resolve().parents[2]))
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))
import mutants  # noqa: E402

SOURCE = """#include "clamp.hpp"

// 1 < 2 in a comment
int clamp(int x, int low, int high) {
  if (x < low) return low;
  if (x > high) return high;
  return x;
}

int twice(int x) {
  int sum = x;
  sum = sum + x;
  return sum;
}

int countdown(int from) {
  volatile int n = from;
  while (n != 3) n = n - 1;
  return n;
}
"""
HEADER = "int clamp(int x, int low, int high);\nint twice(int x);\nint countdown(int from);\n"
# The sum of nothing and nothing is also their difference; a countdown that counts up does not end.
TEST = """#include "clamp.hpp"
int main() {
  const bool right = clamp(-3, 0, 9) == 0 && clamp(4, 0, 9) == 4 && twice(0) == 0 && countdown(4) == 3;
  return right ? 0 : 1;
}
"""
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(toy LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
add_library(planish_toy src/toy/clamp.cpp)
target_include_directories(planish_toy PUBLIC src/toy)
add_executable(toy_tests tests/toy/main_test.cpp)
target_link_libraries(toy_tests planish_toy)
"""


def after(line, text=None):
    """What a line of code may become."""
    return [mutant.after for mutant in mutants.mutants("a.cpp", text or f"{{\n{line}\n}}")]


class Changes(unittest.TestCase):
    def test_operators_numbers_and_conditions(self):
        self.assertEqual(after("  if (a < b) return;"), ["  if (a >= b) return;"])
        self.assertIn("  if (i <= n) return;", after("  if (i < n) return;"))
        self.assertIn("  return a - b;", after("  return a + b;"))
        self.assertIn("  return a * b;", after("  return a / b;"))
        self.assertIn("  return a || b;", after("  return a && b;"))
        self.assertIn("  return seen;", after("  return !seen;"))
        self.assertIn("  return x;", after("  return -x;"))
        self.assertIn("  return std::max(a, b);", after("  return std::min(a, b);"))
        self.assertIn("  return points[i + 2];", after("  return points[i + 1];"))
        self.assertIn("  return x * 1.0;", after("  return x * 0.5;"))
        self.assertIn("  if (!(closed(loop))) return;", after("  if (closed(loop)) return;"))

    def test_a_statement_is_dropped_and_a_declaration_is_not(self):
        self.assertIn("  ;", after("  place.shift += along;"))
        self.assertIn("  ;", after("  rows.push_back(row);"))
        self.assertNotIn("  ;", after("  double shift = along;"))
        self.assertNotIn("  ;", after("  return f(x);"))

    def test_words_assertions_tolerances_and_templates_are_left_alone(self):
        for line in ['  PLANISH_ASSERT(a < b + 1);', '  return error(Code::bad, "1 < 2", n + 1);',
                     "  constexpr double kNear = 2.0 * 1e-9;", "  std::vector<int> a;", "#if A < 2",
                     "  const double least = 2.0 * kAside;", "  // a + b", "  T* p = &a;"]:
            self.assertEqual(after(line), [], line)

    def test_a_seed_chooses_the_same_ones_again_and_others_for_another(self):
        found = mutants.mutants("a.cpp", SOURCE)
        once, again, other = (mutants.chosen(found, 4, seed) for seed in (1, 1, 2))
        self.assertEqual(once, again)
        self.assertNotEqual(once, other)
        self.assertEqual(len({mutant.line for mutant in once}), 4)


class Program(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.root = pathlib.Path(cls.folder.name)
        for name, text in {"src/toy/clamp.cpp": SOURCE, "src/toy/clamp.hpp": HEADER,
                           "tests/toy/main_test.cpp": TEST, "CMakeLists.txt": PROJECT}.items():
            (cls.root / name).parent.mkdir(parents=True, exist_ok=True)
            (cls.root / name).write_text(text)

    def run_mutate(self, *words):
        return subprocess.run([sys.executable, ROOT / "tools" / "mutate", "--root", self.root,
                               "--patience", "1", *words],
                              capture_output=True, text=True)

    def test_names_what_survives_and_leaves_the_source_as_it_is(self):
        run = self.run_mutate("src/toy/clamp.cpp", "--line", "4-13")
        self.assertEqual(run.returncode, 1, run.stderr)
        survivors = sorted(line.strip() for line in run.stdout.splitlines() if line.startswith("    + "))
        self.assertEqual(survivors, ["+ ;", "+ sum = sum - x;"], run.stdout)
        self.assertEqual((self.root / "src/toy/clamp.cpp").read_text(), SOURCE)

    def test_a_line_whose_changes_are_all_noticed(self):
        run = self.run_mutate("src/toy/clamp.cpp", "--line", "5")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("toy: 1 of 1 killed", run.stdout)

    def test_what_does_not_end_is_noticed(self):
        run = self.run_mutate("src/toy/clamp.cpp", "--line", "18")
        self.assertRegex(run.stdout, "toy: ([0-9]+) of \\1 killed")

    def test_what_was_judged_equivalent_is_not_tried(self):
        (self.root / "tools").mkdir()
        self.addCleanup(shutil.rmtree, self.root / "tools")
        (self.root / "tools" / "mutate-equivalent.txt").write_text(
            "# Why each makes no difference.\n\n"
            "src/toy/clamp.cpp\n- sum = sum + x;\n+ sum = sum - x;\nx is 0 wherever it is called.\n")
        run = self.run_mutate("src/toy/clamp.cpp", "--list", "--line", "12")
        self.assertNotIn("sum - x", run.stdout)
        self.assertIn("+ ;", run.stdout)

    def test_what_cannot_be_run(self):
        for words in ([], ["src/toy/none.cpp"], ["CMakeLists.txt"]):
            run = self.run_mutate(*words)
            self.assertEqual(run.returncode, 2)
            self.assertRegex(run.stderr, "tools/mutate: .")


if __name__ == "__main__":
    unittest.main()
