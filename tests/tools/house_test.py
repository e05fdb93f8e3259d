#!/usr/bin/python3
"""tools/house: no figure of the sources is worse than its limit, and each figure counts what it is there for."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))

from house_figures import doubles, figures, sentences, sizes  # noqa: E402
from house_figures.tree import Tree  # noqa: E402


class Repository(unittest.TestCase):
    def test_no_figure_is_worse_than_its_limit(self):
        run = subprocess.run([sys.executable, ROOT / "tools" / "house"], capture_output=True, text=True,
                             env={**os.environ, "PLANISH_SOURCE_DIR": str(ROOT)})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        for figure in ("readers of English sentences", "pairs of places that share six lines", "words of docs"):
            self.assertIn(figure, run.stdout)


class Limits(unittest.TestCase):
    """The program with the figures of a folder that holds one source."""

    def run_house(self, limits, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "src" / "io").mkdir(parents=True)
            (pathlib.Path(folder) / "src" / "io" / "dxf.cpp").write_text("int a;\n" * 401, "utf-8")
            path = pathlib.Path(folder) / "limits.json"
            rules = json.loads((ROOT / "tools" / "house.json").read_text("utf-8"))
            for key, rule in rules.items():
                rule.pop("limit", None)
                rule.update(limits.get(key, {}))
            path.write_text(json.dumps(rules), "utf-8")
            return subprocess.run([sys.executable, ROOT / "tools" / "house", "--limits", path, *arguments],
                                  capture_output=True, text=True, env={**os.environ, "PLANISH_SOURCE_DIR": folder})

    def test_a_figure_at_its_limit_passes(self):
        run = self.run_house({"lines_of_sources": {"limit": 401}, "comment_lines": {"limit": 0.0}})
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertNotIn("WORSE", run.stdout)

    def test_a_figure_beyond_its_limit_is_said_and_fails(self):
        run = self.run_house({"lines_of_sources": {"limit": 400}, "comment_lines": {"limit": 0.1}})
        self.assertEqual(run.returncode, 1)
        self.assertIn("tools/house lines_of_sources lists the places", run.stderr)
        self.assertIn("tools/house comment_lines lists the places", run.stderr)
        self.assertEqual(run.stdout.count("WORSE"), 2)

    def test_a_long_file_may_have_a_reason(self):
        self.assertEqual(self.run_house({"long_files": {"limit": 0}}).returncode, 1)
        self.assertEqual(self.run_house({"long_files": {"limit": 0, "reasons": {"src/io/dxf.cpp": "a table"}}}).returncode, 0)

    def test_places_and_json(self):
        self.assertIn("src/io/dxf.cpp: 401 lines", self.run_house({}, "long_files").stdout)
        limits = json.loads((ROOT / "tools" / "house.json").read_text("utf-8"))
        self.assertEqual(sorted(json.loads(self.run_house({}, "--json").stdout)), sorted(limits))


class Sentences(unittest.TestCase):
    def lines(self, text, path="a.ts", others=()):
        return [site.line for site in sentences.readers_in({path: text, **dict(others)}) if site.path == path]

    def test_typescript_searches_in_a_message(self):
        for search in ("/face (\\d+)/.exec(error.message)", "/edge/.test(`${p.message}`)", "p.message.includes('edge')",
                       "problem!.message?.startsWith('face')", "p.message.replace(/x/, '')", "p.message.split(' ')[1]",
                       "String(a).length + p.message.indexOf('x')", "[...message.matchAll(known)]",
                       "(p.message ?? '').match(/a/)", "message\n    .toLowerCase()\n    .includes('a')"):
            with self.subTest(search):
                self.assertTrue(self.lines(f"function f(p, message, error, problem) {{\n  return {search};\n}}\n"))

    def test_typescript_follows_what_holds_a_message(self):
        self.assertEqual(self.lines("function f(p) {\n  const text = `${p.message} at ${p.where}`,\n"
                                    "    a = 1;\n  return text.match(/a/);\n}\n"), [4])
        self.assertEqual(self.lines("const f = (a: number, said: string) => {\n  return said.includes('edge');\n};\n"
                                    "function g(p) {\n  return f(1, p.message);\n}\n"), [2])
        self.assertEqual(self.lines("export function named(text: string) {\n  return text.match(/a/);\n}\n", "a.ts",
                                    {"b.ts": "const g = (p) => named(p.message);\n"}.items()), [2])

    def test_typescript_that_reads_no_message(self):
        for code in ("p.code.startsWith('bad_')", "html`<p>${p.message}</p>`", "new Error(p.message)",
                     "names.includes(name) ? p.message : ''", "p.messages.includes(1)", "p.message.length",
                     "f({ code: p.code, message: p.message })", "[p.message].join(' ')", "/x/.test(p.code) && say(p.message)",
                     "'message'.includes(x)", "say(p.message) // p.message.includes('x')"):
            with self.subTest(code):
                self.assertEqual(self.lines(f"function f(p, names, name, x, say) {{\n  return {code};\n}}\n"), [])

    def test_of_places_pointers_may_be_read(self):
        self.assertEqual(self.lines("const f = (p) => /\\/plates\\/(\\d+)/.exec(p.where ?? '');\n"), [])
        self.assertEqual(self.lines("const pointer = /^\\/bends/;\nconst f = (p) => pointer.exec(p.where);\n"), [])
        self.assertEqual(self.lines("const f = (p) => p.where.startsWith('/plates');\n"), [])
        self.assertEqual(self.lines("const f = (p) => /edge (\\d+)/.exec(p.where ?? '');\n"), [1])
        self.assertEqual(self.lines("const f = (p) => p.where.startsWith('face');\n"), [1])

    def test_python(self):
        for search in ("re.findall('face', error.message)", "'edge' in error.message", "error.message.startswith('x')",
                       "PATTERN.search(f'{error.where} {error.message}')", "row['message'].split()",
                       "row.get('message', '').find('x')", "(error.message or str(error)).partition(':')",
                       "'edge' in error.where", "KINDS[kind].findall(error.message)"):
            with self.subTest(search):
                self.assertEqual(self.lines(f"def f(error, row, kind):\n    return {search}\n", "a.py"), [2])
        self.assertEqual(self.lines("def f(error):\n    text = error.message\n    return text.split()\n", "a.py"), [3])
        self.assertEqual(self.lines("def f(said):\n    message, _, code = said.rpartition(' [')\n", "a.py"), [2])
        self.assertEqual(self.lines("def named(text, kind):\n    return re.findall(kind, text)\n", "a.py",
                                    {"b.py": "def g(e):\n    return named(e.message, 'Face')\n"}.items()), [2])

    def test_python_that_reads_no_message(self):
        for code in ("error.code.startswith('bad')", "print(error.message)", "error.message + 'x'", "name in names",
                     "[error.message].index(3)", "error.where.startswith('/plates')", "re.findall('a', name)",
                     "say(error.message).code.split()", "dict(message=error.message)"):
            with self.subTest(code):
                self.assertEqual(self.lines(f"def f(error, name, names):\n    return {code}\n", "a.py"), [])

    def test_cpp(self):
        for search in ('error.message.find("face")', 'std::regex_search(error.message, m, kEdge)',
                       'found->message.starts_with("x")', 'error.message.substr(3)', 'error().message.rfind(":")'):
            with self.subTest(search):
                self.assertEqual(self.lines(f"int f(const Error& error) {{\n  return {search};\n}}\n", "a.cpp"), [2])
        self.assertEqual(self.lines("int f(const Error& e) {\n  std::string text = e.message;\n  return text.find(1);\n}\n",
                                    "a.cpp"), [3])

    def test_cpp_that_reads_no_message(self):
        for code in ("say(error.message)", "error.code.message().size()", 'error.message + name.substr(1)',
                     'name.find("message")', 'Error{code, "face", error.message}'):
            with self.subTest(code):
                self.assertEqual(self.lines(f"int f(const Error& error) {{\n  return {code};\n}}\n", "a.cpp"), [])


LINES = ["const auto piece = measured(border[3], \"edge\", kWidest) + 0.5;",
         "if (width < least && ok(one)) return narrower(width);",
         "for (const Vec2& p : sampled(loop, kChord)) points.push_back(p);",
         "std::vector<int> order(points.size());",
         "while (!queue.empty() && least > queue.top().bound) queue.pop();",
         "return {std::move(order), least / extent, 12};"]
OTHER_NAMES = [line.replace("piece", "part").replace("width", "height").replace("edge", "line").replace("0.5", "25")
               for line in LINES]


class Doubles(unittest.TestCase):
    def found(self, **codes):
        equal, alike = doubles.doubles({name + ".cpp": "\n".join(lines) + "\n" for name, lines in codes.items()})
        return [str(one) for one in equal], [str(one) for one in alike]

    def test_six_equal_lines_in_two_files_or_one(self):
        self.assertEqual(self.found(a=["int a;", *LINES], b=[*LINES, "int b;"]), (["a.cpp:2-7 ~ b.cpp:1-6"], []))
        self.assertEqual(self.found(a=[*LINES, "int c;", *LINES]), (["a.cpp:1-6 ~ a.cpp:8-13"], []))

    def test_five_lines_are_none(self):
        self.assertEqual(self.found(a=LINES[:5], b=LINES[:5]), ([], []))

    def test_blanks_comments_and_braces_between_do_not_hide_it(self):
        spread = [LINES[0], "", "{", *["    " + line for line in LINES[1:4]], "}", "#include <a.hpp>", *LINES[4:]]
        self.assertEqual(self.found(a=LINES, b=spread)[0], ["a.cpp:1-6 ~ b.cpp:1-10"])

    def test_a_longer_run_is_one_pair(self):
        longer = [*LINES, "last(one);", "and_another(two);"]
        self.assertEqual(self.found(a=longer, b=longer)[0], ["a.cpp:1-8 ~ b.cpp:1-8"])

    def test_the_same_shape(self):
        self.assertEqual(self.found(a=LINES, b=OTHER_NAMES), ([], ["a.cpp:1-6 ~ b.cpp:1-6"]))

    def test_rows_and_headers_are_none(self):
        rows = [f'{{"name_{i}", &Rules::name_{i}, "what it is {i}", {i}}},' for i in range(20)]
        self.assertEqual(self.found(a=rows[:10], b=rows[10:]), ([], []))
        head = [f"#include <planish/sheet/header_{i}.hpp>" for i in range(8)]
        self.assertEqual(self.found(a=head, b=head), ([], []))


class Sizes(unittest.TestCase):
    def test_functions(self):
        body = ["  f();"] * 3
        text = "\n".join(["namespace a {", "int f(int a,", "      int b) {", *body, "}", "struct S {", "  int g() {",
                          "    if (a) {", "    }", "  }", "};", "const std::array kA = {", "  1,", "};", "}  // namespace a"])
        self.assertEqual(sizes.laid_out_functions(text), [(2, 7), (9, 12)])
        self.assertEqual(sizes.laid_out_functions("export function f() {\n  g();\n}\nconst h = (a) => {\n  g();\n};\n"
                                                  "const table = {\n  a: f(1),\n};\n"), [(1, 3), (4, 6)])
        self.assertEqual(sizes.python_functions("def f():\n    a = 1\n    return a\n"), [(1, 3)])

    def test_heads(self):
        head = "// Best first: the bound only grows,\n// so the first leaf is the least.\n"
        for text in (head + "#include <a>\n\nint a;\n", "#include <a>\n\n" + head + "\nnamespace a {\nint a;\n",
                     "#include <a>\n\nnamespace a {\n\n" + head + "\nint a;\n"):
            self.assertTrue(sizes.has_head(text), text)
        for text in ("#include <a>\nint a;\n" + head, "// One line.\n#include <a>\n\nint a;\n",
                     "#include <a>\nnamespace a {\n/// Of a declaration,\n/// two lines.\nint a;\n"):
            self.assertFalse(sizes.has_head(text), text)

    def test_tests_of_their_name(self):
        found = sizes.tests_of_their_name(["src/io/dxf.cpp", "src/io/svg.cpp", "src/io/svg.hpp", "tests/io/dxf_test.cpp",
                                           "src/job/a/b.cpp", "tests/job/c/b_test.cpp", "tests/io/b_test.cpp"])
        self.assertEqual(found, {"io": (["src/io/dxf.cpp", "src/io/svg.cpp"], ["src/io/dxf.cpp"]),
                                 "job": (["src/job/a/b.cpp"], ["src/job/a/b.cpp"])})


class Trees(unittest.TestCase):
    """Figures of a small checkout that is no git repository."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, "utf-8")

    def figure(self, group, key):
        return {one.key: one for one in group(Tree(self.root))}[key]

    def test_a_file_that_lists_makers(self):
        self.write("src/job/makers.cpp", "rows = {slit_maker(), transition_maker()};\n")
        self.write("src/job/other.cpp", "// the slit and the transition\nint slit;\n")
        self.write("src/job/slit_transition.cpp", "int slit, transition;\n")
        self.assertEqual(self.figure(figures.touched, "files_of_a_maker").places, ["src/job/makers.cpp"])

    def test_pages_that_the_index_leaves_out(self):
        page = "docs/{}.md".format
        self.write(page("README"), "[one]({}#there)\n".format(page("one").removeprefix("docs/")))
        self.write(page("one"), "Three short words.\n")
        self.write(page("two"), "Two words\n")
        self.assertEqual(self.figure(figures.pages, "pages_not_listed").places, [page("two")])
        self.assertEqual(self.figure(figures.pages, "words_of_pages").value, 6)

    def test_mutants_come_from_the_record(self):
        self.assertIsNone(self.figure(figures.mutants, "mutants_killed_least").value)
        self.write("tests/mutation.json", json.dumps(
            {"io": {"killed": 12, "compiled": 24, "seed": 1, "date": "2026-11-25"},
             "slit": {"killed": 24, "compiled": 24, "seed": 1, "date": "2026-11-25"}}))
        self.assertEqual(self.figure(figures.mutants, "mutants_killed_least").value, 50.0)


if __name__ == "__main__":
    unittest.main()
