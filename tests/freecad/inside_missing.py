"""Runs in freecadcmd, without the package planish."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD as App
import inside
import planish_workbench

document = App.newDocument("missing")
box = document.addObject("Part::Box", "Box")
document.recompute()
try:
    planish_workbench.unfold(box)
    inside.store({"code": "nothing was raised"})
except planish_workbench.Missing as missing:
    inside.store({"code": missing.code, "message": str(missing), "objects": len(document.Objects)})
