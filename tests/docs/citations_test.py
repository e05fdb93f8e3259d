#!/usr/bin/python3
"""Every citation in the sources and every link in the documentation has a target.

A citation is the name of a page with an anchor (`math.md#border-trihedron`), or an equation of a source
of docs/bibliography.md: its key and number in brackets (`[thesis 94]`)."""

import os
import pathlib
import re
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
FOLDERS = ["src", "include", "apps", "tests", "bench", "tools", "web", "docs", "examples", "cmake",
           "integrations", "packaging"]
SUFFIXES = {".cpp", ".hpp", ".in", ".py", ".ts", ".mjs", ".css", ".cmake", ".txt", ".sh", ".md"}
CODE = {".cpp", ".hpp", ".in", ".ts", ".mjs"}
BUILT = {"node_modules", "dist", "build", "__pycache__"}

PAGE = re.compile(r"(?<![\w/.-])((?:[\w.-]+/)*[\w.-]*\w\.md)(?:#([\w-]+))?")
EQUATION = re.compile(r"\[([a-z]+) (\d+(?:(?:–|, | and )\d+)*)")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)|<img[^>]*\ssrc=\"([^\"]+)\"")
# An equation number without its source: "[99, 114]" after a blank. Intervals such as [0, 1] begin
# with 0 or 1 and are no citations.
BARE_EQUATION = re.compile(r"(?<=[\s(])\[((?:[2-9]|\d{2,3})(?:(?:–|, ?)(?:[2-9]|\d{2,3}))*)\]")
# Pages that are not in the repository, and paths that lead out of it. This file is checked too, so it
# spells them, and the faults that it plants below, in two parts.
OUTSIDE = re.compile(r"\bMATH[\s/*#]+\d|\bSHOP" r"FLOOR\b|(?<![\"_])\bFORMATS\b|shared/" r"design|"
                     r"\b(?:MATH|FORMATS|SHOP" r"FLOOR|HOUSE|STYLE)\.md\b")


def files(root):
    for path in sorted(root.glob("*.md")) + [root / "CMakeLists.txt"]:
        if path.exists():
            yield path
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            inside = path.relative_to(root)
            if path.suffix in SUFFIXES and path.is_file() and not BUILT & set(inside.parts):
                yield path


def without_fences(text):
    """Fenced code is blanked, so that line numbers stay."""
    return re.sub(r"^```.*?^```", lambda m: "\n" * m.group().count("\n"), text, flags=re.M | re.S)


def slug(heading):
    """The anchor that a Markdown reader gives to a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"<[^>]*>", "", heading)).replace("`", "")
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


def anchors_of(page):
    text = without_fences(page.read_text(encoding="utf-8"))
    anchors = re.findall(r"<a id=\"([^\"]+)\">", text)
    taken = {}
    for heading in re.findall(r"^#+ (.*)$", text, flags=re.M):
        name = slug(heading)
        anchors.append(f"{name}-{taken[name]}" if name in taken else name)
        taken[name] = taken.get(name, 0) + 1
    return anchors


def repeated_anchors(page):
    explicit = re.findall(r"<a id=\"([^\"]+)\">", page.read_text(encoding="utf-8"))
    return sorted({name for name in explicit if explicit.count(name) > 1})


def sources_of(bibliography):
    """By key the numbers of the equations that a source has."""
    sources = {}
    text = bibliography.read_text(encoding="utf-8") if bibliography.exists() else ""
    for entry in re.split(r"^## ", text, flags=re.M)[1:]:
        key = re.match(r"`([a-z]+)(?: (\d+))?`", entry)
        if not key:
            continue
        span = re.search(r"[Ee]quations (\d+)–(\d+)", entry)
        numbers = range(int(span[1]), int(span[2]) + 1) if span else []
        sources.setdefault(key[1], set()).update([int(key[2])] if key[2] else numbers)
    return sources


class Checker:
    def __init__(self, root):
        self.root, self.problems, self.anchors = root, [], {}
        self.sources = sources_of(root / "docs" / "bibliography.md")

    def run(self):
        for path in files(self.root):
            text = path.read_text(encoding="utf-8")
            self.check_left_over(path, text)
            self.check_citations(path, text)
            if path.suffix == ".md":
                self.check_links(path, without_fences(text))
                for name in repeated_anchors(path):
                    self.add(path, text, text.index(f'<a id="{name}">'), f"anchor {name} is given twice")
        return self.problems

    def add(self, path, text, at, what):
        line = text.count("\n", 0, at) + 1
        self.problems.append(f"{path.relative_to(self.root)}:{line}: {what}")

    def check_left_over(self, path, text):
        in_python = path.suffix == ".py"  # where FORMATS may be a name of the program
        for found in OUTSIDE.finditer(text):
            if not (in_python and found.group() == "FORMATS"):
                self.add(path, text, found.start(), f"cites {found.group()!r}, which is not in the repository")
        if path.suffix not in CODE:
            return
        for found in BARE_EQUATION.finditer(text):
            line = text[text.rfind("\n", 0, found.start()) + 1:found.start()]
            if "//" in line or line.lstrip().startswith("*"):
                self.add(path, text, found.start(), f"{found.group()} does not say of which source")

    def check_citations(self, path, text):
        for found in PAGE.finditer(text):
            if path.suffix != ".md" or found.group(2):
                self.check_target(path, text, found.start(), found.group(1), found.group(2))
        for found in EQUATION.finditer(text):
            key, numbers = found.group(1), [int(n) for n in re.findall(r"\d+", found.group(2))]
            if key not in self.sources:
                if key in ("thesis", "slits", "transitions", "part"):
                    self.add(path, text, found.start(), f"[{key} …] is no source of docs/bibliography.md")
            elif not set(numbers) <= self.sources[key]:
                self.add(path, text, found.start(), f"{found.group()}] is no equation of that source")

    def check_links(self, path, text):
        for found in LINK.finditer(text):
            link = found.group(1) or found.group(2)
            if re.match(r"[a-z]+:", link):
                continue
            target, _, anchor = link.partition("#")
            where = (path.parent / target).resolve() if target else path
            if not where.exists():
                self.add(path, text, found.start(), f"{link} does not exist")
            elif anchor and anchor not in self.anchors_in(where):
                self.add(path, text, found.start(), f"{link}: {where.name} has no such anchor")

    def check_target(self, path, text, at, name, anchor):
        places = [path.parent / name, self.root / name, self.root / "docs" / name]
        page = next((place for place in places if place.exists()), None)
        if page is None:
            self.add(path, text, at, f"there is no page {name}")
        elif anchor and anchor not in self.anchors_in(page):
            self.add(path, text, at, f"{name} has no anchor {anchor}")

    def anchors_in(self, page):
        if page not in self.anchors:
            self.anchors[page] = set(anchors_of(page)) if page.suffix == ".md" else set()
        return self.anchors[page]


class Citations(unittest.TestCase):
    def test_every_citation_and_link_of_the_repository_resolves(self):
        problems = Checker(SOURCE).run()
        self.assertEqual(problems, [], "\n" + "\n".join(problems))

    def test_the_index_leads_to_every_page(self):
        index = (SOURCE / "docs" / "README.md").read_text(encoding="utf-8")
        linked = {link.partition("#")[0] for pair in LINK.findall(index) for link in pair}
        pages = {path.name for path in (SOURCE / "docs").glob("*.md")} - {"README.md"}
        self.assertEqual(pages - linked, set())

    def test_the_repository_cites_its_mathematics(self):
        """So that the test above cannot pass because nothing was found."""
        cited = sum(len(re.findall(r"\bmath\.md#[\w-]+", path.read_text(encoding="utf-8")))
                    for path in files(SOURCE) if path.suffix in CODE)
        self.assertGreater(cited, 50)


MD = ".md"  # the pages of the small trees below are not cited by this file


class Faults(unittest.TestCase):
    """Faults planted in a small tree are found where they are."""

    def problems(self, **planted):
        pages = {f"docs/math{MD}": '<a id="neutral-surface"></a>\n## Neutral surface\n\n## How fast?\n',
                 f"docs/bibliography{MD}": "## `thesis`: a thesis\n\nEquations 1–114.\n\n## `part 4`: an article\n"}
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**pages, **planted.get("files", {})}.items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return Checker(pathlib.Path(folder)).run()

    def check(self, name, text, *expected):
        found = self.problems(files={name: text})
        self.assertEqual(len(found), len(expected), found)
        for problem, (place, what) in zip(found, expected):
            self.assertTrue(problem.startswith(place + ":"), problem)
            self.assertIn(what, problem)

    def test_a_tree_without_faults_has_none(self):
        self.check("src/a.cpp", f"/// Offset first (math{MD}#neutral-surface, docs/math{MD}#how-fast), [thesis 94],\n"
                                "/// [thesis 99, 114] and [part 4]; u in [0, 1], in [-2, 2], by face[3].\n")
        self.check(f"docs/a{MD}", f"[the surface](math{MD}#neutral-surface), ![](math{MD}), `math{MD}#how-fast`\n"
                                f"```\n[no link](nowhere{MD})\n```\n")

    def test_an_anchor_that_is_missing(self):
        self.check("src/a.cpp", f"\n/// See math{MD}#neutral-axis.\n", ("src/a.cpp:2", "no anchor neutral-axis"))
        self.check(f"docs/a{MD}", f"[x](math{MD}#neutral-axis)\n", (f"docs/a{MD}:1", "no anchor"), (f"docs/a{MD}:1", "no such anchor"))

    def test_a_page_or_picture_that_is_missing(self):
        self.check("include/a.hpp", f"// docs/maths{MD}\n", ("include/a.hpp:1", "no page"))
        self.check(f"docs/a{MD}", "text\n![](math/cone.svg)\n", (f"docs/a{MD}:2", "does not exist"))
        self.check(f"docs/b{MD}", "[x](../src/none.cpp)\n", (f"docs/b{MD}:1", "does not exist"))

    def test_citations_of_pages_outside(self):
        self.check("src/a.cpp", "/// (MATH " + "4.2)\n", ("src/a.cpp:1", "not in the repository"))
        self.check("src/a.cpp", "/// (MATH\n" + "/// 4.2)\n", ("src/a.cpp:1", "not in the repository"))
        self.check("tests/a_test.py", "# rules of SHOP" + "FLOOR\n", ("tests/a_test.py:1", "not in the repository"))
        self.check("README.md", "see FOR" + "MATS\n", ("README.md:1", "not in the repository"))
        self.check("src/a.hpp", "// ../shared/" + "design\n", ("src/a.hpp:1", "not in the repository"))

    def test_equations_without_source_or_beyond_it(self):
        self.check("src/a.cpp", "// Ψ is linear [94].\n", ("src/a.cpp:1", "of which source"))
        self.check("src/a.cpp", "// Ψ is linear [" "thesis 940].\n", ("src/a.cpp:1", "no equation"))
        self.check("src/a.cpp", "// Smooth [slits 3].\n", ("src/a.cpp:1", "no source"))

    def test_an_anchor_given_twice(self):
        self.check(f"docs/a{MD}", '<a id="x"></a>\n\n<a id="x"></a>\n', (f"docs/a{MD}:1", "twice"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
