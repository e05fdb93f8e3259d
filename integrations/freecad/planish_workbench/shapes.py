"""Exact shapes of flat patterns: segments, arcs and Bézier splines as edges, contours as wires, patterns as faces."""

import math

import FreeCAD as App
import Part

FULL_TURN = 2 * math.pi
JOINED = 1e-5  # mm, between ends of neighbouring curves


def edge(curve):
    """The edge of a curve of `planish.Flat.curves()`."""
    if len(curve) == 4:
        return Part.makeLine(_point(curve[0:2]), _point(curve[2:4]))
    if len(curve) == 5:
        return _arc(*curve)
    poles = [_point(curve[i:i + 2]) for i in range(0, len(curve), 2)]
    pieces = (len(poles) - 1) // 3
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(poles, [4, *[3] * (pieces - 1), 4], list(range(pieces + 1)), False, 3)
    return spline.toShape()


def wire(contour):
    """The wire of curves that follow each other."""
    edges = [edge(curve) for curve in contour]
    try:
        joined = Part.Wire(edges)
        if len(joined.Edges) == len(edges):
            return joined
    except Part.OCCError:
        pass
    return Part.Wire(Part.sortEdges(edges, JOINED)[0])


def face(curves):
    """The pattern as a plane face with holes, seen from +z."""
    outer, openings = wire(curves["outer"]), [wire(one) for one in curves["openings"]]
    made = Part.Face([outer, *openings])
    if not made.isValid() or made.normalAt(0, 0).z < 0:
        made = Part.makeFace([outer, *openings], "Part::FaceMakerBullseye")
        made = made.Faces[0] if len(made.Faces) == 1 else made
    return made


def open_curves(contours):
    """Slits and outlines that are marked: a compound of edges."""
    return Part.makeCompound([edge(curve) for contour in contours for curve in contour])


def bend_lines(bends, direction):
    """The bend lines of a report that go up or down."""
    return Part.makeCompound([Part.makeLine(App.Vector(*start), App.Vector(*end))
                              for bend in bends if bend["direction"] == direction
                              for start, end in bend["lines"] if math.dist(start, end) > JOINED])


def read(content, suffix):
    """The shape in the bytes of a STEP file."""
    import os
    import tempfile

    with tempfile.TemporaryDirectory(prefix="planish-") as folder:
        path = os.path.join(folder, "shape." + suffix)
        with open(path, "wb") as stream:
            stream.write(content)
        shape = Part.Shape()
        shape.read(path)
    return shape.Solids[0] if len(shape.Solids) == 1 else shape


def _point(xy):
    return App.Vector(xy[0], xy[1], 0)


def _arc(x, y, radius, start, sweep):
    circle = Part.Circle(_point((x, y)), App.Vector(0, 0, 1), radius)
    if abs(sweep) >= FULL_TURN - 1e-12:
        whole = circle.toShape()
        return whole if sweep > 0 else whole.reversed()
    low, high = (start, start + sweep) if sweep > 0 else (start + sweep, start)
    arc = Part.ArcOfCircle(circle, low, high).toShape()
    return arc if sweep > 0 else arc.reversed()
