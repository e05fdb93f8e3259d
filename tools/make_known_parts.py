#!/usr/bin/env python3
"""Writes parts of sheet metal whose flat pattern is known by a formula: folded, as STEP files, and
their sizes when flat, as known_parts.json. Any program that unfolds can be scored on them with
score_parts.py; docs/checking.md explains how. Needs nothing but Python."""

import argparse
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from known_parts import catalogue  # noqa: E402
from known_parts.step_text import step_text  # noqa: E402


def expected(parts):
    return {"format": "known_parts", "version": 1, "units": "mm",
            "parts": [parts[name].record() for name in sorted(parts)]}


def expected_text(parts):
    """One part a line, so that a change shows where it is."""
    whole = expected(parts)
    rows = ",\n".join(json.dumps(row, ensure_ascii=False) for row in whole.pop("parts"))
    return json.dumps(whole, ensure_ascii=False)[:-1] + ', "parts": [\n' + rows + "\n]}\n"


def write_parts(parts, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, part in parts.items():
        text = step_text(name, [(name, part.solid, part.inch)])
        (folder / f"{name}.step").write_text(text, encoding="ascii")


def write_together(parts, path):
    """All parts in one file, one product each."""
    solids = [(name, parts[name].solid, parts[name].inch) for name in sorted(parts)]
    path.write_text(step_text(path.stem, solids), encoding="ascii")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, nargs="?",
                        help="where the STEP files and known_parts.json go")
    parser.add_argument("--count", type=int, default=0, metavar="N",
                        help="N parts drawn by chance instead of the fixed list")
    parser.add_argument("--seed", type=int, default=1, help="of --count; default 1")
    parser.add_argument("--together", action="store_true",
                        help="also all_parts.step: every part in one file")
    parser.add_argument("--expected", type=pathlib.Path, metavar="FILE",
                        help="write only the sizes, to FILE")
    options = parser.parse_args()
    if not options.folder and not options.expected:
        parser.error("a folder or --expected is needed")
    parts = catalogue.drawn(options.count, options.seed) if options.count else catalogue.fixed()
    if options.expected:
        options.expected.write_text(expected_text(parts), encoding="utf-8")
    if options.folder:
        write_parts(parts, options.folder)
        if options.together:
            write_together(parts, options.folder / "all_parts.step")
        (options.folder / "known_parts.json").write_text(expected_text(parts), encoding="utf-8")
        print(f"{len(parts)} parts and known_parts.json in {options.folder}")


if __name__ == "__main__":
    main()
