"""Runs in freecadcmd: unfolds real parts of one solid in documents of their own."""

import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD as App
import inside
import Part
import planish_workbench

MOST = int(os.environ.get("PLANISH_MOST", "50"))
NO_SHEETS = 8  # besides
made, counts = [], {True: 0, False: 0}
for path in sorted(pathlib.Path(os.environ["PLANISH_PARTS"]).glob("*.step")):
    sheet = not path.name.startswith("neg")
    if counts[sheet] == (MOST if sheet else min(MOST, NO_SHEETS)) or path.stat().st_size > 2_000_000:
        continue
    shape = Part.Shape()
    shape.read(str(path))
    if len(shape.Solids) != 1:
        continue
    counts[sheet] += 1
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
