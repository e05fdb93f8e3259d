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
from ._errors import Cancelled, Failed, InvalidInput, error_of
from ._inputs import Input, PathLike, _bytes_of, _json
from ._parts import Listener
from ._record import Record


def maker_of(given: Input) -> str:
    """The name of the maker that reads an input: "unfold", "connect", …"""
    if isinstance(given, (str, os.PathLike)):
        return str(_planish.maker_of_file(os.fspath(given)))
    content = json.dumps(_json(given)).encode() if isinstance(given, Mapping) else _bytes_of(given)
    return str(_planish.maker_for("the input", content))


def info(input: PathLike, *, body: int | str | None = None, sheets: bool = False, progress: Listener = None) -> Record:
    """What a STEP or B-rep file holds: bodies with names, quantities, sizes and volumes.

    body: one of them, by its number or name. sheets: look for the sheet in each. Raises InvalidInput.
    """
    name = "" if body is None else str(body)
    return Record(json.loads(_planish.info(os.fspath(input), name, sheets, progress)))


def program() -> str:
    """The path of `planish`: of the variable PLANISH, of this build, or of the PATH."""
    named = os.environ.get("PLANISH")
    built = pathlib.Path(__file__).parents[2] / "apps/planish"
    found = named or (str(built) if built.is_file() else shutil.which("planish"))
    if found is None:
        raise Failed("internal", "the program planish was not found: install the package planish, or name it in the "
                     "environment variable PLANISH")
    return found


def batch(inputs: PathLike | Iterable[PathLike], out: PathLike, *, formats: Iterable[str] = ("dxf",),
          jobs: int | None = None, time_limit: float | None = None, memory_limit: float | None = None,
          progress: Listener = None, **options: Any) -> Record:
    """Unfolds or makes thousands of parts, in processes of their own; returns the summary (docs/batch.md).

    inputs: files, folders, "@lists". out: the folder of the results. jobs: processes at once. time_limit: seconds for
    each part. memory_limit: MiB of each process. Options are those of the makers. What an earlier call has done is
    kept. Raises InvalidInput, Cancelled, Failed.
    """
    words = ["--format", ",".join(formats)]
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
    cancelled = False
    assert child.stderr is not None
    try:
        for line in child.stderr:
            told = _told(line)
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
        raise _error_in(said, child.returncode)


def _flag(name: str, value: Any) -> list[str]:
    flag = "--" + name.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [flag]
    if isinstance(value, Mapping):
        return [word for key, one in value.items() for word in (flag, f"{key}={one}")]
    return [flag, os.fspath(value) if isinstance(value, os.PathLike) else str(value)]


def _told(line: str) -> tuple[str, float] | None:
    try:
        step = json.loads(line)
    except ValueError:
        return None
    if not isinstance(step, dict) or "done" not in step:
        return None
    return f"{step['done']} of {step['all']}", step["done"] / max(1, step["all"])


def _error_in(said: str, status: int) -> Exception:
    """The exception for the last line of the program: "planish: message [code]"."""
    message, _, code = said.removeprefix("planish: ").rpartition(" [")
    if not message:
        return Failed("internal", said or f"planish ended with status {status}")
    return error_of(code.rstrip("]"), message, "", status) if status != 1 or code == "cancelled]" else Failed(
        code.rstrip("]"), message)


__all__ = ["InvalidInput", "batch", "info", "maker_of", "pack", "program"]
