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
CODE = re.compile(r"inline constexpr ErrorCode (\w+)\{")
# What makes an error of a sentence, and whether it knows the field by itself.
CALLS = re.compile(r"\b(fail|error_of|fail_at|error_at|mistake)\(")
KNOW_THE_FIELD = {"fail_at", "error_at", "mistake"}
# A fact that is no place: words, a number, or a text made of them.
NO_PLACE = re.compile(r"[\"\d]|fmt::|std::string|std::to_string")
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


def table_files(root):
    return sorted([*root.glob("src/*/refusals.hpp"), *root.glob("src/*/sentences.hpp"), *root.glob("apps/**/refusals.hpp")])


def codes(root):
    """The names of all codes of errors."""
    headers = [root / "include/planish/base/code.hpp", *root.glob("include/planish/*/codes.hpp")]
    return {name for path in headers for name in CODE.findall(path.read_text("utf-8"))}


def refusals_by_code(root):
    """{code: ["src/job/refusals.hpp: one_k"]} of the tables."""
    found = {}
    for path in table_files(root):
        for name, code in re.findall(r"constexpr Refusal (\w+)\{\s*code::(\w+)", path.read_text("utf-8")):
            found.setdefault(code, []).append(f"{path.relative_to(root)}: {name}")
    return found


def tables(root):
    """{name: [strings]} of every sentence in the tables, by file."""
    found = {}
    for path in table_files(root):
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
                if not re.match(r"[A-Z{`0-9]|--[a-z]", text) and text.split()[0] not in KEYS:
                    found.append(f"{where}: begins small: {text[:40]}")
    return found


def calls_of(text):
    """(function, names of its sentences, what is given behind them) of each error that is made."""
    for match in CALLS.finditer(text):
        arguments = parts(text[match.end():balanced(text, match.end() - 1) - 1])
        for i, one in enumerate(arguments):
            names = re.findall(r"\brefuse::(\w+)", one)
            if names and re.match(r"[^({]*(?:\?|\([^?]*\)[^?(]*\?)?\s*refuse::", one):
                behind = i + (2 if match[1] in ("fail_at", "error_at") else 1)
                yield match[1], names, arguments[behind:]
                break


def facts_in(arguments):
    """{name: value} as the sources have them; None if they are made elsewhere."""
    if not arguments or not arguments[0].strip():
        return {}
    group = arguments[0].strip()
    if not group.startswith("{"):
        return None
    facts = {}
    for one in parts(group[1:-1]):
        match = re.match(r"\s*\{\s*\"(\w+)\",(.*)\}\s*$", one, re.S)
        if one.strip() and not match:
            return None
        if match:
            facts[match[1]] = match[2].strip()
    return facts


def unfilled(root):
    """Calls that leave a slot of their sentence without a fact, or fill one for a place with something else."""
    found = []
    by_module = {}
    for path, rows in tables(root).items():
        by_module.setdefault(path.parent, {}).update(rows)
    for folder, rows in by_module.items():
        for path in sorted(folder.glob("**/*.cpp")):
            for function, names, arguments in calls_of(path.read_text("utf-8")):
                facts = facts_in(arguments)
                if facts is None:
                    continue
                where = path.relative_to(root)
                for name in names:
                    slots = {slot[1]: slot[0] == "@" for string in rows.get(name, []) for slot in SLOT.findall(string)}
                    given = set(facts) | ({"field"} if function in KNOW_THE_FIELD else set())
                    if name not in rows:
                        found.append(f"{where}: no sentence is called {name}")
                    elif set(slots) - given:
                        lacking = ", ".join(sorted(set(slots) - given))
                        found.append(f"{where}: {name} lacks {lacking}")
                    found += [f"{where}: {name} has no place as {slot}: {facts[slot]}" for slot, is_place in slots.items()
                              if is_place and slot in facts and NO_PLACE.match(facts[slot])]
    return found


def plain(path):
    """How many errors of a file have a sentence of their own."""
    return len(PLAIN.findall(path.read_text("utf-8")))
