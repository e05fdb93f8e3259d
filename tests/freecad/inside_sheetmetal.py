"""Runs in freecadcmd: unfolds a part by Planish and, from its largest plane face, by the workbench SheetMetal."""

import json
import os
import sys
import types

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.environ["PLANISH_SHEETMETAL"])

import FreeCAD as App
import inside
import Part
import planish_workbench

K = 0.44
AT_HALF = 0.5  # where the pattern times the thickness is the volume of the part

if not hasattr(App.Base, "Precision"):  # FreeCAD 0.20: Open CASCADE's own values
    App.Base.Precision = types.SimpleNamespace(approximation=lambda: 1e-6, confusion=lambda: 1e-7, angular=lambda: 1e-12)
try:
    import SheetMetalNewUnfolder as unfolder
except Exception as error:
    inside.store({"missing": repr(error)})


def is_plane(face):
    return face.Surface.TypeId == "Part::GeomPlane"


def by_sheetmetal(source, k_factor):
    """The flat solid, from the plane face that a user would choose."""
    faces = source.Shape.Faces
    number = max((i for i, face in enumerate(faces) if is_plane(face)), key=lambda i: faces[i].Area)
    allowance = unfolder.BendAllowanceCalculator.from_single_value(k_factor, "ansi")
    return unfolder.getUnfold(allowance, source, f"Face{number + 1}")[1]


shape = Part.Shape()
shape.read(os.environ["PLANISH_PART"])
result = {"solids": len(shape.Solids)}
if len(shape.Solids) == 1:
    source = App.newDocument("part").addObject("Part::Feature", "Source")
    source.Shape = shape
    try:
        flat = by_sheetmetal(source, K)
        area = max(face.Area for face in flat.Faces if is_plane(face))
        result["sheetmetal"] = {"area": area, "valid": flat.isValid(), "filled": by_sheetmetal(source, AT_HALF).Volume / shape.Volume}
    except Exception as error:
        result["sheetmetal_reason"] = repr(error)
    try:
        flat = planish_workbench.unfold(source, k_factor=K)
        report = json.loads(flat.Report)
        result["planish"] = {"area": flat.Shape.Area, "bends": len(report["flat"]["bends"])}
    except Exception as error:
        result["planish_reason"] = getattr(error, "code", repr(error))
inside.store(result)
