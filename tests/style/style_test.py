#!/usr/bin/python3
"""Layout, line lengths, tolerances without a name and casts, in all sources of the repository.

What is counted may not grow beyond tests/style/limits.json; who lowers a count lowers its limit.
"""

import json
import os
import pathlib
import tempfile
import unittest

import sentences
import style_checks as checks

ROOT = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR",
                                   pathlib.Path(__file__).resolve().parents[2]))
LIMITS = json.loads(pathlib.Path(__file__).with_name("limits.json").read_text("utf-8"))
CPP = checks.tracked(ROOT, "*.cpp", "*.hpp")
PAGE = checks.tracked(ROOT, "web/*.ts", "web/*.mjs")


def folder_of(path):
    """`src/sheet`, `apps/cli`; of a public header `include/planish/sheet`."""
    parts = path.relative_to(ROOT).parts
    return "/".join(parts[:3] if parts[0] == "include" else parts[:2])


PROGRAM = [path for path in CPP if folder_of(path).split("/")[0] in ("src", "include", "apps")]


class Repository(unittest.TestCase):
    def assert_clean(self, findings, remedy):
        self.assertFalse(findings, "\n" + "\n".join(findings) + f"\n{remedy}")

    def test_there_are_sources_to_look_at(self):
        self.assertGreater(len(CPP), 400)
        self.assertGreater(len(PROGRAM), 250)
        self.assertGreater(len(PAGE), 50)

    def test_cpp_is_laid_out_by_clang_format(self):
        self.assert_clean(checks.layout_of_cpp(ROOT, CPP), "To put it right: clang-format -i FILES")

    def test_the_page_is_laid_out_by_prettier(self):
        findings = checks.layout_of_page(ROOT / "web")
        if findings is None:
            self.skipTest("Prettier comes with the build of the page, which is not made here")
        self.assert_clean(findings, "To put it right: (cd web && npm run format)")

    def test_no_line_is_too_long(self):
        self.assert_clean(checks.long_lines(ROOT, CPP, checks.CPP_COLUMNS) +
                          checks.long_lines(ROOT, PAGE, checks.TYPESCRIPT_COLUMNS),
                          "The formatters break code; a long comment or string is broken by hand.")

    def test_sentences_name_places_as_data(self):
        self.assertGreater(len(sentences.tables(ROOT)), 0)
        self.assert_clean(sentences.faults(ROOT), "CONTRIBUTING.md#errors says how sentences are made.")

    def test_every_slot_of_a_sentence_is_filled(self):
        self.assert_clean(sentences.unfilled(ROOT), "Give the fact under the name that the sentence uses.")

    def test_every_code_has_its_sentences(self):
        told = sentences.refusals_by_code(ROOT)
        borrowed = {"time_limit"}  # of a batch, with the sentence of `out_of_time`
        self.assertEqual(sorted(sentences.codes(ROOT) - set(told) - borrowed), [], "No table has a sentence with this code.")

    def test_sentences_stand_in_tables(self):
        found = sum(sentences.plain(path) for path in PROGRAM)
        self.assertLessEqual(found, LIMITS["sentences_outside_tables"])

    def test_tolerances_have_names(self):
        limits = LIMITS["bare_tolerances"]
        for folder in sorted({folder_of(path) for path in PROGRAM}):
            with self.subTest(folder):
                found = checks.bare_tolerances(
                    ROOT, [path for path in PROGRAM if folder_of(path) == folder])
                self.assertLessEqual(
                    len(found), limits.get(folder, 0), "\n" + "\n".join(found) +
                    "\nGive it a name, `constexpr double kWhatItDecides = …;`, with the reason, or "
                    "take it from planish/base/tolerance.hpp.")

    def test_tolerances_are_few(self):
        self.assertLessEqual(checks.small_numbers_per_1000_lines(PROGRAM),
                             LIMITS["small_numbers_per_1000_lines"],
                             "Take numbers from planish/base/tolerance.hpp and the options.")

    def test_casts_to_size_t_are_few(self):
        found = checks.size_casts(ROOT, CPP)
        self.assertLessEqual(len(found), LIMITS["size_casts"], "\n" + "\n".join(found) +
                             "\nSubscript by ids (IdVector) or by int.")


class Checks(unittest.TestCase):
    """Each check finds what it is there for, and nothing else."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, text, name="a.cpp"):
        path = self.root / name
        path.write_text(text, "utf-8")
        return [path]

    def bare(self, text):
        return [finding.split(":", 1)[1]
                for finding in checks.bare_tolerances(self.root, self.write(text))]

    def test_clang_format(self):
        (self.root / ".clang-format").write_text((ROOT / ".clang-format").read_text("utf-8"))
        self.assertEqual(checks.layout_of_cpp(self.root, self.write("int a = 1;\n")), [])
        self.assertEqual(checks.layout_of_cpp(self.root, self.write("int a = 1;\nint  b=2;\n")),
                         ["a.cpp:2: clang-format lays it out otherwise"])

    def test_prettier(self):
        if not (ROOT / "web" / "node_modules" / "prettier").is_dir():
            self.skipTest("Prettier comes with the build of the page, which is not made here")
        for name in (".prettierrc.json", ".prettierignore"):
            (self.root / name).write_text((ROOT / "web" / name).read_text("utf-8"))
        (self.root / "node_modules").symlink_to(ROOT / "web" / "node_modules")
        self.write("const a = 'b';\n", "a.ts")
        self.assertEqual(checks.layout_of_page(self.root), [])
        self.write('const  a="b"\n', "a.ts")
        self.assertEqual(checks.layout_of_page(self.root),
                         ["web/a.ts: Prettier lays it out otherwise"])

    def test_columns_are_characters(self):
        paths = self.write("// " + "ä" * 96 + "b\u0304\n// " + "a" * 98 + "\n")
        self.assertEqual(checks.long_lines(self.root, paths, 100),
                         ["a.cpp:2: 101 columns, at most 100"])

    def test_bare_tolerances(self):
        self.assertEqual(self.bare("if (a < 1e-6) b();\n\nreturn x > 2.5E-04 * y;\n"),
                         ["1: 1e-6 has no name", "3: 2.5E-04 has no name"])
        self.assertEqual(self.bare("c = 0.0001;\n"), ["1: 0.0001 has no name"])
        self.assertEqual(self.bare("constexpr double tolerance = 1e-6;\n"),
                         ["1: 1e-6 has no name"])
        self.assertEqual(self.bare("constexpr double kA = 1e-6; double b = 1e-7;\n"),
                         ["1: 1e-7 has no name"])
        self.assertEqual(self.bare("const int n = 1'000; x = 1e-6;\n"), ["1: 1e-6 has no name"])

    def test_named_tolerances(self):
        self.assertEqual(self.bare("constexpr double kA = 1e-6;\n"
                                   "inline constexpr double kB =\n    3 * 1e-9,\n    kC = 1e-8;\n"
                                   "constexpr std::array kD = {1e-3};\n"), [])

    def test_defaults_of_options_need_a_comment(self):
        self.assertEqual(self.bare("struct O {\n  double a = 1e-6;  ///< mm\n  /// mm\n"
                                   "  double b = 1e-7;\n};\n"), [])
        self.assertEqual(self.bare("struct O {\n  double a = 1e-6;\n};\n"),
                         ["2: 1e-6 has no name"])

    def test_comments_and_strings_are_not_code(self):
        self.assertEqual(self.bare('// 1e-6\n/* 1e-7\n 1e-8 */ f("1e-9", R"(1e-5)", x1e-4);\n'), [])

    def test_numbers_per_1000_lines(self):
        paths = self.write("constexpr double kA = 1e-6;\n" + "\n" * 499)
        self.assertEqual(checks.small_numbers_per_1000_lines(paths), 2.0)

    def sentences_of(self, row, call):
        """What is found in a module with one sentence and one call."""
        for folder in ("include/planish/base", "src/job"):
            (self.root / folder).mkdir(parents=True, exist_ok=True)
        self.write("inline constexpr ErrorCode bad{}; inline constexpr ErrorCode worse{};", "include/planish/base/code.hpp")
        self.write(f"constexpr Refusal wide{{code::bad, {row}}};\n", "src/job/refusals.hpp")
        self.write(call, "src/job/a.cpp")
        return [finding.split(": ", 1)[1] for finding in sentences.faults(self.root) + sentences.unfilled(self.root)]

    def test_sentences_name_places(self):
        call = 'return fail(refuse::wide, {{"face", place::face(3)}, {"n", 2}});'
        self.assertEqual(self.sentences_of('"{@face} is {n}."', call), [])
        self.assertEqual(sentences.refusals_by_code(self.root), {"bad": ["src/job/refusals.hpp: wide"]})
        self.assertEqual(sentences.codes(self.root), {"bad", "worse"})
        self.assertIn('"face {n}" is no place', self.sentences_of('"In face {n}."', call)[0])
        self.assertEqual(self.sentences_of('"{@face} is {n} by {m}."', call), ["wide lacks m"])
        self.assertEqual(self.sentences_of('"{@n} is {@face}."', call), ["wide has no place as n: 2"])
        self.assertEqual(self.sentences_of('"{@field} is {n}."', 'item.mistake(refuse::wide, {{"n", 2}});'), [])
        self.assertEqual(self.sentences_of('"{@field} is {n}."', 'x = fail_at(refuse::wide, "/a", {});'), ["wide lacks n"])
        self.assertEqual(self.sentences_of('"{n}."', "return fail(a > f(1) ? refuse::wide : refuse::wide);"), ["wide lacks n"] * 2)
        self.assertEqual(self.sentences_of('"{n}."', "return fail(refuse::wide, facts_of(x));"), [], "made elsewhere")

    def test_casts(self):
        paths = self.write("a[static_cast<size_t>(i)];\n// static_cast<size_t>(i)\n"
                           "a[static_cast<std::size_t>(i)];\n")
        self.assertEqual(checks.size_casts(self.root, paths),
                         ["a.cpp:1: cast to size_t", "a.cpp:3: cast to size_t"])


if __name__ == "__main__":
    unittest.main()
