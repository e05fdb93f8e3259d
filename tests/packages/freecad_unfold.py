"""Runs within FreeCAD: an angle is unfolded by the workbench."""

import FreeCAD
import Part
import planish_workbench

document = FreeCAD.newDocument("angle")


def rounded(shape, y, z, radius):
    """The edge along x at that place is rounded."""
    edges = [edge for edge in shape.Edges if edge.Length > 59
             and abs(edge.CenterOfMass.y - y) + abs(edge.CenterOfMass.z - z) < 1e-6]
    return shape.makeFillet(radius, edges)


angle = Part.makeBox(60, 40, 30).cut(Part.makeBox(60, 40, 30, FreeCAD.Vector(0, 2, 2)))
body = document.addObject("Part::Feature", "Angle")
body.Shape = rounded(rounded(angle, 2, 2, 2), 0, 0, 4)
flat = planish_workbench.unfold(body, k_factor=0.5)
print("flat area", flat.Shape.Area, "K", flat.KFactor, flush=True)
