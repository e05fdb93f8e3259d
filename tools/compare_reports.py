#!/usr/bin/python3
"""Compares the reports of two builds of planish over many files.

  tools/compare_reports.py OLD NEW FILE_OR_FOLDER…      OLD, NEW: the program `planish` of each build

Every number, id and code of the old report must be in the new one, at the same place and to the last bit. Keys may be
added and sentences may change (`message`, `notes`), also the form of `checks[].places`. Prints what differs, and how
many files were the same. Exit status 1 if any differs.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

WORDS = {"message", "notes", "where", "files"}


def command_of(path):
    """A JSON file lies in a folder that is called like the command that takes it, as in examples/."""
    return ["unfold", "--all"] if path.suffix.lower() != ".json" else [path.parent.name]


def report(program, path):
    """What the program says of a file: its exit status, and its reports without words."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        command = command_of(path)
        target = ["-o", f"{out}/"] if command[-1] == "--all" else ["--json", f"{out}/summary.json", "--check"]
        done = subprocess.run([program, *command, path, *target, "-q"], capture_output=True, text=True, timeout=600)
        made = out / "summary.json"
        return done.returncode, json.loads(made.read_text("utf-8")) if made.exists() else None


def differences(old, new, at=""):
    if isinstance(old, dict) and isinstance(new, dict):
        for key in old:
            if key in WORDS or key == "places" and "severity" in old:
                continue
            if key not in new:
                yield f"{at}/{key} is gone"
            else:
                yield from differences(old[key], new[key], f"{at}/{key}")
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{at}: {len(old)} before, {len(new)} now"
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, f"{at}/{i}")
    elif old != new:
        yield f"{at}: {old} before, {new} now"


def compared(programs, path):
    (status, old), (new_status, new) = (report(program, path) for program in programs)
    found = [] if status == new_status else [f"exit status {status} before, {new_status} now"]
    if (old is None) != (new is None):
        return [*found, "only one has a report"]
    return [*found, *differences(old, new)]


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    programs = sys.argv[1:3]
    files = []
    for name in map(pathlib.Path, sys.argv[3:]):
        files += sorted(name.rglob("*")) if name.is_dir() else [name]
    files = [path for path in files if path.suffix.lower() in (".step", ".stp", ".json")]
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda path: compared(programs, path), files))
    for path, found in zip(files, results):
        for line in found[:5]:
            print(f"{path.name}{line if line.startswith('/') else ': ' + line}")
    same = sum(not found for found in results)
    print(f"{same} of {len(files)} files have the same reports.")
    sys.exit(0 if same == len(files) > 0 else 1)


if __name__ == "__main__":
    main()
