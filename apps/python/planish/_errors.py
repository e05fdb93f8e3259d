"""Exceptions. Codes are those of reports (docs/formats.md#reason)."""

from __future__ import annotations

import json
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Mapping

if TYPE_CHECKING:
    from ._parts import Part


class Error(Exception):
    """What Planish could not do.

    code: one word for scripts, such as "not_a_sheet"; message: a sentence with numbers and the remedy;
    where: a file, a face, a bend, or a JSON pointer into the request; "" for the whole input.
    places, numbers: what the message names, as data: docs/formats.md#places. remedy: an option and its
    value, or what to change; None if there is none.
    """

    code: str
    message: str
    where: str
    places: list[dict[str, Any]]
    numbers: dict[str, dict[str, Any]]
    remedy: dict[str, str] | None

    def __init__(self, code: str, message: str, where: str = "", data: Mapping[str, Any] = MappingProxyType({})) -> None:
        super().__init__(code, message, where)
        self.code, self.message, self.where = code, message, where
        self.places, self.numbers = data.get("places", []), data.get("numbers", {})
        self.remedy = data.get("remedy")

    def __str__(self) -> str:
        return f"{self.message} [{self.code}]" + (f" ({self.where})" if self.where else "")


class InvalidInput(Error, ValueError):
    """A file that cannot be read, is damaged, or breaks a rule of its format; a wrong option."""


class Refused(Error):
    """The input has no flat pattern, or none within the limits; or no order of strokes bends it.

    part: what is known all the same, with a report; None if that is nothing.
    """

    part: "Part | None" = None


class Cancelled(Error):
    """`progress` returned False."""


class Failed(Error, RuntimeError):
    """A defect of Planish or of its CAD kernel."""


def _worded(pieces: list[dict[str, Any]], pointer: str, name: str) -> str:
    """A message from its pieces, in which the pointer of an argument is the argument's name."""
    place = {"kind": "pointer", "id": pointer}
    return "".join(name if piece.get("place") == place else piece["text"] for piece in pieces)


_REFUSED, _WRONG_USE, _UNREADABLE = 4, 2, 3  # exit status of the program


def error_of(code: str, message: str, where: str, exit_status: int, reason: str = "{}") -> Error:
    """The exception for an error, by the exit status that the program has for it. `reason`: all of it as JSON."""
    data = json.loads(reason)
    option = "/options/"
    if where.startswith(option):  # an argument of a function
        name = where.removeprefix(option)
        message = _worded(data.get("wording") or [{"text": message}], where, name)
        where = name
    if code == "cancelled":
        return Cancelled(code, message, where, data)
    if exit_status == _REFUSED:
        return Refused(code, message, where, data)
    if exit_status in (_WRONG_USE, _UNREADABLE):
        return InvalidInput(code, message, where, data)
    return Failed(code, message, where, data)
