"""What is handed over from Python: files, JSON, shapes of other libraries, options."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Mapping
from typing import Any, Union

from ._errors import InvalidInput

PathLike = Union[str, "os.PathLike[str]"]
#: A file; the content of a STEP, B-rep or JSON file; JSON as a dictionary; a shape of FreeCAD or CadQuery.
Input = Union[PathLike, bytes, bytearray, memoryview, Mapping[str, Any], Any]

_STAND_IN = "bytes"  # for content that is handed over beside the request


def request_of(maker: str, given: Input, options: Mapping[str, Any], name: str | None = None,
               **rest: Any) -> tuple[str, bytes | None]:
    """A request as JSON, and the bytes of its input if they are not in it."""
    request: dict[str, Any] = {"maker": maker, "options": options_of(options), **rest}
    content: bytes | None = None
    if isinstance(given, (str, os.PathLike)):
        request["input"] = os.fspath(given)
        if not request["input"]:
            raise InvalidInput("cannot_read", "the path of the input is empty")
    elif isinstance(given, Mapping):
        request["input"] = {"name": name or f"{maker}.json", "content": _json(given), "folder": os.getcwd()}
    else:
        content = _bytes_of(given)
        if not content:
            raise InvalidInput("empty_file", "the input is empty: no bytes were given", name or "")
        request["input"] = {"name": name or "part", "content": _STAND_IN, "folder": os.getcwd()}
    return json.dumps(request, ensure_ascii=False), content


def options_of(options: Mapping[str, Any]) -> dict[str, Any]:
    """Options as JSON; those that are None are left out. Dictionaries stand for files of that content."""
    return {name: _option(name, value) for name, value in options.items() if value is not None}


def _option(name: str, value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping) and name != "bend_k":
        return {"name": name, "content": json.dumps(_json(value)) if name == "tools" else _json(value)}
    return _json(value)


def _json(value: Any) -> Any:
    """The value with numbers and arrays of NumPy as plain ones."""
    if isinstance(value, Mapping):
        return {str(key): _json(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_json(one) for one in value]
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return value


def _bytes_of(given: Any) -> bytes:
    if isinstance(given, (bytes, bytearray, memoryview)):
        return bytes(given)
    if hasattr(given, "val") and callable(given.val):  # a CadQuery workplane
        given = given.val()
    if hasattr(given, "exportBrepToString"):  # FreeCAD
        return str(given.exportBrepToString()).encode()
    if hasattr(given, "exportBrep"):  # CadQuery
        stream = io.BytesIO()
        given.exportBrep(stream)
        return stream.getvalue()
    raise TypeError(f"the input is a {type(given).__name__}; give a path, the bytes of a STEP or B-rep file, or a "
                    "dictionary")
