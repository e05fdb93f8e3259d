"""What is counted, one function for each group of figures."""

import dataclasses
import json
import pathlib
import re

from . import doubles, sentences, sizes
from .tree import CPP, CODE

MAKERS = ("transition", "slit")  # of makers with files of their own; a file that lists makers names both
INDEX = str(pathlib.PurePosixPath("docs/README").with_suffix(".md"))
ARTIFACTS = ("flat.step", "mould.stl", "obj", "pdf")


@dataclasses.dataclass
class Figure:
    key: str  # of its limit
    name: str
    value: float | None  # None: not measured
    unit: str = ""
    places: list = dataclasses.field(default_factory=list)


def all_figures(tree):
    groups = (front_ends, mutants, names, comments, touched, rooms, doubled, lengths, totals, pages, build)
    return [figure for group in groups for figure in group(tree)]


def counted(key, name, places):
    return Figure(key, name, len(places), "", [str(place) for place in places])


def share(part, whole):
    return round(100.0 * part / whole, 1) if whole else 100.0


def record(tree, path):
    """A file that another program of the project writes; None where it is not there."""
    return json.loads(tree.text(path)) if path in tree.files else None


def front_ends(tree):
    yield counted("sentence_readers", "readers of English sentences", sentences.readers(tree))


def mutants(tree):
    """From what tools/mutate wrote."""
    modules = record(tree, "tests/mutation.json") or {}
    shares = {module: share(one["killed"], one["compiled"]) for module, one in modules.items()}
    said = [f"{module}: {one['killed']} of {one['compiled']} (seed {one['seed']}, {one['date']})"
            for module, one in sorted(modules.items())]
    yield Figure("mutants_killed_least", "mutants killed, worst module", min(shares.values(), default=None), "%", said)


def names(tree):
    modules = sizes.tests_of_their_name(tree.files)
    shares = {module: share(len(tested), len(own)) for module, (own, tested) in modules.items() if module in
              modules_of(tree)}
    said = [f"{module}: {len(tested)} of {len(own)}, {shares[module]} %" for module, (own, tested) in modules.items() if module in
            shares]
    own, tested = ([path for one in modules.values() for path in one[which]] for which in (0, 1))
    yield Figure("tested_by_name", "sources with a test of their name", share(len(tested), len(own)), "%",
                 sorted(set(own) - set(tested)))
    yield Figure("tested_by_name_least", "the same, worst module", min(shares.values(), default=None), "%", said)


def comments(tree):
    sources = tree.under("src", suffixes=CPP)
    yield Figure("comment_lines", "comment lines in src", share(sizes.comment_lines(tree, sources),
                                                                sizes.lines_of(tree, sources)), "%")
    long, with_head = sizes.heads(tree, [path for path in sources if path.endswith(".cpp")])
    yield Figure("algorithm_heads", "long sources that begin with their idea", share(len(with_head), len(long)), "%",
                 sorted(set(long) - set(with_head)))


def touched(tree):
    """Existing files that an addition changes: those that list what there is by name."""
    elsewhere = [path for path in tree.files if not path.endswith(".md") and not path.startswith(
        ("tests/", "docs/", "bench/", "examples/", "web/test/", "tools/house",
        "tools/mutate-equivalent.txt"))]
    listing = [path for path in elsewhere if not any(maker in path for maker in MAKERS) and
               all(re.search(rf"(?<![\w-])(?:{maker}(?:_\w+|[A-Z]\w*)?|planish[./]{maker}s?)(?![\w-])", text_of(tree, path))
                   for maker in MAKERS)]
    yield counted("files_of_a_maker", "existing files that a new maker touches", listing)
    written = "|".join(map(re.escape, ARTIFACTS))
    listing = [path for path in elsewhere
               if len(set(re.findall(rf"""["'`]({written})["'`]""", text_of(tree, path)))) > 1]
    yield counted("files_of_an_artifact", "existing files that a new artifact touches", listing)


def text_of(tree, path):
    suffix = pathlib.PurePosixPath(path).suffix
    if suffix in CODE:
        return tree.code(path)
    return tree.text(path) if suffix in (".txt", ".cmake", ".xml", ".desktop", ".in", ".sh") else ""


def rooms(tree):
    everything = tree.under("src", "include/planish", suffixes=CPP)
    job = [path for path in everything if path.startswith(("src/job/", "include/planish/job/"))]
    yield Figure("job_files", "files of job", len(job))
    yield Figure("job_lines", "lines of job", sizes.lines_of(tree, job))
    yield Figure("job_share", "lines of job, of all modules'",
                 share(sizes.lines_of(tree, job), sizes.lines_of(tree, everything)), "%")
    yield Figure("modules", "modules", len(modules_of(tree)), "", modules_of(tree))


def modules_of(tree):
    """Folders of src with a public header; the C interface has its own place."""
    return sorted({path.split("/")[1] for path in tree.under("src", suffixes=CPP)} &
                  {path.split("/")[2] for path in tree.under("include/planish", suffixes=CPP)})


def doubled(tree):
    equal, alike = doubles.doubles({path: tree.code(path) for path in tree.program()})
    yield counted("doubled_places", "pairs of places that share six lines", equal)
    yield counted("doubled_shapes", "pairs of the same shape in two files", alike)


def lengths(tree):
    program = tree.program(CODE - {".css"})
    cpp, page = [tree.named(path) for path in tree.files if path.endswith((".cpp", ".hpp"))], \
        [tree.named(path) for path in tree.under("web", suffixes={".ts", ".mjs"})]
    from style_checks import CPP_COLUMNS, TYPESCRIPT_COLUMNS, bare_tolerances, long_lines
    yield counted("long_files", "files over 400 lines", sizes.long_files(tree, program))
    yield counted("long_styles", "style sheets over 400 lines",
                  sizes.long_files(tree, tree.under("web/src", suffixes={".css"})))
    yield counted("long_functions", "functions over 40 lines", sizes.long_functions(tree, program))
    yield counted("long_lines", "lines over 100 columns, of the page over 120",
                  long_lines(tree.root, cpp, CPP_COLUMNS) + long_lines(tree.root, page, TYPESCRIPT_COLUMNS))
    yield counted("bare_tolerances", "tolerances without a name", bare_tolerances(
        tree.root, [tree.named(path) for path in tree.under("src", "include", "apps", suffixes={".cpp", ".hpp"})]))


def totals(tree):
    groups = {"lines_of_sources": ("lines of sources and headers", tree.under("src", "include", "apps", suffixes=CPP)),
              "lines_of_tests": ("lines of tests", tree.under("tests", "web/test")),
              "lines_of_page": ("lines of the page", tree.under("web/src"))}
    for key, (name, paths) in groups.items():
        yield Figure(key, name, sizes.lines_of(tree, paths))


def pages(tree):
    documents = [path for path in tree.files if re.fullmatch(r"docs/[\w-]+\.md", path)]
    yield Figure("words_of_pages", "words of docs/*.md", sum(len(tree.text(path).split()) for path in documents))
    index = tree.text(INDEX) if INDEX in tree.files else ""
    linked = {target.split("#")[0] for target in re.findall(r"\]\(([^)\s]+)\)", index)}
    yield counted("pages_not_listed", "pages that the index of docs leaves out",
                  [path for path in documents if path != INDEX and path.removeprefix("docs/") not in linked])


def build(tree):
    """From a record of measurements, on two idle cores."""
    measured = record(tree, "bench/build.json") or {}
    for key, name, unit in (("build_user_seconds", "user time of the program's build", "s"),
                            ("quickstart_minutes", "quickstart from nothing", "min"),
                            ("test_minutes", "test after it", "min")):
        yield Figure(key, name, measured.get(key), unit)
