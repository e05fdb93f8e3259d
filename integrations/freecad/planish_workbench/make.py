"""The functions for macros, which the commands call too."""

import os
import tempfile

import FreeCAD as App
import Part

from . import features, preferences, shapes, sources
from .library import Refusal, planish

LABELS = {"Flat": "net", "BendsUp": "bends up", "BendsDown": "bends down", "Slits": "slits", "Forms": "forms"}
SAME = 1e-6  # relative, for solids that may be alike
BESIDE = 20.0  # mm


def unfold(source, k_factor=None, *, k_table=None, shop=None, body=1, up="auto", relief="rip", bend_relief="none", extruded="pilot",
           rip_edges=(), beside=False):
    """Lays a solid flat: a document object with `Shape` (the plane face), `KFactor`, `Report` and the other results.

    source: an object with a solid, a body, a part or a link. body: which of its solids, from 1. rip_edges: numbers of its
    edges, from 1, along which a closed one is cut open. beside: puts the pattern beside the solid; otherwise it lies at the
    origin. Raises what planish raises (`code`, `message`, `where`; faces are
    those of the solid, from 1), and Refusal. Then the document is as it was.
    """
    def set_up(made):
        made.Source, made.Body, made.Up, made.Relief, made.Extruded = source, body, up, relief, extruded
        made.BendRelief = bend_relief
        made.RipEdges = ",".join(map(str, rip_edges))
        _bending(made, k_factor, k_table, shop)

    made = _made(source.Document, "Part::FeaturePython", "Unfold", features.Unfold, set_up, f"{source.Label} flat")
    if beside:
        _beside(made, sources.solid(source, body).BoundBox)
    _draw(made, made)
    return made


def unfold_document(document, k_factor=None, **options):
    """Unfolds each different solid of a document once. Returns the objects, and (object, body, error) for those refused."""
    library = planish()
    known, made, refused = [], [], []
    for source in sources.leaves(document):
        for body, solid in enumerate(sources.global_shape(source).Solids, 1):
            if any(_alike(solid, other) for other in known):
                continue
            known.append(solid)
            try:
                made.append(unfold(source, k_factor, body=body, **options))
            except (library.Error, Refusal) as error:
                refused.append((source, body, error))
    if not known:
        raise Refusal("no_solid", f"{document.Label} has no solids.")
    return made, refused


def connect(plates, thickness, *, inside_radius=0.0, faces_are="middle", lateral="auto", k_factor=None, k_table=None, shop=None):
    """Joins plates by bends: a document object with the bent solid as `Shape`, `Flat` and `Report`; its net is beside it.

    plates: objects, or (object, "Face3") or (object, ["Face3", …]). Raises as `unfold`.
    """
    links = [(one, [""]) if not isinstance(one, (list, tuple)) else
             (one[0], list(one[1]) if isinstance(one[1], (list, tuple)) else [one[1]]) for one in plates]
    if not links:
        raise Refusal("no_plates", "Select the faces or closed sketches that are the plates.")

    def set_up(made):
        made.Plates, made.SheetThickness, made.InsideRadius = links, thickness, inside_radius
        made.FacesAre, made.Lateral, made.Frames = faces_are, lateral, _frames(one for one, _ in links)
        _bending(made, k_factor, k_table, shop)

    made = _made(links[0][0].Document, "Part::FeaturePython", "Connect", features.Connect, set_up, "Bent plate")
    _net(made)
    return made


def transition(start, finish, thickness, *, sizes_are="mid", pieces="1", press_angle=10.0, seam_edge=-1, k_factor=0.5):
    """A developable shape between two closed profiles: `Shape`, `Flat`, `Report`; its net is beside it.

    start, finish: sketches, wires or (object, "Face3"). Raises as `unfold`.
    """
    ends = [one if isinstance(one, (list, tuple)) else (one, [""]) for one in (start, finish)]

    def set_up(made):
        made.From, made.To = ((one, [names] if isinstance(names, str) else list(names)) for one, names in ends)
        made.Frames = _frames(one for one, _ in ends)
        made.SheetThickness, made.SizesAre, made.Pieces = thickness, sizes_are, str(pieces)
        made.PressAngle, made.SeamEdge, made.KFactor = press_angle, seam_edge, k_factor

    made = _made(ends[0][0].Document, "Part::FeaturePython", "Transition", features.Transition, set_up, "Transition")
    _net(made)
    return made


def bend_plan(source, k_factor=None, *, body=1, metal="", tools="", k_table=None, shop=None):
    """The order of strokes for a press brake: a document object with `Strokes` and `Report`. Raises as `unfold`."""
    def set_up(made):
        made.Source, made.Body, made.Metal, made.Tools = source, body, metal, tools
        _bending(made, k_factor, k_table, shop)

    return _made(source.Document, "App::FeaturePython", "BendPlan", features.BendPlan, set_up, f"{source.Label} bend plan")


def write(made, path, **options):
    """Writes what was made by the suffix of the path: .dxf, .svg, .pdf, .step, .json. Returns the paths."""
    if str(path).lower().endswith(".dxf") and "profile" not in options and not getattr(made, "Shop", ""):
        options["profile"] = preferences.profile()
    return made.Proxy.current(made).write(path, **options)


def sketch(made):
    """A sketch of the flat pattern where it lies: contours, and bend lines as construction lines."""
    import Sketcher

    pattern = pattern_of(made)
    drawn = made.Document.addObject("Sketcher::SketchObject", "FlatSketch")
    drawn.Label = f"{made.Label} sketch"
    drawn.Placement = pattern.Placement
    first = 0
    for flat in made.Proxy.current(made).flats:
        curves = flat.curves()
        for contour in [curves["outer"], *curves["openings"]]:
            geometry = [_geometry(edge) for curve in contour for edge in shapes.edges(curve)]
            drawn.addGeometry(geometry, False)
            if len(geometry) > 1:
                drawn.addConstraint([_joint(Sketcher, geometry, first, i) for i in range(len(geometry))])
            first += len(geometry)
        for bend in flat.to_dict()["bends"]:
            lines = [Part.LineSegment(App.Vector(*a), App.Vector(*b)) for a, b in bend["lines"]]
            drawn.addGeometry(lines, True)
            first += len(lines)
    return drawn


def pattern_of(made):
    """The object that shows the flat pattern of another."""
    for one in made.InList:
        if getattr(one, "What", "") == "Flat" and one.Owner == made:
            return one
    return made


def _made(document, kind, name, proxy, set_up, label):
    """A new object that was made once; an error leaves none behind."""
    planish()
    made = document.addObject(kind, name)
    try:
        proxy(made)
        made.Label = label
        set_up(made)
        made.Proxy.update(made)
    except BaseException:
        document.removeObject(made.Name)
        raise
    made.purgeTouched()
    _attach(made)
    return made


def _draw(owner, pattern):
    """Objects for the lines of a pattern that there are."""
    for what in features.PARTS_OF_PATTERN[1:]:
        if what.startswith("Bends") or not getattr(owner, what).isNull():
            _drawn(owner, what, pattern)


def _net(made):
    net = _drawn(made, "Flat", None)
    _beside(net, made.Shape.BoundBox)
    _draw(made, net)


def _drawn(owner, what, beside):
    drawn = owner.Document.addObject("Part::FeaturePython", what)
    features.Drawn(drawn)
    drawn.Owner, drawn.What, drawn.Beside = owner, what, beside
    drawn.Label = f"{owner.Label} {LABELS[what]}"
    drawn.Proxy.update(drawn)
    drawn.purgeTouched()
    _attach(drawn)
    return drawn


def _attach(made):
    if App.GuiUp:
        from .gui import view

        view.attach(made)


def _beside(made, box):
    flat = made.Shape.BoundBox
    made.Placement = App.Placement(App.Vector(box.XMax + BESIDE - flat.XMin, box.YMin - flat.YMin, box.ZMin), App.Rotation())
    made.purgeTouched()


def _bending(made, k_factor, k_table, shop):
    given = k_factor is not None
    made.KFactor = k_factor if given else preferences.k_factor()
    if given and not 0 <= k_factor <= 1:
        raise Refusal("bad_option", f"The K-factor is {k_factor:g}; it must lie between 0 and 1.", "k_factor")
    made.KTable = k_table if k_table is not None else "" if given else preferences.k_table()
    made.Shop = shop if shop is not None else "" if given else preferences.shop()


def _frames(objects):
    found = []
    for one in objects:
        parent = one.getParentGeoFeatureGroup()
        while parent is not None:
            if parent not in found:
                found.append(parent)
            parent = parent.getParentGeoFeatureGroup()
    return found


def _alike(one, other):
    """Whether planish counts two solids as one body."""
    if len(one.Faces) != len(other.Faces) or len(one.Edges) != len(other.Edges):
        return False
    if abs(one.Volume - other.Volume) > SAME * abs(one.Volume) or abs(one.Area - other.Area) > SAME * one.Area:
        return False
    with tempfile.TemporaryDirectory(prefix="planish-") as folder:
        path = os.path.join(folder, "two.brep")
        Part.makeCompound([one, other]).exportBrep(path)
        return len(planish().info(path).bodies) == 1


def _geometry(edge):
    curve = edge.Curve
    if isinstance(curve, Part.Line):
        return Part.LineSegment(*(vertex.Point for vertex in edge.Vertexes))
    if isinstance(curve, Part.BezierCurve):
        return curve.toBSpline()
    return curve if edge.isClosed() else Part.ArcOfCircle(curve, edge.FirstParameter, edge.LastParameter)


def _joint(sketcher, geometry, first, index):
    """The end of a curve on the start of the next; arcs run counter-clockwise whichever way the contour does."""
    following = (index + 1) % len(geometry)
    a, b = geometry[index], geometry[following]
    end = _nearest(a, b)
    return sketcher.Constraint("Coincident", first + index, end, first + following, _nearest(b, a, a, end))


def _nearest(curve, other, against=None, end=None):
    """1 for the start of a curve, 2 for its end: the one that meets the other curve."""
    ends = [curve.StartPoint, curve.EndPoint]
    points = [other.StartPoint, other.EndPoint] if end is None else [[against.StartPoint, against.EndPoint][end - 1]]
    if end is None and len({round((p - q).Length < 1e-6) for p in ends for q in points}) == 1:
        return 2
    return 1 + min(range(2), key=lambda i: min((ends[i] - point).Length for point in points))
