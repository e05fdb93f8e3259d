"""Runs in freecadcmd: unfolds real parts of one solid in documents of their own."""

import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD as App
import inside
import Part
import planish_workbench

MOST = int(os.environ.get("PLANISH_MOST", "60"))
made = []
for path in sorted(pathlib.Path(os.environ["PLANISH_PARTS"]).glob("*.step")):
    if len(made) == MOST or path.stat().st_size > 2_000_000:
        continue
    shape = Part.Shape()
    shape.read(str(path))
    if len(shape.Solids) != 1:
        continue
    document = App.newDocument("part")
    source = document.addObject("Part::Feature", "Source")
    source.Shape = shape
    try:
        flat = planish_workbench.unfold(source, k_factor=0.44)
        made.append({"file": path.name, "area": flat.Shape.Area, "report": flat.Area.Value, "valid": flat.Shape.isValid(),
                     "holes": sum(len(face.Wires) - 1 for face in flat.Shape.Faces)})
    except Exception as error:
        made.append({"file": path.name, "code": getattr(error, "code", repr(error))})
    App.closeDocument(document.Name)
inside.store(made)
