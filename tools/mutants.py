"""The changes that tools/mutate makes: one operator, constant or statement of a C++ source at a time.

Sources are laid out by clang-format, so a binary operator has a space on both sides and `<` without
them opens template arguments. Changes whose result cannot differ, or seldom does, are left out: texts,
assertions, messages, includes, tolerances, and `<` for `<=` where both sides may be fractions.
"""

import collections
import random
import re

Mutant = collections.namedtuple("Mutant", "path line before after")

TEXT = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(?P<d>[^()\s]*)\(.*?\)(?P=d)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'"""
    r"|^[ \t]*\#[^\n]*|\btemplate <[^\n]*|\[\[[^\]]*\]\]|\boperator\s*[^\s(]+", re.DOTALL | re.MULTILINE)
# What stands in the parentheses of these is a condition that holds anyway, or words for a person.
WORDS = re.compile(r"\b(?:PLANISH_ASSERT|assert|static_assert|fmt::format|reserve|rule_broken|"
                   r"(?:\w+_)?(?:error|refusal)|Error|fail|refuse|unexpected|decltype|sizeof)[({]")
NEAR_TOLERANCE = re.compile(r" [-+*/] tolerance::k\w+|tolerance::k\w+ [-+*/] |[\d.]+ \* k[A-Z]\w+")
TOLERANCE = re.compile(r"\b(?:constexpr|const)\b[^;]*\bk\w*[^;]*=[^;]*?(?:\d[eE]-\d|0\.0\d)[^;]*;", re.DOTALL)

# The right side of a comparison that counts things.
WHOLE = r"(?=(?:[1-9]\d*|n|count|\w*_count|index)\b(?![.(\[]))"
SWAPS = [
    # A comparison turned round; one step aside only where it counts things.
    (r" < ", [" >= "]), (r" <= ", [" > "]), (r" > ", [" <= "]), (r" >= ", [" < "]),
    (r" == ", [" != "]), (r" != ", [" == "]),
    (" < " + WHOLE, [" <= "]), (" <= " + WHOLE, [" < "]),
    (" > " + WHOLE, [" >= "]), (" >= " + WHOLE, [" > "]),
    (r" \+ ", [" - "]), (r" - ", [" + "]), (r" \* ", [" / "]), (r" / ", [" * "]), (r" % ", [" * "]),
    (r" \+= ", [" -= "]), (r" -= ", [" += "]), (r" \*= ", [" /= "]), (r" /= ", [" *= "]),
    (r" && ", [" || "]), (r" \|\| ", [" && "]),
    (r"(?<=[(\s])!(?=[\w(])", [""]),
    (r"(?<=\()-(?=[a-z])|(?<=return )-(?=[a-z])|(?<=[=?:,] )-(?=[a-z])", [""]),
    (r"\bstd::min\b", ["std::max"]), (r"\bstd::max\b", ["std::min"]),
    (r"\bmin_element\b", ["max_element"]), (r"\bmax_element\b", ["min_element"]),
    (r"\bany_of\b", ["all_of"]), (r"\ball_of\b", ["any_of"]), (r"\bnone_of\b", ["any_of"]),
    (r"\bstd::floor\b", ["std::ceil"]), (r"\bstd::ceil\b", ["std::floor"]),
    (r"\bstd::sin\b", ["std::cos"]), (r"\bstd::cos\b", ["std::sin"]),
    (r"\bstd::abs\(", ["("]), (r"\bstd::sqrt\(", ["("]),
    (r"\bfront\(\)", ["back()"]), (r"\bback\(\)", ["front()"]),
    (r"\.x\(\)", [".y()"]), (r"\.y\(\)", [".x()"]),
    (r"\btrue\b", ["false"]), (r"\bfalse\b", ["true"]),
    (r"(?<![\w.'])\d+(?:\.\d*)?(?![\w.'])", None),  # another number
]
SWAPS = [(re.compile(pattern), after) for pattern, after in SWAPS]
CONDITION = re.compile(r"\bif \((?!const |auto )(?=[\w(])")
COMPARISON = re.compile(r" (?:[<>]=?|[=!]=) ")
COMPUTES = re.compile(r" (?:[<>]=?|[=!]=|[-+*/%]=?|&&|\|\|) |\bstd::(?:min|max|abs|sqrt|hypot|clamp)\b")
# A statement of one line that has an effect and declares nothing.
STATEMENT = re.compile(r"\s+(?:[\w.]|->|\[[^\]]*\]|\(\w*\))+(?: (?:[-+*/]|<<|>>|)?= .*|\(.*\));\s*")
NO_STATEMENT = re.compile(r"\s+(?:return|throw|delete|PLANISH_ASSERT|rule_broken|using|case|goto|break|continue|else)\b")


def blanked(text):
    """The text with a blank for every character that is no code to be changed: same places, same lines."""
    blank = lambda found: re.sub(r"[^\n]", " ", found.group())
    text = TEXT.sub(blank, text)
    text = NEAR_TOLERANCE.sub(blank, TOLERANCE.sub(blank, text))
    start = 0
    while found := WORDS.search(text, start):
        end = closing(text, found.end() - 1)
        text = text[:found.end()] + re.sub(r"[^\n]", " ", text[found.end():end]) + text[end:]
        start = found.end()
    return text


def closing(text, opened):
    """Where the parenthesis or brace at `opened` is closed."""
    depth = 0
    for place in range(opened, len(text)):
        depth += (text[place] in "({[") - (text[place] in ")}]")
        if depth == 0:
            return place
    return len(text)


def number_after(number):
    """Another number: the next whole one, twice a fraction."""
    if "." not in number:
        return str(int(number) + 1)
    value = float(number)
    return "1.0" if value == 0 else f"{2 * value:.12g}" + (".0" if (2 * value).is_integer() else "")


def swaps_of(before, code):
    """The line `before` with each change in turn, `code` being what of it may change."""
    for pattern, afters in SWAPS:
        for found in pattern.finditer(code):
            for after in [number_after(found.group())] if afters is None else afters:
                yield before[:found.start()] + after + before[found.end():]
    if found := CONDITION.search(code):
        start, end = found.end(), closing(code, found.end() - 1)
        # A comparison by itself has been turned round already.
        if end < len(code) and not COMPARISON.search(code[start:end]):
            yield f"{before[:start]}!({before[start:end]}){before[end:]}"


def statement(before, code, above):
    """The line without its statement, if it is one that can be dropped."""
    whole = re.search(r"[;{}]$|^$", above.rstrip()) and STATEMENT.fullmatch(code)
    if whole and not NO_STATEMENT.match(code):
        yield before[:len(before) - len(before.lstrip())] + ";"


def mutants(path, text, lines=None):
    """Every change to a source, in the order of its lines; `lines` limits it to some."""
    code = blanked(text).split("\n")
    found = []
    for number, (before, plain) in enumerate(zip(text.split("\n"), code), 1):
        if lines is not None and number not in lines:
            continue
        texts = [*swaps_of(before, plain), *statement(before, plain, code[number - 2])]
        found += [Mutant(path, number, before, after) for after in dict.fromkeys(texts)
                  if after != before]
    return found


def chosen(found, count, seed):
    """`count` of them at most, one a line; lines that compute come four times as often as others."""
    by_line = {}
    for mutant in found:
        by_line.setdefault((mutant.path, mutant.line), []).append(mutant)
    draw = random.Random(seed)

    def key(line):  # the largest of these are a weighted sample
        weight = 4 if COMPUTES.search(by_line[line][0].before) else 1
        return draw.random() ** (1 / weight)

    drawn = sorted(((key(line), line) for line in sorted(by_line)), reverse=True)[:count]
    return sorted(draw.choice(by_line[line]) for _, line in drawn)
