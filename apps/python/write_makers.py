#!/usr/bin/env python3
"""Writes two files of the package in FOLDER: _makers.py, a function for each maker with the options that it takes, and
_reports.py, the types of reports."""

import json
import keyword
import pathlib
import sys
import textwrap

TYPES = {"flag": "bool", "number": "float", "whole": "int", "name": "int | str",
         "file": "PathLike | Mapping[str, Any]", "by_bend": "Mapping[str, float]"}
OWN_TYPES = {"weights": "str | Mapping[str, float]", "fix": "str | Sequence[str]"}
COLUMNS = 116
HEAD = '''"""The makers. Written by write_makers.py from the catalogue of the library."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from ._inputs import Input, PathLike
from ._parts import BendPlan, Listener, Part, make, plan
'''
INPUTS = {
    "unfold": "a STEP or B-rep file: its path, its bytes, or a shape of FreeCAD or CadQuery",
    "other": "its path, or the same as a dictionary",
}
ENDS = '''progress: is called with a stage and the share done, 0 to 1; False cancels. name: of an input that is not a file.
Raises Refused, InvalidInput, Cancelled.'''


def type_of(option):
    if option["name"] in OWN_TYPES:
        return OWN_TYPES[option["name"]]
    words = ", ".join(f'"{word}"' for word in option["words"])
    if option["kind"] == "word":
        return f"Literal[{words}]"
    if option["kind"] == "face":
        return f"int | Literal[{words}]"
    return TYPES[option["kind"]]


def wrapped(text, indent, first=None):
    return textwrap.fill(text, COLUMNS, initial_indent=indent if first is None else first,
                         subsequent_indent=indent)


def option_text(option):
    end = f"; default {option['otherwise']}" if option["otherwise"] else ""
    return wrapped(f"{option['name']}: {option['description'].replace('`', '')}{end}", "        ", "    ")


def function(name, title, given, options, result, call):
    lines = [f"def {name}(input: Input, *, name: str | None = None, progress: Listener = None"]
    lines += [f"{' ' * (5 + len(name))}{option['name']}: {type_of(option)} | None = None" for option in options]
    text = [f'    """{title}', "", f"    input: {given}.", ""]
    text += [option_text(option) for option in options] + [""] + ["    " + line for line in ENDS.splitlines()]
    names = ", ".join(f'"{option["name"]}": {option["name"]}' for option in options)
    values = textwrap.fill(f"options = {{{names}}}", COLUMNS, initial_indent="    ", subsequent_indent=" " * 15,
                           break_long_words=False)
    return ",\n".join(lines) + f") -> {result}:\n" + "\n".join(text) + f'\n    """\n{values}\n    return {call}\n'


def first_capital(text):
    return text[0].upper() + text[1:]


def text_of(catalogue):
    parts = [HEAD]
    makers = catalogue["makers"]
    for maker in makers:
        kind = INPUTS["unfold"] if maker["name"] == "unfold" else f"a {maker['input']}: {INPUTS['other']}"
        parts.append(function(maker["name"], first_capital(maker["description"]) + ".", kind, maker["options"], "Part",
                              f'make("{maker["name"]}", input, options, name=name, progress=progress)'))
    bending = {option["name"]: option for maker in makers for option in maker["options"]}
    bending.pop("check_bending", None)
    for option in catalogue["options"]:
        if option["name"] in catalogue["tasks"]["bend"]:
            bending.setdefault(option["name"], option)
    parts.append(function(
        "bend", "Find the order of strokes in which a press brake bends what a STEP file or a maker's input describes.",
        "what the makers take", list(bending.values()), "BendPlan",
        "plan(input, options, name=name, progress=progress)"))
    names = ", ".join(f'"{maker["name"]}"' for maker in makers)
    parts[0] += f'\n__all__ = ["bend", {names}]\n'
    return "\n\n".join(parts)


REPORTS_HEAD = '''"""Types of reports. Written by write_makers.py from their schema; what is there at run time is a Record."""

from __future__ import annotations

from typing import Any, Literal

from ._record import Record
'''
SINGULAR = {"bends": "bend", "checks": "check", "features": "feature", "labels": "label", "strokes": "stroke",
            "patches": "patch", "press_lines": "press_line", "true_lengths": "true_length", "strips": "strip",
            "proposals": "proposal", "pieces": "piece"}
PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}


class Reports:
    """Classes for the objects of a schema, each before the one that holds it."""

    def __init__(self):
        self.classes = {}

    def of(self, schema, name):
        """The type that a schema describes; objects become classes called like `name`."""
        if "anyOf" in schema:
            return " | ".join(dict.fromkeys(self.of(one, name) for one in schema["anyOf"]))
        if "enum" in schema:
            return f"Literal[{', '.join(json.dumps(word) for word in schema['enum'])}]"
        kinds = schema.get("type", "any")
        if isinstance(kinds, list):
            return " | ".join(self.of({**schema, "type": kind}, name) for kind in kinds)
        if kinds == "array":
            return f"tuple[{self.of(schema.get('items', {}), name)}, ...]"
        if kinds != "object":
            return PLAIN.get(kinds, "Any")
        if "properties" not in schema:
            return "Record"
        return self.add(schema, name)

    def add(self, schema, name):
        fields = {key: self.of(one, name + "".join(word.capitalize() for word in SINGULAR.get(key, key).split("_")))
                  for key, one in schema["properties"].items()}
        self.classes[name] = fields
        return name

    def text(self):
        parts = [REPORTS_HEAD]
        for name, fields in self.classes.items():
            parts.append(f"class {name}(Record):\n" + self.fields(fields))
        # The same for objects that are no reports themselves.
        for name, of, left_out in (("PartKeys", "Report", ("flat",)),
                                   ("FlatKeys", "ReportFlat", ("area", "perimeter", "openings", "slits", "bends")),
                                   ("BendKeys", "ReportFlatBend", ("lines",))):
            # Of what was made these are known; a part that comes with a refusal may lack them.
            fields = {key: kind.removesuffix(" | None") if key in ("sheet", "verification") else kind
                      for key, kind in self.classes[of].items() if key not in left_out}
            parts.append(f"class {name}:\n" + self.fields(fields))
        return "\n\n".join(parts)

    @staticmethod
    def fields(fields):
        lines = [f"    {key}: {kind}" for key, kind in fields.items() if not keyword.iskeyword(key)]
        return "\n".join(lines) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(folder))
    import _planish
    reports = Reports()
    reports.add(json.loads(_planish.schema("report")), "Report")
    (folder / "_reports.py").write_text(reports.text())
    (folder / "_makers.py").write_text(text_of(json.loads(_planish.catalogue())))


main()
