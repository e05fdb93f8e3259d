"""What is selected, as shapes where they stand in the document: solids, plates, profiles."""

import Part

from .library import Refusal

STRAIGHT = 1e-7  # mm


def global_shape(source, name=""):
    """The shape of an object, or of a face or edge of it, where it stands: through links, bodies and App::Part."""
    if not hasattr(source, "Shape") and source.TypeId != "App::Part" and not hasattr(source, "LinkedObject"):
        raise Refusal("no_shape", f"{source.Label} has no shape: select a solid, a body or a part.", source.Name)
    shape = Part.getShape(source, name, needSubElement=bool(name))
    if shape.isNull():
        raise Refusal("no_shape", f"{source.Label} has no shape yet: recompute it first.", source.Name)
    parent = source.getParentGeoFeatureGroup()
    while parent is not None:
        shape = shape.copy(False) if hasattr(shape, "copy") else shape
        shape.Placement = parent.Placement.multiply(shape.Placement)
        parent = parent.getParentGeoFeatureGroup()
    return shape


def solid(source, number=1):
    """The solid of that number of an object, counted from 1."""
    shape = global_shape(source)
    solids = shape.Solids
    if not solids:
        raise Refusal("no_solid", f"{source.Label} is not a solid ({shape.ShapeType.lower()}): make a solid of it, for "
                      "example with Part > Create shape from mesh or Part > Convert to solid.", source.Name)
    if not 1 <= number <= len(solids):
        raise Refusal("no_such_body", f"{source.Label} has {len(solids)} solids; there is no number {number}.", source.Name)
    return solids[number - 1]


def element_names(source, number, kind, elements):
    """Names ("Face7", "Edge3") in the object of faces or edges of its solid, both counted from 1."""
    places = _places(source, number, kind)
    return [f"{kind}{places[one]}" for one in elements if one in places]


def element_numbers(source, number, kind, names):
    """Numbers in a solid of the object of its faces or edges of these names; those of other kinds are left out."""
    numbers = {f"{kind}{place}": one for one, place in _places(source, number, kind).items()}
    return [numbers[name] for name in names if name in numbers]


def _places(source, number, kind):
    """The number in the object of each face or edge of its solid, by its number there."""
    def elements(shape):
        return getattr(shape, f"{kind}s")

    shape = global_shape(source)
    solids = shape.Solids
    if not 1 <= number <= len(solids):
        return {}
    own = elements(solids[number - 1])
    if len(solids) == 1 and len(elements(shape)) == len(own):
        return {one: one for one in range(1, len(own) + 1)}
    places = {}
    for index, element in enumerate(elements(shape), 1):
        places.setdefault(element.hashCode(), []).append((index, element))
    return {one: index for one, element in enumerate(own, 1)
            for index, other in places.get(element.hashCode(), ()) if other.isSame(element)}


def leaves(document):
    """The objects of a document that stand for solids by themselves: no sources of others, nothing made by Planish."""
    taken = []
    for one in document.Objects:
        if getattr(getattr(one, "Proxy", None), "planish_kind", None):
            continue
        if one.TypeId in ("App::Part", "App::DocumentObjectGroup") or not hasattr(one, "Shape"):
            continue
        if one.isDerivedFrom("PartDesign::Feature") or one.isDerivedFrom("Sketcher::SketchObject"):
            continue
        users = [user for user in one.InList if not getattr(getattr(user, "Proxy", None), "planish_kind", None)
                 and user.TypeId not in ("App::Part", "App::DocumentObjectGroup", "App::Link")
                 and not user.isDerivedFrom("Sketcher::SketchObject")]
        if users or one.Shape.isNull() or not one.Shape.Solids:
            continue
        taken.append(one)
    return taken


def plates(links):
    """(id, outline, holes, normal) of each face or closed sketch in a list of (object, names), where they stand."""
    found = []
    for source, names in links:
        for name in (names if isinstance(names, (list, tuple)) else [names]) or [""]:
            shape = global_shape(source, name)
            faces = shape.Faces or _faces_of(shape, source)
            for index, face in enumerate(faces, 1):
                label = source.Name + (f".{name}" if name else "") + (f".{index}" if len(faces) > 1 else "")
                found.append((label, *_plate(face, source.Label + (f" {name}" if name else ""))))
    return found


def profile_wire(source, names):
    """The closed wire that is meant: of a sketch or another object, of a face, or of edges."""
    named = [name for name in names if name] if names else []
    label = source.Label + (" " + ", ".join(named) if named else "")
    pieces = [global_shape(source, name) for name in named] or [global_shape(source)]
    if len(pieces) == 1 and pieces[0].Faces:
        if len(pieces[0].Faces) > 1:
            raise Refusal("no_profile", f"{label} has {len(pieces[0].Faces)} faces: select one face or a sketch.", source.Name)
        return outer_wire(pieces[0].Faces[0])
    chains = Part.sortEdges([edge for piece in pieces for edge in piece.Edges])
    if len(chains) != 1:
        raise Refusal("no_profile", f"{label} has {len(chains)} contours; a transition goes from one closed contour to "
                      "another.", source.Name)
    wire = Part.Wire(chains[0])
    if not wire.isClosed():
        raise Refusal("no_profile", f"The contour of {label} is open: close it.", source.Name)
    return wire


def _faces_of(shape, source):
    wires = [wire for wire in shape.Wires if wire.isClosed()]
    if not wires:
        raise Refusal("no_plate", f"{source.Label} has no closed contour: a plate is a plane face or a closed sketch.",
                      source.Name)
    try:
        return Part.makeFace(wires, "Part::FaceMakerBullseye").Faces
    except Part.OCCError as failure:
        raise Refusal("no_plate", f"The contours of {source.Label} are not the border of a plane plate.",
                      source.Name) from failure


def _plate(face, label):
    if not isinstance(face.Surface, Part.Plane):
        raise Refusal("not_planar", f"{label} is curved: a plate is plane.", label)
    border = outer_wire(face)
    holes = [corners(wire) for wire in face.Wires if not wire.isSame(border)]
    return corners(border), holes, face.normalAt(0, 0)


def outer_wire(face):
    """The border round a plane face: the widest of its wires (FreeCAD 0.20 may name a hole as its OuterWire)."""
    return max(face.Wires, key=lambda wire: wire.BoundBox.DiagonalLength)


def corners(wire, deflection=0.05):
    """The corners of a closed wire; curves as chords within the deflection, mm. The first is not repeated."""
    found = []
    for edge in wire.OrderedEdges if hasattr(wire, "OrderedEdges") else wire.Edges:
        if isinstance(edge.Curve, Part.Line):
            points = [edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)]
        else:
            points = edge.discretize(Deflection=deflection)
        if edge.Orientation == "Reversed" and isinstance(edge.Curve, Part.Line):
            points.reverse()
        elif edge.Orientation == "Reversed" and (points[0] - edge.valueAt(edge.FirstParameter)).Length < STRAIGHT:
            points.reverse()
        found += points[:-1]
    return _without_straight(found)


def _without_straight(points):
    """Corners between collinear edges are none."""
    kept = []
    for index, point in enumerate(points):
        before, after = points[index - 1], points[(index + 1) % len(points)]
        way, on = point - before, after - point
        if way.Length > STRAIGHT and (on.Length <= STRAIGHT or way.cross(on).Length > STRAIGHT * (way.Length + on.Length)
                                      or way.dot(on) < 0):
            kept.append(point)
    return kept
