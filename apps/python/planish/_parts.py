"""What was made: reports, flat patterns, meshes, files."""

from __future__ import annotations

import json
import os
import pathlib
import secrets
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Optional

from . import _planish
from ._errors import InvalidInput, Refused, error_of
from ._inputs import Input, PathLike, options_of, request_of
from ._record import Record
from ._reports import BendKeys, FlatKeys, PartKeys, Report, ReportFlat, ReportFlatBend

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Integers = NDArray[np.int32]

#: Is told the stage and the share that is done, 0 to 1; False stops the work.
Listener = Optional[Callable[[str, float], Any]]

CHORD = 1e-3  # mm, between a curve and its polygon


class Bend(BendKeys):
    """A bend in the flat pattern: the keys of its report (id, angle, direction, …) and its lines."""

    def __init__(self, report: ReportFlatBend, lines: Floats) -> None:
        self.report = report
        #: (n, 4), float64: x0, y0, x1, y1 of each stretch of material along the bend line, or of each press line.
        self.lines: Floats = lines

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("__") or name == "report":
                raise AttributeError(name)
            return getattr(self.report, name)

    def __repr__(self) -> str:
        return f"<Bend {self.report['id']} {self.report['direction']} {self.report['angle']:g}°>"

    def to_dict(self) -> dict[str, Any]:
        """Its entry in the report."""
        return self.report.to_dict()


class Flat(FlatKeys):
    """A flat pattern, in the unit of the report. Arrays are views that keep the part alive; none can be written to.

    Polygons lie within `chord` mm of the curves; the first point is also the last.
    """

    def __init__(self, part: Part, piece: int, report: ReportFlat, chord: float = CHORD) -> None:
        self._part, self._piece, self.report, self.chord = part, piece, report, chord
        arrays = part._made.flat(piece, chord)
        #: (n, 2), float64, counter-clockwise.
        self.outline: Floats = arrays["outline"]
        #: Each (n, 2), clockwise.
        self.openings: list[Floats] = arrays["openings"]
        #: Cuts without width, each (n, 2).
        self.slits: list[Floats] = arrays["slits"]
        #: Outlines of forms that are drawn and not cut, each (n, 2).
        self.feature_outlines: list[Floats] = arrays["features"]
        #: By outline, the entry of `features` that it belongs to.
        self.feature_of: list[int] = arrays["feature_of"]
        self.bends = [Bend(row, lines) for row, lines in zip(report["bends"], arrays["bends"])]

    #: Of one skin, without openings; in square units.
    area: float = property(lambda self: self.report["area"])  # type: ignore[assignment]
    #: All cutting length.
    perimeter: float = property(lambda self: self.report["perimeter"])  # type: ignore[assignment]

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_") or name == "report":
                raise AttributeError(name)
            return getattr(self.report, name)

    def polygons(self, chord: float) -> Flat:
        """The same with polygons within `chord` mm of the curves."""
        if not chord > 0.0:
            raise InvalidInput("bad_option", f"the chord is {chord}; it must be above 0", "chord")
        return Flat(self._part, self._piece, self.report, chord)

    def curves(self) -> dict[str, Any]:
        """The exact curves, mm: "outer", "openings", "slits", "features".

        A segment is [x0, y0, x1, y1], an arc [x, y, radius, start, sweep] in radians, a cubic spline a list of points
        of Bézier pieces [x0, y0, x1, y1, …] that share their ends.
        """
        pattern: dict[str, Any] = json.loads(self._part._made.exact(self._piece))["pattern"]
        return {"outer": pattern["outer"], "openings": pattern["openings"], "slits": pattern["slits"],
                "features": [feature["outlines"] for feature in pattern["features"]]}

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """A polygon with holes, for shapely and others."""
        rings = [self.outline, *self.openings]
        return {"type": "Polygon", "coordinates": tuple(tuple(map(tuple, ring.tolist())) for ring in rings)}

    def to_dict(self) -> dict[str, Any]:
        """`flat` of the report."""
        return self.report.to_dict()

    def _repr_svg_(self) -> str:
        return _embedded(self._part._svg(self._piece))

    def __repr__(self) -> str:
        size = " × ".join(f"{length:g}" for length in self.report["size"])
        return f"<Flat {size}, {len(self.bends)} bends, {len(self.openings)} openings>"


class Mesh:
    """The folded part as triangles, mm."""

    def __init__(self, mesh: Any) -> None:
        #: (n, 3), float64.
        self.points: Floats = mesh.points
        #: (m, 3), int32: rows of `points`, counter-clockwise seen from outside.
        self.triangles: Integers = mesh.triangles

    def __repr__(self) -> str:
        return f"<Mesh {len(self.points)} points, {len(self.triangles)} triangles>"


class Part(PartKeys):
    """What was made for a request. The keys of its report are attributes: `part.sheet.thickness`, `part.checks`.

    status: "ok", "warning" or "refused".
    """

    def __init__(self, made: Any) -> None:
        self._made = made
        self._report: Report | None = None
        self._flats: list[Flat] | None = None

    @property
    def report(self) -> Report:
        """The report, as in docs/formats.md#report."""
        if self._report is None:
            self._report = Report(json.loads(self._made.report()))
        return self._report

    def to_dict(self) -> dict[str, Any]:
        """The report as a dictionary."""
        return self.report.to_dict()

    @property
    def flats(self) -> list[Flat]:
        """The flat pattern of each piece; most parts are one piece."""
        if self._flats is None:
            reports = [self.report] if self._made.pieces == 1 else list(self.report["pieces"])
            self._flats = [Flat(self, piece, report["flat"]) for piece, report in enumerate(reports)
                           if report["flat"] is not None and self._made.has_pattern(piece)]
        return self._flats

    @property
    def flat(self) -> Flat:
        """The flat pattern. Raises Refused if there is none; of several pieces see `flats`."""
        if len(self.flats) == 1:
            return self.flats[0]
        if self.flats:
            raise InvalidInput("bad_option", f"it is laid flat in {len(self.flats)} pieces: see `flats`", "flat")
        raise self._refusal() or Refused("unsupported_shape", "there is no flat pattern")

    def mesh(self) -> Mesh:
        """The folded part."""
        return Mesh(self._made.mesh())

    @property
    def formats(self) -> list[str]:
        """What `write` and `artifact` can write."""
        return list(self._made.artifacts())

    def artifact(self, format: str, **options: Any) -> bytes:
        """The bytes of a file, in one of `formats`. Options of the DXF may differ from those of the request."""
        files = self._files(format, options)
        if len(files) != 1:
            raise InvalidInput("bad_option", f"there are {len(files)} files, one for each piece: write them", "format")
        return files[0][1]

    def write(self, path: PathLike, *, format: str | None = None, **options: Any) -> list[pathlib.Path]:
        """Writes a file whole or not at all, by its suffix or as `format`; several pieces get numbers.

        Options of the DXF may differ from those of the request: `write("x.dxf", profile="inventor")`. Returns what was
        written.
        """
        path = pathlib.Path(path)
        return _write_pieces(path, [content for _, content in self._files(format or self._format_of(path), options)])

    def _format_of(self, path: pathlib.Path) -> str:
        suffix = path.suffix.lower().lstrip(".")
        if not suffix:
            raise InvalidInput("bad_option", f"{path} does not say what to write: end it in one of "
                               + ", ".join(f".{name}" for name in self.formats if "." not in name), str(path))
        return {"stp": "step"}.get(suffix, suffix)

    def _files(self, format: str, options: dict[str, Any]) -> list[tuple[str, bytes]]:
        if format == "json" and not options:
            return [("report.json", self._made.report().encode())]
        refusal = self._refusal()
        if refusal is not None:
            raise refusal
        return list(self._made.write(format, json.dumps(options_of(options))))

    def _svg(self, piece: int) -> str:
        return self._files("svg", {})[piece][1].decode()

    def _repr_svg_(self) -> str | None:
        return _embedded(self._svg(0)) if self.flats else None

    def _refusal(self) -> Exception | None:
        if self._made.refusal is None:
            return None
        error = error_of(*self._made.refusal)
        if isinstance(error, Refused):
            error.part = self
        return error

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            return getattr(self.report, name)

    def __repr__(self) -> str:
        name = self.report.get("body") or self.report["input"]
        return f"<{type(self).__name__} {name!r}, {self._made.status}>"


class BendPlan(Part):
    """A part with the order in which a press brake bends it: `plan.strokes`, `plan.status`."""

    def _files(self, format: str, options: dict[str, Any]) -> list[tuple[str, bytes]]:
        if format in ("pdf", "svg"):
            return [(f"plan.{format}", self._made.bend_pages(format == "svg"))]
        return super()._files(format, options)

    def write_as_made(self, path: PathLike) -> list[pathlib.Path]:
        """Writes the flat pattern for the inside radii that the plan's tools leave, as DXF; several pieces get numbers."""
        refusal = self._refusal()
        if refusal is not None:
            raise refusal
        return _write_pieces(pathlib.Path(path), self._made.flats_as_made())

    def _svg(self, piece: int) -> str:
        return super()._files("svg", {})[piece][1].decode()


def _write_pieces(path: pathlib.Path, contents: list[bytes]) -> list[pathlib.Path]:
    paths = [path] if len(contents) == 1 else [path.with_name(f"{path.stem}-{number}{path.suffix}")
                                               for number in range(1, len(contents) + 1)]
    _write_all(list(zip(paths, contents)))
    return paths


def _write_all(files: list[tuple[pathlib.Path, bytes]]) -> None:
    drafts: list[tuple[pathlib.Path, pathlib.Path]] = []
    try:
        for path, content in files:
            draft = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
            with open(draft, "xb") as stream:
                drafts.append((draft, path))
                stream.write(content)
        while drafts:
            os.replace(*drafts[0])
            del drafts[0]
    except OSError as failure:
        raise InvalidInput("cannot_write", f"{files[0][0]} cannot be written: {failure.strerror}",
                           str(files[0][0])) from failure
    finally:
        for draft, _ in drafts:
            draft.unlink()


def _embedded(svg: str) -> str:
    """The picture as a part of a page: without the declaration of XML."""
    return svg[svg.index("<svg"):]


def make(maker: str, given: Input, options: dict[str, Any], *, name: str | None, progress: Listener) -> Part:
    """Makes a part; raises what went wrong."""
    request, content = request_of(maker, given, options, name)
    return _checked(Part(_planish.make(request, content, progress)))


def plan(given: Input, options: dict[str, Any], *, name: str | None, progress: Listener) -> BendPlan:
    """Makes a part and the order of its bends; raises what went wrong."""
    request, content = request_of("bend", given, options, name)
    made = BendPlan(_planish.make(request, content, progress))
    _checked(made)
    return made


def _checked(part: Part) -> Part:
    refusal = part._refusal()
    if refusal is not None:
        raise refusal
    return part
