"""Exact shapes of flat patterns: segments, arcs and Bézier splines as edges, contours as wires, patterns as faces."""

import math
import os
import tempfile

import FreeCAD as App
import Part

FULL_TURN = 2 * math.pi
JOINED = 1e-5  # mm, between ends of neighbouring curves
FITTED = 1e-4  # mm: to this splines are fitted; what is shorter than twice that is noise of the fit, and turns to and fro


def edges(curve):
    """The edges of a curve of `planish.Flat.curves()`: one, or as many as a spline has pieces."""
    if len(curve) == 4:
        return [Part.makeLine(_point(curve[0:2]), _point(curve[2:4]))]
    if len(curve) == 5:
        return [_arc(*curve)]
    return _pieces([_point(curve[i:i + 2]) for i in range(0, len(curve), 2)])


def wire(contour):
    """The wire of curves that follow each other."""
    chain = [edge for curve in contour for edge in edges(curve)]
    try:
        joined = Part.Wire(chain)
        if len(joined.Edges) == len(chain):
            return joined
    except Part.OCCError:
        pass
    return Part.Wire(Part.sortEdges(chain, JOINED)[0])


def face(curves):
    """The pattern as a plane face with holes, seen from +z."""
    outer, openings = wire(curves["outer"]), [wire(one) for one in curves["openings"]]
    made = Part.Face([outer, *openings])
    if not made.isValid() or made.normalAt(0, 0).z < 0:
        made = Part.makeFace([outer, *openings], "Part::FaceMakerBullseye")
        made = made.Faces[0] if len(made.Faces) == 1 else made
    return made


def open_curves(contours):
    """Slits, each one curve, and outlines that are marked: a compound of edges."""
    curves = [curve for one in contours for curve in ([one] if isinstance(one[0], (int, float)) else one)]
    return Part.makeCompound([edge for curve in curves for edge in edges(curve)])


def bend_lines(bends, direction):
    """The bend lines of a report that go up or down."""
    return Part.makeCompound([Part.makeLine(App.Vector(*start), App.Vector(*end))
                              for bend in bends if bend["direction"] == direction
                              for start, end in bend["lines"] if math.dist(start, end) > JOINED])


def folded(part):
    """The bent solid of a part of planish; of several pieces a compound."""
    with tempfile.TemporaryDirectory(prefix="planish-") as folder:
        pieces = [_read(path) for path in part.write(os.path.join(folder, "shape.step"))]
    return pieces[0] if len(pieces) == 1 else Part.makeCompound(pieces)


def _read(path):
    shape = Part.Shape()
    shape.read(str(path))
    return shape.Solids[0] if len(shape.Solids) == 1 else shape


def _point(xy):
    return App.Vector(xy[0], xy[1], 0)


def _pieces(poles):
    """Bézier pieces as edges: the kernel measures areas beside a spline of many pieces to three digits only.

    Pieces that are noise are left out; where one is missing its neighbours meet.
    """
    kept, end = [], poles[0]
    for piece in (poles[i:i + 4] for i in range(0, len(poles) - 1, 3)):
        if max((pole - end).Length for pole in piece) > 2 * FITTED:
            kept.append([end, *piece[1:]])
            end = piece[3]
    if not kept:
        return [Part.makeLine(poles[0], poles[-1])]
    kept[-1][3] = poles[-1]
    return [_bezier(piece) for piece in kept]


def _bezier(poles):
    curve = Part.BezierCurve()
    curve.setPoles(poles)
    return curve.toShape()


def _arc(x, y, radius, start, sweep):
    circle = Part.Circle(_point((x, y)), App.Vector(0, 0, 1), radius)
    if abs(sweep) >= FULL_TURN - 1e-12:
        whole = circle.toShape()
        return whole if sweep > 0 else whole.reversed()
    low, high = (start, start + sweep) if sweep > 0 else (start + sweep, start)
    arc = Part.ArcOfCircle(circle, low, high).toShape()
    return arc if sweep > 0 else arc.reversed()
