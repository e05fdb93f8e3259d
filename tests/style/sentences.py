"""The tables of sentences, `src/<module>/refusals.hpp` and `sentences.hpp`, and the places that fill them."""

import re

LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
SLOT = re.compile(r"\{(@?)(\w+)(?::[^}]*)?\}")
# A kind of place, and behind it something that is not filled with one.
BARE = re.compile(r"\b(?:faces?|edges?|body|bodies|flanges?|bends?|plates?|strips?|ridges?|strokes?|lines?) "
                  r"\"?\{(?!@)\w+(?::\d+)?\}")
# Measures behind such a word, and numbers of things that are not there or that no file has.
NO_PLACES = {"mesh_volume", "touch_at_bend", "no_such_edge", "edges_too_near", "solid_through_itself", "root_unknown",
             "pattern_root_unknown"}
KEYS = {"inside_radii", "inside_radius", "slope"}  # of files, with which a sentence may begin
PLAIN = re.compile(r'\b(?:fail\(|Error\{)\s*code::\w+,\s*(?:fmt::format\(\s*)?"')


def balanced(text, at):
    """The end of the group that opens at `at`."""
    pairs, depth, i = {"{": 1, "(": 1, "}": -1, ")": -1}, 0, at
    while i < len(text):
        if text[i] == '"':
            i = LITERAL.match(text, i).end()
            continue
        depth += pairs.get(text[i], 0)
        i += 1
        if depth == 0:
            return i
    raise ValueError("unbalanced")


def statement_end(text, at):
    """The next semicolon that is in no literal."""
    while text[at] != ";":
        at = LITERAL.match(text, at).end() if text[at] == '"' else at + 1
    return at


def parts(text):
    """What commas separate at the top level of a group's inside."""
    found, start, i = [], 0, 0
    while i < len(text):
        if text[i] == '"':
            i = LITERAL.match(text, i).end()
        elif text[i] in "{(":
            i = balanced(text, i)
        elif text[i] == ",":
            found.append(text[start:i])
            start = i = i + 1
        else:
            i += 1
    return found + [text[start:]]


def words_of(part):
    """Adjacent literals as one string; nothing if the part is none."""
    return "".join(LITERAL.findall(part))


def tables(root):
    """{name: [strings]} of every sentence in the tables, by file."""
    found = {}
    for path in sorted([*root.glob("src/*/refusals.hpp"), *root.glob("src/*/sentences.hpp")]):
        text = path.read_text("utf-8")
        rows = found.setdefault(path, {})
        for match in re.finditer(r"constexpr (?:Refusal|Sentence|std::string_view|auto) (\w+)(\{| =)", text):
            end = balanced(text, match.end() - 1) if match[2] == "{" else statement_end(text, match.end())
            inside = text[match.end():end - (match[2] == "{")]
            rows[match[1]] = [words_of(part) for part in parts(inside)]
    return found


def faults(root):
    """Sentences that name a place by other than a place, or are no sentences."""
    found = []
    for path, rows in tables(root).items():
        for name, strings in rows.items():
            where = f"{path.relative_to(root)}: {name}"
            for text in strings:
                if name not in NO_PLACES and BARE.search(text):
                    found.append(f"{where}: \"{BARE.search(text)[0]}\" is no place: write {{@…}}")
            sentences = [text for text in strings[1:3] if text] if path.name == "refusals.hpp" else []
            for text in sentences:
                if not text.endswith((".", "?")) and not text.endswith("}"):
                    found.append(f"{where}: ends without a full stop: {text[-40:]}")
                if not re.match(r"[A-Z{`0-9]", text) and text.split()[0] not in KEYS:
                    found.append(f"{where}: begins small: {text[:40]}")
    return found


def unfilled(root):
    """Calls that leave a slot of their sentence without a fact."""
    found = []
    by_module = {}
    for path, rows in tables(root).items():
        by_module.setdefault(path.parent.name, {}).update(rows)
    for module, rows in by_module.items():
        for path in sorted((root / "src" / module).glob("**/*.cpp")):
            text = path.read_text("utf-8")
            for match in re.finditer(r"\bfail\(\s*refuse::(\w+)\s*,\s*\{", text):
                facts = text[match.end() - 1:balanced(text, match.end() - 1)]
                each = [one.strip() for one in parts(facts[1:-1]) if one.strip()]
                if any(not re.match(r'\{\s*"', one) for one in each):
                    continue  # a fact made elsewhere
                names = set(re.findall(r"\{\s*\"(\w+)\"", facts))
                wanted = {slot[1] for string in rows.get(match[1], []) for slot in SLOT.findall(string)}
                if match[1] not in rows:
                    found.append(f"{path.relative_to(root)}: no sentence is called {match[1]}")
                elif wanted - names:
                    found.append(f"{path.relative_to(root)}: {match[1]} lacks {', '.join(sorted(wanted - names))}")
    return found


def plain(path):
    """How many errors of a file have a sentence of their own."""
    return len(PLAIN.findall(path.read_text("utf-8")))
