"""What the style test holds. Each check takes sources and returns findings; a finding is a line
`path:line: what is wrong`. A repository is given by its root."""

import functools
import pathlib
import re
import shutil
import subprocess
import unicodedata

CPP_COLUMNS = 100
TYPESCRIPT_COLUMNS = 120


def tracked(root, *patterns):
    """Files of the repository that match: those that git knows or, outside of git, all there are
    but for the build trees and what npm installed."""
    listed = subprocess.run(
        ["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard", "--",
         *patterns], capture_output=True, text=True)
    if listed.returncode == 0:
        paths = [root / name for name in listed.stdout.splitlines()]
    else:
        paths = [path for pattern in patterns for path in root.rglob(pattern)
                 if not {"build", "node_modules", "dist"} & set(path.relative_to(root).parts)]
    return sorted(path for path in paths if path.is_file())


def layout_of_cpp(root, paths):
    """Lines that clang-format would lay out otherwise."""
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if program is None:
        return ["clang-format is missing: tools/install-packages.sh test"]
    run = subprocess.run([program, "--dry-run", *paths], capture_output=True, text=True, cwd=root)
    found = re.findall(r"^(.+?:\d+):\d+: warning: code should be clang-formatted",
                       run.stderr, re.MULTILINE)
    findings = [f"{pathlib.Path(place).relative_to(root)}: clang-format lays it out otherwise"
                for place in dict.fromkeys(found)]
    if run.returncode != 0 and not findings:
        findings.append(f"clang-format failed: {run.stderr.strip()}")
    return findings


def layout_of_page(web):
    """Files of the page that Prettier would lay out otherwise; None where Prettier is not there,
    which the build of the page installs."""
    prettier = web / "node_modules" / "prettier" / "bin" / "prettier.cjs"
    node = shutil.which("node")
    if node is None or not prettier.is_file():
        return None
    run = subprocess.run([node, prettier, "--list-different", "."],
                         capture_output=True, text=True, cwd=web)
    findings = [f"web/{name}: Prettier lays it out otherwise" for name in run.stdout.splitlines()]
    if run.returncode != 0 and not findings:
        findings.append(f"Prettier failed: {run.stderr.strip()}")
    return findings


def width(line):
    """Columns of a line: characters, an accent over another character counting none."""
    return sum(not unicodedata.combining(character) for character in line)


def long_lines(root, paths, columns):
    """Lines wider than `columns`."""
    return [f"{path.relative_to(root)}:{number}: {width(line)} columns, at most {columns}"
            for path in paths
            for number, line in enumerate(path.read_text("utf-8").splitlines(), 1)
            if len(line) > columns and width(line) > columns]


COMMENT_OR_TEXT = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(?P<d>[^()\s]*)\(.*?\)(?P=d)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'"""
    r"|(?<=[0-9A-Fa-f])'(?=[0-9A-Fa-f])", re.DOTALL)
SMALL = re.compile(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)[eE]-\d+|(?<![\w.])0?\.000\d+")
NAMED = re.compile(r"\bconstexpr\b[^;]*\bk[A-Z]\w*\s*[={]", re.DOTALL)
DEFAULT = re.compile(r"^\s*(?:double|float|Angle)\s+[a-z]\w*\s*=")


@functools.lru_cache(maxsize=None)
def code_only(text):
    """A source with blanks for comments, strings and characters, so that lines stay."""
    return COMMENT_OR_TEXT.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def code_of(path):
    return code_only(path.read_text("utf-8"))


def small_numbers(path):
    """Numbers written as 1e-N or 0.000…: (line, the number, whether it has a name or is the
    default of an option that a comment explains)."""
    code, lines = code_of(path), path.read_text("utf-8").splitlines()
    for found in SMALL.finditer(code):
        line = code.count("\n", 0, found.start())
        statement = code.rfind(";", 0, found.start()) + 1
        named = NAMED.search(code, statement, found.start()) is not None
        explained = bool(DEFAULT.match(lines[line])) and (
            "//" in lines[line] or (line > 0 and lines[line - 1].lstrip().startswith("//")))
        yield line + 1, found.group(), named or explained


def bare_tolerances(root, paths):
    """Small numbers in the code that have no name."""
    return [f"{path.relative_to(root)}:{line}: {number} has no name"
            for path in paths for line, number, named in small_numbers(path) if not named]


def small_numbers_per_1000_lines(paths):
    lines = sum(len(path.read_text("utf-8").splitlines()) for path in paths)
    return 1000.0 * sum(1 for path in paths for _ in small_numbers(path)) / max(lines, 1)


def size_casts(root, paths):
    """Casts to size_t."""
    cast = re.compile(r"static_cast<\s*(?:std::)?size_t\s*>")
    return [f"{path.relative_to(root)}:{code.count(chr(10), 0, found.start()) + 1}: cast to size_t"
            for path in paths for code in [code_of(path)] for found in cast.finditer(code)]
