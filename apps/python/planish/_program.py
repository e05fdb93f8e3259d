"""What the program `planish` does in processes of its own: many files, and packs for the shop."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from typing import Any

from . import _planish
from ._errors import _WRONG_USE, Cancelled, Failed, InvalidInput, error_of
from ._inputs import PathLike
from ._parts import Listener
from ._record import Record


def info(input: PathLike, *, body: int | str | None = None, sheets: bool = False, progress: Listener = None) -> Record:
    """What a STEP or B-rep file holds: bodies with names, quantities, sizes and volumes.

    body: one of them, by its number or name. sheets: look for the sheet in each. Raises InvalidInput.
    """
    name = "" if body is None else str(body)
    return Record(json.loads(_planish.info(os.fspath(input), name, sheets, progress)))


def schema(name: str) -> str:
    """A JSON Schema, by its name in `schema_names()`."""
    text = str(_planish.schema(name))
    if not text:
        raise InvalidInput("bad_option", f'there is no schema "{name}"; there are '
                           + ", ".join(_planish.schema_names()), "name")
    return text


def program() -> str:
    """The path of `planish`: of the variable PLANISH, of this build, or of the PATH."""
    named = os.environ.get("PLANISH")
    built = pathlib.Path(__file__).parents[2] / "apps/planish"
    found = named or (str(built) if built.is_file() else shutil.which("planish"))
    if found is None:
        raise Failed("internal", "the program planish was not found: install the package planish, or name it in the "
                     "environment variable PLANISH")
    return found


def batch(inputs: PathLike | Iterable[PathLike], out: PathLike, *, formats: str | Iterable[str] = ("dxf",),
          jobs: int | None = None, time_limit: float | None = None, memory_limit: float | None = None,
          progress: Listener = None, **options: Any) -> Record:
    """Unfolds or makes thousands of parts, in processes of their own; returns the summary (docs/batch.md).

    inputs: files, folders, "@lists". out: the folder of the results. jobs: processes at once. time_limit: seconds for
    each part. memory_limit: MiB of each process. Options are those of the makers. What an earlier call has done is
    kept. Raises InvalidInput, Cancelled, Failed.
    """
    words = ["--format", formats if isinstance(formats, str) else ",".join(formats)]
    _run("batch", inputs, out, words, {"jobs": jobs, "time_limit": time_limit, "memory_limit": memory_limit, **options},
         progress)
    return Record(json.loads((pathlib.Path(out) / "summary.json").read_text()))


def pack(inputs: PathLike | Iterable[PathLike], out: PathLike, *, progress: Listener = None,
         **options: Any) -> list[pathlib.Path]:
    """Makes what goes to the shop: identical parts merged, patterns, drawings, list, cover (docs/pack.md).

    Options are those of `planish pack`, as `nest="3000x1500"`, `gap=5`, `zip=True`. Returns the files. Raises
    InvalidInput, Refused, Cancelled, Failed.
    """
    _run("pack", inputs, out, [], options, progress)
    return sorted(path for path in pathlib.Path(out).rglob("*")
                  if path.is_file() and not any(part.startswith(".") for part in path.relative_to(out).parts))


def _run(command: str, inputs: PathLike | Iterable[PathLike], out: PathLike, words: list[str],
         options: Mapping[str, Any], progress: Listener) -> None:
    given = [inputs] if isinstance(inputs, (str, os.PathLike)) else list(inputs)
    call = [program(), command, *(os.fspath(path) for path in given), "-o", os.fspath(out), *words, "--progress", "json"]
    for name, value in options.items():
        call += _flag(name, value)
    child = subprocess.Popen(call, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                             text=True, errors="replace")
    said = ""
    reason: dict[str, Any] | None = None
    cancelled = False
    assert child.stderr is not None
    try:
        for line in child.stderr:
            row = _row(line)
            reason = row.get("reason", reason)
            told = _told(row)
            if told is None:
                said = line.strip() or said
            elif progress is not None and not cancelled and progress(*told) is False:
                cancelled = True
                child.terminate()
        child.wait()
    except BaseException:
        child.terminate()
        child.wait()
        raise
    finally:
        child.stderr.close()
    if cancelled:
        raise Cancelled("cancelled", "stopped; what is done is kept")
    if child.returncode != 0:
        raise _error_of(reason, said, child.returncode)


def _flag(name: str, value: Any) -> list[str]:
    flag = "--" + name.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [flag]
    if isinstance(value, Mapping):
        return [word for key, one in value.items() for word in (flag, f"{key}={one}")]
    return [flag, os.fspath(value) if isinstance(value, os.PathLike) else str(value)]


def _row(line: str) -> dict[str, Any]:
    """A line of `--progress json`; empty for any other."""
    try:
        row = json.loads(line)
    except ValueError:
        return {}
    return row if isinstance(row, dict) else {}


def _told(row: Mapping[str, Any]) -> tuple[str, float] | None:
    if "done" not in row:
        return None
    return f"{row['done']} of {row['all']}", row["done"] / max(1, row["all"])


def _error_of(reason: Mapping[str, Any] | None, said: str, status: int) -> Exception:
    """The exception for what the program gives as its reason; without one, for what it said last."""
    if reason is not None:
        return error_of(reason["code"], reason["message"], reason["where"], status, json.dumps(reason))
    if status == _WRONG_USE:
        return InvalidInput("bad_option", said)
    return Failed("internal", said or f"planish ended with status {status}")

