"""The files of the repository, by what they are, and their texts."""

import functools
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "style"))

from style_checks import code_only, tracked  # noqa: E402

CPP = {".cpp", ".hpp", ".c", ".h"}
CODE = CPP | {".ts", ".mjs", ".py", ".css"}
PROGRAM = ("src", "include", "apps", "integrations", "tools", "web")  # outside tests, bench, examples
HASH = re.compile(r"(?m)^[ \t]*#.*$|(?<=\s)# .*$")
SLASHES = re.compile(r"(?ms)^[ \t]*//[^\n]*$|/\*.*?\*/|(?<=[\s,;{}])//(?:/<)? [^\n]*$")


def blanked(found):
    return re.sub(r"[^\n]", " ", found.group())


@functools.lru_cache(maxsize=None)
def without_comments(text, suffix):
    """A source with blanks for its comments; strings stay."""
    return (HASH if suffix == ".py" else SLASHES).sub(blanked, text)


class Tree:
    """A checkout. Paths are relative to its root, with slashes."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.files = [path.relative_to(self.root).as_posix() for path in tracked(self.root, "*")]
        self._texts = {}

    def text(self, path):
        if path not in self._texts:
            self._texts[path] = (self.root / path).read_text("utf-8", errors="replace")
        return self._texts[path]

    def lines(self, path):
        return self.text(path).splitlines()

    def code(self, path):
        """Without comments; strings stay."""
        return without_comments(self.text(path), pathlib.PurePosixPath(path).suffix)

    def bare_code(self, path):
        """Without comments, strings and characters (C++)."""
        return code_only(self.text(path))

    def under(self, *folders, suffixes=CODE):
        return [path for path in self.files
                if path.startswith(tuple(folder + "/" for folder in folders))
                and pathlib.PurePosixPath(path).suffix in suffixes]

    def program(self, suffixes=CODE):
        """Sources outside tests."""
        return [path for path in self.under(*PROGRAM, suffixes=suffixes)
                if not path.startswith("web/test/")]

    def named(self, path):
        """As tests/style names files."""
        return self.root / path
