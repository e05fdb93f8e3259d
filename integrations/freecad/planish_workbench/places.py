"""Findings as rows, and the faces of the solid that a row means.

A finding names faces among its places, or they follow from points of the flat pattern: a flange of the pattern is the face
of the solid with its area, outline and edges. Where several faces are congruent, all of them are meant.
"""

import dataclasses
import json
import os
import tempfile

import FreeCAD as App
import Part

from . import sources
from .library import planish

ALIKE = 1e-3  # mm, and relative for areas: between a face and its image
MARGIN = 1e-3  # mm, by which strips of bends reach beyond their lines


@dataclasses.dataclass
class Row:
    """One finding: severity, sentence, points of the flat pattern, places (docs/formats.md#places)."""

    severity: str
    message: str
    at: list
    places: list = dataclasses.field(default_factory=list)


def rows(made):
    """The findings of an object; if it could not be made, why."""
    if made.Problem:
        return [Row("error", made.Problem, [], json.loads(made.Places or "[]"))]
    report = json.loads(made.Report) if made.Report else {}
    found = []
    for one in report.get("pieces") or [report]:
        for check in one.get("checks", ()):
            if "count" in check:  # a rule, with the places where it is broken
                found += [Row(place["severity"], place["message"], place["points"], [place])
                          for place in check["places"]]
            else:
                found.append(Row(check["severity"], check["message"], check["at"], check["places"]))
        found += [Row("info", note, []) for note in one.get("notes", ())]
    return found


def faces(made, row):
    """Names ("Face7") of the source's faces that a finding means."""
    source = getattr(made, "Source", None)
    if source is None:
        return []
    numbers = named(row.places, "face")
    if not numbers and row.at and hasattr(made, "Flat"):
        numbers = faces_at(sources.solid(source, made.Body), made.Flat, json.loads(made.Report)["flat"]["bends"], row.at,
                           made.Thickness.Value)
    return sources.element_names(source, made.Body, "Face", sorted(set(numbers)))


def named(places, kind):
    """The numbers of the faces ("face") or edges ("edge") among places."""
    return sorted({place["id"] for place in places if place["kind"] == kind})


def faces_at(solid, flat, bends, points, thickness):
    """Numbers, from 1, of the flanges' faces, on both skins, that lie at points of the flat pattern."""
    candidates = [(number, solid.Faces[number - 1]) for number in flange_faces(solid)]
    regions = flanges(flat, bends)
    found = []
    for point in (App.Vector(*point, 0) for point in points):
        meant = [one for one in regions if _covers(one, point)] or \
                [one for one in regions if _covers(Part.Face(sources.outer_wire(one)), point)]  # in an opening
        for number in (number for region in meant for number, face in candidates if congruent(region, face)):
            found += [number, *_other_skin(solid, number, thickness)]
    return found


def flanges(flat, bends):
    """The flat pattern without the strips of its bends: a face for each flange."""
    strips = [_strip(bend, line) for bend in bends for line in bend["lines"] if line and line[0] != line[1]]
    return (flat.cut(strips) if strips else flat).Faces


def flange_faces(solid):
    """The faces of the flanges, on the skin that is unfolded: as `planish info --sheets` lists them."""
    with tempfile.TemporaryDirectory(prefix="planish-") as folder:
        path = os.path.join(folder, "solid.brep")
        solid.exportBrep(path)
        body, = planish().info(path, sheets=True).to_dict()["bodies"]
    return [face["number"] for face in body["sheet"].get("flange_faces", ())]


def congruent(region, face):
    """Whether two plane faces have the same area and edges."""
    if abs(region.Area - face.Area) > ALIKE * max(1.0, face.Area) or len(region.Wires) != len(face.Wires):
        return False
    lengths = [sorted(wire.Length for wire in one.Wires) for one in (region, face)]
    return all(abs(a - b) <= ALIKE * max(1.0, b) for a, b in zip(*lengths))


def _other_skin(solid, number, thickness):
    """The face behind a face."""
    face = solid.Faces[number - 1]
    behind = face.CenterOfMass - face.normalAt(0, 0) * thickness
    return [other for other, one in enumerate(solid.Faces, 1)
            if other != number and (one.CenterOfMass - behind).Length <= ALIKE and congruent(one, face)]


def _covers(face, point):
    return face.distToShape(Part.Vertex(point))[0] <= ALIKE


def _strip(bend, line):
    """The bend zone about a stretch of a bend line."""
    start, end = (App.Vector(*point, 0) for point in line)
    along = (end - start).normalize()
    across = App.Vector(-along.y, along.x, 0) * (bend["allowance"] / 2)
    start, end = start - along * MARGIN, end + along * MARGIN
    corners = [start - across, end - across, end + across, start + across]
    return Part.Face(Part.makePolygon([*corners, corners[0]]))
