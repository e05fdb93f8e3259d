"""Closed wires as profiles of a transition (planish/transition), each in a frame of its own."""

import math

import FreeCAD as App
import Part

from . import sources
from .library import Refusal

SAME = 1e-6  # mm and radians: lengths and directions that are drawn alike
SPLINE_POINTS = 96  # through which a smooth closed curve is handed over


def end(wire, label):
    """{"profile", "frame"}, and the frame's origin and normal."""
    kind, values, origin, x, normal = _profile(wire, label)
    frame = {"origin": list(origin), "x": list(x), "normal": list(normal)}
    return {"profile": {kind: values}, "frame": frame}


def turned_alike(start, finish):
    """The second end with its normal on the side on which the way from the first goes on."""
    a, b = (App.Vector(*one["frame"]["normal"]) for one in (start, finish))
    way = App.Vector(*finish["frame"]["origin"]) - App.Vector(*start["frame"]["origin"])
    return _turned(start, a.dot(way) < 0), _turned(finish, b.dot(way) < 0 if abs(b.dot(way)) > SAME else a.dot(b) < 0)


def _turned(one, other_way):
    """The same profile, looked at from the other side: y becomes −y."""
    if not other_way:
        return one
    (kind, values), = one["profile"].items()
    if kind in ("polygon", "spline"):
        values = [[x, -y] for x, y in values]
    frame = dict(one["frame"], normal=[-value for value in one["frame"]["normal"]])
    return {"profile": {kind: values}, "frame": frame}


def _profile(wire, label):
    edges = wire.OrderedEdges if hasattr(wire, "OrderedEdges") else wire.Edges
    normal = _normal(wire, label)
    curves = [edge.Curve for edge in edges]
    if len(edges) == 1 and isinstance(curves[0], Part.Circle):
        circle = curves[0]
        return "circle", {"radius": circle.Radius}, circle.Center, circle.XAxis, normal
    if len(edges) == 1 and isinstance(curves[0], Part.Ellipse):
        ellipse = curves[0]
        return "ellipse", {"rx": ellipse.MajorRadius, "ry": ellipse.MinorRadius}, ellipse.Center, ellipse.XAxis, normal
    if all(isinstance(curve, Part.Line) for curve in curves):
        points = sources.corners(wire)
        origin = wire.CenterOfMass
        x = (points[1] - points[0]).normalize()
        return "polygon", _local(points, origin, x, normal), origin, x, normal
    if all(isinstance(curve, (Part.Line, Part.Circle)) for curve in curves):
        rounded = _rounded(edges, normal)
        if rounded is not None:
            return rounded
    if len(edges) == 1 and not isinstance(curves[0], (Part.Line, Part.Circle)):
        points = edges[0].discretize(Number=SPLINE_POINTS + 1)[:-1]
        origin = wire.CenterOfMass
        x = (points[0] - origin).normalize()
        return "spline", _local(points, origin, x, normal), origin, x, normal
    raise Refusal("no_profile", f"{label} is none of the profiles of a transition: a polygon, a circle, an ellipse, a rectangle "
                  "with rounded corners, an obround, or one smooth closed spline.", label)


def _rounded(edges, normal):
    """A rectangle with four arcs of one radius, or two lines and two half circles."""
    lines = [edge for edge in edges if isinstance(edge.Curve, Part.Line)]
    arcs = [edge for edge in edges if isinstance(edge.Curve, Part.Circle)]
    radius = arcs[0].Curve.Radius
    if any(abs(arc.Curve.Radius - radius) > SAME for arc in arcs):
        return None
    if (len(lines), len(arcs)) not in ((4, 4), (2, 2)):
        return None
    turn = math.pi / (len(arcs) // 2 if len(arcs) == 4 else 1)
    if any(abs(arc.Length - radius * turn) > SAME * max(1.0, radius) for arc in arcs):
        return None
    along = sorted(lines, key=lambda line: -line.Length)[0]
    x = (along.valueAt(along.LastParameter) - along.valueAt(along.FirstParameter)).normalize()
    y = normal.cross(x)
    for line in lines:
        way = (line.valueAt(line.LastParameter) - line.valueAt(line.FirstParameter)).normalize()
        if min(abs(way.dot(x)), abs(way.dot(y))) > SAME:
            return None
    if any(not _tangent(arc, x, y) for arc in arcs):
        return None
    centres = [arc.Curve.Center for arc in arcs]
    origin = sum(centres, App.Vector()) * (1 / len(centres))
    width = 2 * (max(abs((centre - origin).dot(x)) for centre in centres) + radius)
    height = 2 * (max(abs((centre - origin).dot(y)) for centre in centres) + radius)
    if len(arcs) == 2:
        return "obround", {"length": width, "width": height}, origin, x, normal
    return "rounded_rectangle", {"width": width, "height": height, "radius": radius}, origin, x, normal


def _tangent(arc, x, y):
    """Whether an arc begins and ends along x or y."""
    tangents = [arc.tangentAt(parameter) for parameter in (arc.FirstParameter, arc.LastParameter)]
    return all(min(abs(tangent.dot(x)), abs(tangent.dot(y))) <= SAME for tangent in tangents)


def _normal(wire, label):
    try:
        face = Part.Face(wire)
    except Part.OCCError as failure:
        raise Refusal("not_planar", f"{label} does not lie in a plane, or crosses itself.", label) from failure
    return face.normalAt(0, 0)


def _local(points, origin, x, normal):
    y = normal.cross(x)
    return [[(point - origin).dot(x), (point - origin).dot(y)] for point in points]
