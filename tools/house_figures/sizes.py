"""Lengths of files and functions, comments, and tests of a source's name."""

import ast
import collections
import pathlib
import re

LONG_FILE, LONG_FUNCTION = 400, 40
HEAD_OF_FILES_OVER = 60
TYPE = re.compile(r"^(?:export )?(?:template.*|class|struct|union|enum|namespace|extern|interface|type)\b")


def long_files(tree, paths):
    return [f"{path}: {length} lines" for length, path in
            sorted(((len(tree.lines(path)), path) for path in paths), reverse=True) if length > LONG_FILE]


def long_functions(tree, paths):
    found = []
    for path in paths:
        spans = python_functions(tree.text(path)) if path.endswith(".py") else \
            laid_out_functions(tree.bare_code(path) if path.endswith(("pp", ".h", ".c")) else tree.code(path))
        found += [(end - start + 1, f"{path}:{start}: {end - start + 1} lines")
                  for start, end in spans if end - start + 1 > LONG_FUNCTION]
    return [text for _, text in sorted(found, reverse=True)]


def python_functions(text):
    return [(node.lineno, node.end_lineno) for node in ast.walk(ast.parse(text))
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]


def laid_out_functions(code):
    """First and last lines of the functions of a source as clang-format or Prettier lays it out: a brace closes a function in the
    column where its declaration begins, the first, or the third within a type."""
    spans, begin, inner, in_type = [], None, None, False
    for number, line in enumerate(code.splitlines(), 1):
        if line[:1] not in ("", " ", "}", "#", ")", "]") and not line.startswith("template"):
            begin, in_type, inner = number, bool(TYPE.match(line)) or " class " in line, None
        elif line.startswith("  ") and line[2:3] not in ("", " ", "}", ")", "]") and in_type:
            inner = number if not re.match(r"  (?:struct|class|enum|public|private|template)\b", line) else None
        if line.rstrip() in ("}", "};", "});") and begin is not None:
            if not in_type and is_function(code, begin):
                spans.append((begin, number))
            begin, in_type = None, False
        elif line.rstrip() in ("  }", "  };") and in_type and inner is not None:
            spans.append((inner, number))
            inner = None
    return spans


def is_function(code, number):
    head = code.splitlines()[number - 1:number + 6]
    text = " ".join(head).split("{")[0]
    return "(" in text and not re.search(r"=\s*$", text)


def lines_of(tree, paths):
    return sum(len(tree.lines(path)) for path in paths)


def comment_lines(tree, paths):
    """Lines of C++ sources that are nothing but comment."""
    count = 0
    for path in paths:
        inside = False
        for line in map(str.strip, tree.lines(path)):
            count += inside or line.startswith(("//", "/*"))
            inside = (inside or line.startswith("/*")) and "*/" not in line
    return count


def has_head(text):
    """Whether a source begins, before or after its includes, with a comment of two lines or more: before anything is declared but
    the namespace."""
    length = 0
    for line in map(str.strip, text.splitlines()):
        if line.startswith("//"):
            length += 1
            continue
        if length >= 2 and not line:
            return True  # the comment stands alone
        if line and not line.startswith(("#", "namespace", "using namespace")):
            return False
        if line.startswith("#include") and length >= 2:
            return True
        length = 0
    return False


def heads(tree, paths):
    """Sources long enough to hold an algorithm: all, and those that begin with what it is."""
    long = [path for path in paths if len(tree.lines(path)) > HEAD_OF_FILES_OVER]
    return long, [path for path in long if has_head(tree.text(path))]


def tests_of_their_name(files):
    """By module: its sources, and those that have a test of their name."""
    tests = collections.defaultdict(set)
    for path in files:
        parts = pathlib.PurePosixPath(path).parts
        if parts[0] == "tests" and path.endswith("_test.cpp") and len(parts) > 2:
            tests[parts[1]].add(parts[-1].removesuffix("_test.cpp"))
    sources = collections.defaultdict(list)
    for path in files:
        parts = pathlib.PurePosixPath(path).parts
        if parts[0] == "src" and path.endswith(".cpp") and len(parts) > 2:
            sources[parts[1]].append(path)
    return {module: (own, [path for path in own if pathlib.PurePosixPath(path).stem in tests[module]])
            for module, own in sorted(sources.items())}
