"""Places in front ends that search the English of an error or a finding.

A sentence is what is called `message`, and what is made of it: a variable, a template, a parameter that is given one. `where` counts
only where something else than a JSON pointer is searched in it. Python is read by its grammar, TypeScript and C++ by their layout:
a declaration begins in the first column."""

import ast
import dataclasses
import pathlib
import re

FRONT_ENDS = ("web/src", "integrations/freecad", "apps/python", "apps/cli", "apps/studio")

SEARCHES = {
    ".ts": ("match matchAll replace replaceAll search split includes startsWith endsWith indexOf lastIndexOf slice "
            "substring").split(),
    ".cpp": "find rfind find_first_of find_last_of starts_with ends_with contains substr compare".split(),
    ".py": ("startswith endswith find rfind index rindex split rsplit partition rpartition replace removeprefix "
            "removesuffix count").split()}
PATTERNS = {
    ".ts": "exec test".split(),
    ".cpp": "regex_search regex_match regex_replace sregex_iterator".split(),
    ".py": "findall finditer search match fullmatch sub subn split".split()}
PARTS = {"partition", "rpartition", "split", "rsplit", "group", "groups", "findall"}


@dataclasses.dataclass(frozen=True)
class Site:
    path: str
    line: int
    text: str

    def __str__(self):
        return f"{self.path}:{self.line}: {self.text}"


def readers(tree):
    """All sites in the front ends."""
    texts = {path: tree.text(path) for path in tree.under(*FRONT_ENDS)}
    return readers_in(texts)


def readers_in(texts):
    """The sites in sources, given by their paths; functions are followed through all of a language."""
    found = []
    for suffixes, read in (((".py",), python_sites), ((".ts",), layout_sites), ((".cpp", ".hpp"), layout_sites)):
        chosen = {path: text for path, text in texts.items() if pathlib.PurePosixPath(path).suffix in suffixes}
        found += read(chosen)
    return sorted(set(found), key=lambda site: (site.path, site.line))


# Python

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


def python_sites(texts):
    trees = {path: ast.parse(text) for path, text in texts.items()}
    given = {}  # function → parameters that are given a sentence
    while True:
        found, before = [], {name: set(own) for name, own in given.items()}
        for path, parsed in trees.items():
            for function in [parsed, *(node for node in ast.walk(parsed) if isinstance(node, FUNCTIONS))]:
                found += PythonFunction(path, texts[path], function, given).sites()
        known = {node.name: [one.arg for one in node.args.args] for parsed in trees.values()
                 for node in ast.walk(parsed) if isinstance(node, FUNCTIONS[:2])}
        given = {name: {known[name][at] for at in own if isinstance(at, int) and at < len(known[name])} | own
                 for name, own in given.items() if name in known}
        if given == before:
            return found


def own_nodes(function):
    """The nodes of a function, in order, without those of functions inside it."""
    body = function.body if isinstance(function.body, list) else [function.body]
    waiting = list(reversed(body))
    while waiting:
        node = waiting.pop()
        if isinstance(node, FUNCTIONS):
            continue
        yield node
        waiting += reversed(list(ast.iter_child_nodes(node)))


class PythonFunction:
    """One function: which of its names hold sentences, and where it searches them."""

    def __init__(self, path, text, function, given):
        self.path, self.lines, self.function, self.given = path, text.splitlines(), function, given
        self.held = {name for name in given.get(getattr(function, "name", ""), ()) if isinstance(name, str)}

    def sites(self):
        for _ in range(2):  # a loop may use below what it sets above
            for node in own_nodes(self.function):
                if isinstance(node, (ast.Assign, ast.AnnAssign, ast.NamedExpr)) and node.value and \
                        "message" in self.kinds(node.value):
                    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                    self.held |= {one.id for one in targets if isinstance(one, ast.Name)}
        lines = set()
        for node in own_nodes(self.function):
            if self.is_search(node):
                lines.add(node.lineno)
            self.follow(node)
        return [Site(self.path, line, self.lines[line - 1].strip()) for line in lines]

    def kinds(self, node):
        """What of "message" and "where" a text is made of."""
        if isinstance(node, ast.Name):
            return {"message"} if node.id in self.held else {node.id} & {"message", "where"}
        if isinstance(node, ast.Attribute):
            return {node.attr.lower()} & {"message", "where"}
        if isinstance(node, ast.Subscript):
            return {node.slice.value} & {"message", "where"} if isinstance(node.slice, ast.Constant) else set()
        if isinstance(node, (ast.JoinedStr, ast.BoolOp)):
            return set().union(*(self.kinds(one) for one in node.values))
        if isinstance(node, ast.FormattedValue):
            return self.kinds(node.value)
        if isinstance(node, ast.BinOp):
            return self.kinds(node.left) | self.kinds(node.right)
        if isinstance(node, ast.IfExp):
            return self.kinds(node.body) | self.kinds(node.orelse)
        if isinstance(node, ast.Call):
            return self.kinds_of_call(node)
        return set()

    def kinds_of_call(self, node):
        if isinstance(node.func, ast.Attribute):
            if node.func.attr == "get" and node.args and isinstance(node.args[0], ast.Constant):
                return {node.args[0].value} & {"message", "where"}
            if node.func.attr in ("strip", "replace", "lower", "removeprefix", "removesuffix"):
                return self.kinds(node.func.value)
        if isinstance(node.func, ast.Name) and node.func.id == "getattr" and len(node.args) > 1 and \
                isinstance(node.args[1], ast.Constant):
            return {node.args[1].value} & {"message", "where"}
        return set()

    def is_search(self, node):
        if isinstance(node, ast.Compare):
            return any(isinstance(how, (ast.In, ast.NotIn)) and self.counts(text, [node.left])
                       for how, text in zip(node.ops, node.comparators))
        if isinstance(node, ast.Assign):
            names = {one.id for target in node.targets for one in ast.walk(target) if isinstance(one, ast.Name)}
            return "message" in names and isinstance(node.value, ast.Call) and \
                isinstance(node.value.func, ast.Attribute) and node.value.func.attr in PARTS
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
            return False
        name, of = node.func.attr, node.func.value
        return name in SEARCHES[".py"] and self.counts(of, node.args) or \
            name in PATTERNS[".py"] and any(self.counts(one, [*node.args, of]) for one in node.args)

    def counts(self, text, patterns):
        """Whether a search in a text reads a sentence: of places only what is written for no JSON pointer."""
        kinds = self.kinds(text)
        if kinds != {"where"}:
            return bool(kinds)
        written = [one.value for one in patterns if isinstance(one, ast.Constant) and isinstance(one.value, str)]
        return any(not one.startswith("/") for one in written)

    def follow(self, node):
        """Notes which parameters a call gives sentences to."""
        if not isinstance(node, ast.Call):
            return
        name = getattr(node.func, "id", None) or getattr(node.func, "attr", None)
        for at, one in enumerate(node.args):
            if "message" in self.kinds(one):
                self.given.setdefault(name, set()).add(at)
        for one in node.keywords:
            if one.arg and "message" in self.kinds(one.value):
                self.given.setdefault(name, set()).add(one.arg)


# TypeScript and C++

DECLARATION = re.compile(r"(?m)^(?=[A-Za-z\[])")
FUNCTION = {
    ".ts": re.compile(r"(?:\bfunction (\w+)|\bconst (\w+) = (?:async )?)(?:<[^()]*?>)?(?=\()|^  (?:async )?(\w+)(?=\()", re.M),
    ".cpp": re.compile(r"\b(\w+)(?=\()")}
ASSIGNED = re.compile(r"(?:\b(\w+)(?:: [\w<>\[\]| ]+)?|\b(\w+)\[[^\]]*\]) \+?= (?!>)")
TEMPLATE = re.compile(r"`(?:\\.|\$\{[^{}]*\}|[^`\\])*`|'(?:\\.|[^'\\\n])*'|\"(?:\\.|[^\"\\\n])*\"")
REGEX = re.compile(r"(?<=[=(,:?&|!\s])/(?![/*\s])(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n\[])+/[a-z]*")
CLOSE = {"(": ")", "[": "]", "{": "}"}


def without_texts(text):
    """Strings and regular expressions as blanks of the same length; of templates the values stay."""
    def blank(found):
        whole = found.group()
        kept = [span.span() for span in re.finditer(r"\$\{[^{}]*\}", whole)] if whole[0] == "`" else []
        return "".join(c if c == "\n" or any(a + 2 <= i < b - 1 for a, b in kept) else " "
                       for i, c in enumerate(whole))
    return TEMPLATE.sub(blank, REGEX.sub(lambda found: " " * len(found.group()), text))


def closing(text, start):
    """The end of what opens at `start`."""
    waiting = []
    for at in range(start, len(text)):
        if text[at] in CLOSE:
            waiting.append(CLOSE[text[at]])
        elif waiting and text[at] == waiting[-1]:
            waiting.pop()
            if not waiting:
                return at
    return len(text) - 1


def arguments(text, start):
    """The pieces between commas of what opens at `start`, each with its place."""
    end, pieces, begin, at = closing(text, start), [], start + 1, start + 1
    while at < end:
        if text[at] in CLOSE:
            at = closing(text, at)
        elif text[at] == ",":
            pieces.append((begin, at))
            begin = at + 1
        at += 1
    return [*pieces, (begin, end)] if text[begin:end].strip() else pieces


def receiver(text, end):
    """The expression whose member is named at `end`, where its dot is."""
    at = end
    while at > 0:
        before = text[at - 1]
        if before in ")]":
            depth, at = 1, at - 1
            while at > 0 and depth:
                at -= 1
                depth += {")": 1, "]": 1, "(": -1, "[": -1}.get(text[at], 0)
        elif before.isalnum() or before in "_.?!" or (before == ">" and text[at - 2] == "-") or before == "-":
            at -= 1
        elif before in " \n" and text[at:at + 1] in ".?" and text[:at].rstrip()[-1:] not in "(,=":
            at = len(text[:at].rstrip())
        else:
            break
    return text[at:end]


def outermost(text):
    """A text without what its brackets hold."""
    kept, at = [], 0
    while at < len(text):
        if text[at] in CLOSE:
            at = closing(text, at)
        else:
            kept.append(text[at])
        at += 1
    return "".join(kept)


class Declaration:
    """What begins in the first column, up to the next that does."""

    def __init__(self, path, text, first_line, suffix):
        self.path, self.text, self.first_line, self.suffix = path, text, first_line, suffix
        self.plain = without_texts(text) if suffix == ".ts" else \
            re.sub(r'"(?:\\.|[^"\\\n])*"', lambda found: " " * len(found.group()), text)
        self.held = set()

    def kinds(self, text):
        names = set(re.findall(r"\w+(?!\w*\s*\()", text))
        return ({"message"} if names & (self.held | {"message"}) else set()) | (names & {"where"})

    def hold(self):
        for found in ASSIGNED.finditer(self.plain):
            rest = self.plain[found.end():]
            at = 0
            while at < len(rest) and rest[at] not in ",;)}]":
                at = closing(rest, at) + 1 if rest[at] in CLOSE else at + 1
            value = rest[:at]
            name = found[1] or found[2]
            if "=>" not in value and "message" in self.kinds(outermost(value)):
                if name not in ("message", "code"):
                    self.held.add(name)

    def functions(self):
        for found in FUNCTION[self.suffix].finditer(self.plain):
            pieces = arguments(self.plain, found.end())
            yield next(one for one in found.groups() if one), found.end(), pieces

    def parameters(self):
        """The functions defined here with the names of their parameters."""
        for name, start, pieces in self.functions():
            if self.suffix == ".cpp" and "{" not in self.plain[closing(self.plain, start):][:40].split(";")[0]:
                continue
            yield name, [self.parameter(self.plain[a:b]) for a, b in pieces]

    def parameter(self, text):
        names = re.findall(r"\w+", text.split(":")[0] if self.suffix == ".ts" else text.split("=")[0])
        return names[-1] if names and "{" not in text else ""

    def calls(self):
        """Names of functions, and which of their arguments are sentences."""
        for found in re.finditer(r"\b(\w+)\(", self.plain):
            pieces = arguments(self.plain, found.end() - 1)
            at = [i for i, (a, b) in enumerate(pieces)
                  if "=>" not in self.plain[a:b] and "message" in self.kinds(outermost(self.plain[a:b]))]
            if at:
                yield found[1], at

    def sites(self, pattern_of):
        searches, patterns = "|".join(SEARCHES[self.suffix]), "|".join(PATTERNS[self.suffix])
        for found in re.finditer(rf"(?:\?|!)?\.({searches})\(", self.plain):
            of = receiver(self.plain, found.start())
            if self.counts(of, self.text[found.end():closing(self.plain, found.end() - 1)], pattern_of):
                yield self.site(found.start())
        for found in re.finditer(rf"(?:\.|\b)({patterns})\(", self.plain):
            if self.suffix == ".ts" and found.group()[0] != ".":
                continue
            start, end = found.end(), closing(self.plain, found.end() - 1)
            by = self.pattern_before(found.start()) if self.suffix == ".ts" else self.text[start:end]
            if self.counts(self.plain[start:end], by, pattern_of):
                yield self.site(found.start())

    def pattern_before(self, end):
        line = " " + self.text[:end].rsplit("\n", 1)[-1]
        written = [one.group() for one in REGEX.finditer(line) if one.end() == len(line)]
        return written[0] if written else re.split(r"\W+", line)[-1]

    def counts(self, searched, pattern, pattern_of):
        kinds = self.kinds(searched)
        if kinds != {"where"}:
            return bool(kinds)
        written = [one.group() for one in [*REGEX.finditer(" " + pattern), *TEMPLATE.finditer(pattern)]]
        written += [pattern_of[name] for name in re.findall(r"\w+", pattern) if name in pattern_of]
        return any(not re.match(r"""[/'"`]\^?\\?/""", one) for one in written)

    def site(self, at):
        line = self.text.count("\n", 0, at)
        return Site(self.path, self.first_line + line, self.text.splitlines()[line].strip())


def layout_sites(texts):
    from .tree import without_comments
    declarations, pattern_of = [], {}
    for path, text in texts.items():
        suffix = ".ts" if path.endswith(".ts") else ".cpp"
        code = without_comments(text, suffix)
        for name, pattern in re.findall(r"\b(\w+) = (/(?![/*]).+/[a-z]*)", code):
            pattern_of[name] = pattern
        starts = [found.start() for found in DECLARATION.finditer(code)] + [len(code)]
        declarations += [Declaration(path, code[a:b], code.count("\n", 0, a) + 1, suffix)
                         for a, b in zip(starts, starts[1:])]
    defined = {}
    for one in declarations:
        for name, parameters in one.parameters():
            defined.setdefault(name, []).append((one, parameters))
    for _ in range(5):  # so many functions in a row
        for one in declarations:
            one.hold()
            for name, at in one.calls():
                for other, parameters in defined.get(name, ()):
                    other.held |= {parameters[i] for i in at if i < len(parameters) and parameters[i]}
    return [site for one in declarations for site in one.sites(pattern_of)]
