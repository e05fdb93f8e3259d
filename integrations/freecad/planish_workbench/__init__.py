"""Planish in FreeCAD.

    import planish_workbench
    flat = planish_workbench.unfold(App.ActiveDocument.Body, k_factor=0.44)
    print(flat.Shape.Area, flat.Report)

Objects are parametric: they follow their sources. Lengths are mm. docs/freecad.md.
"""

from .library import Missing, Refusal
from .make import bend_plan, connect, sketch, transition, unfold, unfold_document, write

__all__ = ["Missing", "Refusal", "bend_plan", "connect", "sketch", "transition", "unfold", "unfold_document", "write"]
