#!/usr/bin/env python3
"""Writes _makers.py of the package in FOLDER: a function for each maker, with the options that it takes."""

import json
import pathlib
import sys
import textwrap

TYPES = {"flag": "bool", "number": "float", "whole": "int", "name": "int | str",
         "file": "PathLike | Mapping[str, Any]", "by_bend": "Mapping[str, float]"}
COLUMNS = 116
HEAD = '''"""The makers. Written by write_makers.py from the catalogue of the library."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

from ._inputs import Input, PathLike
from ._parts import BendPlan, Listener, Part, make, plan
from ._program import maker_of
'''
INPUTS = {
    "unfold": "a STEP or B-rep file: its path, its bytes, or a shape of FreeCAD or CadQuery",
    "other": "its path, or the same as a dictionary",
}
ENDS = '''progress: is called with a stage and the share done, 0 to 1; False cancels. name: of an input that is not a file.
Raises Refused, InvalidInput, Cancelled.'''


def type_of(option):
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


def text_of(makers):
    parts = [HEAD]
    for maker in makers:
        kind = INPUTS["unfold"] if maker["name"] == "unfold" else f"a {maker['input']}: {INPUTS['other']}"
        parts.append(function(maker["name"], first_capital(maker["description"]) + ".", kind, maker["options"], "Part",
                              f'make("{maker["name"]}", input, options, name=name, progress=progress)'))
    bending = {option["name"]: option for maker in makers for option in maker["options"]}
    bending.pop("check_bending", None)
    parts.append(function(
        "bend", "Find the order of strokes in which a press brake bends what a STEP file or a maker's input describes.",
        "what the makers take", list(bending.values()), "BendPlan",
        "plan(maker_of(input), input, options, name=name, progress=progress)"))
    return "\n\n".join(parts)


def main():
    folder = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(folder))
    import _planish
    (folder / "_makers.py").write_text(text_of(json.loads(_planish.catalogue())))


main()
