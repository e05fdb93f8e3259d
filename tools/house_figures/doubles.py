"""Places that share six lines or more: the same lines, or lines of the same shape with other names, strings and numbers.

Comments, blank lines, includes, imports and lines of mere punctuation do not count, and white space is folded. Rows of a
table are alike by intent, so what has the same shape counts only in two files, and only if its lines differ and say enough;
and tables of sentences not at all."""

import collections
import dataclasses
import pathlib
import re

LINES = 6
MOST_PLACES = 8  # a shape in more places is the language's or the layout's
DIFFERENT_SHAPES = 5
WORDS = 20  # of six lines
SENTENCES = ("refusals.hpp", "sentences.hpp")

PASSED_OVER = re.compile(r"^(?:#\s*(?:include|pragma)\b.*|import\b.*|from\s.*\bimport\b.*|export \{.*|using\b.*|(?:inline )?namespace\b.*"
                         r"|[\W_]*|\} from .*)$")
TOKEN = re.compile(r"""`[^`]*`|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|\d[\w.']*|[A-Za-z_]\w*|\S""")
KEYWORDS = set("""
    if else for while do switch case default return break continue class struct enum template typename const constexpr auto
    static inline using namespace public private protected override virtual noexcept operator this new delete true false
    nullptr void bool int double float char def lambda import from in is not and or None True False with as try except
    raise yield function let var export async await of typeof null undefined type interface extends implements
    std string vector optional""".split())


def shape(line):
    """A line with one letter for each name, string and number."""
    def letter(token):
        if token[0] in "`\"'":
            return "S"
        if token[0].isdigit():
            return "N"
        return token if token in KEYWORDS or not (token[0].isalpha() or token[0] == "_") else "I"
    return " ".join(map(letter, TOKEN.findall(line)))


@dataclasses.dataclass(frozen=True)
class Double:
    """Two places, by their first and last lines."""

    first: tuple
    second: tuple
    lines: int

    def __str__(self):
        return " ~ ".join(f"{path}:{start}-{end}" for path, start, end in (self.first, self.second))


def counted_lines(code):
    """The lines of a source that count: (number, the line with single blanks)."""
    lines = ((number, " ".join(line.split())) for number, line in enumerate(code.splitlines(), 1))
    return [(number, line) for number, line in lines if line and not PASSED_OVER.match(line)]


def doubles(codes):
    """Of sources without comments, by path: pairs of equal places, and pairs of the same shape besides."""
    lines = {path: counted_lines(code) for path, code in codes.items()}
    equal = pairs({path: [(number, line) for number, line in own] for path, own in lines.items()}, lambda window: True)
    shapes = {path: [(number, shape(line)) for number, line in own] for path, own in lines.items()}
    alike = pairs(shapes, says_enough)
    known = [(one.first, one.second) for one in equal]
    alike = [one for one in alike if one.first[0] != one.second[0] and not one.first[0].endswith(SENTENCES)]
    return equal, [one for one in alike if not any(overlap(one.first, a) and overlap(one.second, b) or
                                                   overlap(one.first, b) and overlap(one.second, a) for a, b in known)]


def overlap(one, other):
    return one[0] == other[0] and one[1] <= other[2] and other[1] <= one[2]


def says_enough(window):
    return len(set(window)) >= DIFFERENT_SHAPES and \
        sum(token in ("I", "S", "N") or token in KEYWORDS for line in window for token in line.split()) >= WORDS


def pairs(lines, wanted):
    """Longest runs of equal lines in two places that do not overlap."""
    suffix_of = {path: pathlib.PurePosixPath(path).suffix for path in lines}
    windows = collections.defaultdict(list)
    for path, own in lines.items():
        texts = [text for _, text in own]
        for at in range(len(own) - LINES + 1):
            window = tuple(texts[at:at + LINES])
            if wanted(window):
                windows[window].append((path, at))
    runs = collections.defaultdict(list)  # (path, path, how far apart) → where the windows begin
    for places in windows.values():
        if len(places) > MOST_PLACES:
            continue
        for i, (path, at) in enumerate(places):
            for other, there in places[i + 1:]:
                apart_enough = path != other or abs(there - at) >= LINES
                if apart_enough and kind(suffix_of[path]) == kind(suffix_of[other]):
                    runs[path, other, there - at].append(at)
    return sorted(merged(lines, runs), key=lambda one: (-one.lines, one.first))


def kind(suffix):
    return "cpp" if suffix in (".hpp", ".h", ".c") else suffix.strip(".")


def merged(lines, runs):
    """Windows that follow each other as one run; of runs that overlap on both sides the longest."""
    found = []
    for (path, other, apart), starts in runs.items():
        starts = sorted(set(starts))
        begin = starts[0]
        for at, following in zip(starts, [*starts[1:], None]):
            if following == at + 1:
                continue
            end = at + LINES - 1
            if path == other:
                end = min(end, begin + apart - 1)  # a place does not overlap its double
            found.append(Double((path, lines[path][begin][0], lines[path][end][0]),
                                (other, lines[other][begin + apart][0], lines[other][end + apart][0]), end - begin + 1))
            begin = following
    kept = []
    for one in sorted(found, key=lambda one: -one.lines):
        if not any(overlap(one.first, other.first) and overlap(one.second, other.second) for other in kept):
            kept.append(one)
    return kept
