"""The parametric objects. Each is a proxy that makes a part of planish again whenever its sources change.

A recompute that fails keeps the shape as it was; FreeCAD marks the object, `Problem` holds the sentence and `Code` its word.
"""

import json
import os

import FreeCAD as App
import Part

from . import profiles, shapes, sources
from .library import Refusal, planish, sentence

READ_ONLY = 1  # of a property's editor
HIDDEN = 2
GAP = 20.0  # mm, between the patterns of several pieces

UP = ["auto", "reference", "other"]
RELIEF = ["rip", "square", "round", "none"]
BEND_RELIEF = ["none", "square", "round"]
EXTRUDED = ["pilot", "through", "outline"]
FACES_ARE = ["middle", "skin"]
SIZES_ARE = ["mid", "inside", "outside"]
PIECES = ["1", "2", "per_side"]
LATERAL = ["auto", "straight", "arc", "corner"]
METAL = ["", "steel", "stainless", "aluminium"]

BENDING = [
    ("App::PropertyFloatConstraint", "KFactor", "K-factor of every bend: where the neutral line lies, in thicknesses from the "
     "inside; not used with a bend table", (0.44, 0.0, 1.0, 0.01)),
    ("App::PropertyFile", "KTable", "Bend table (CSV): columns r/t, or r and t in mm, and k, ba or bd", ""),
    ("App::PropertyFile", "Shop", "Shop profile (JSON): radius and K of stocked materials, layers, limits", ""),
]
SOLID = [
    ("App::PropertyLinkGlobal", "Source", "The object with the solid", None),
    ("App::PropertyInteger", "Body", "Which of its solids, from 1", 1),
]
RESULTS = [
    ("App::PropertyString", "Report", "The report as JSON (docs/formats.md)", ""),
    ("App::PropertyString", "Status", "ok, warning or refused", ""),
    ("App::PropertyString", "Problem", "Why it could not be made again", ""),
    ("App::PropertyString", "Code", "The same as one word", ""),
    ("App::PropertyString", "Where", "The place in the source, such as a face", ""),
    ("App::PropertyString", "Places", "The same as JSON (docs/formats.md#places)", ""),
]
PATTERN = [
    ("App::PropertyLength", "Thickness", "Of the sheet", 0.0),
    ("App::PropertyArea", "Area", "Of the flat pattern, without openings", 0.0),
    ("App::PropertyInteger", "Bends", "How many", 0),
]
PARTS_OF_PATTERN = ["Flat", "BendsUp", "BendsDown", "Slits", "Forms"]


class Proxy:
    """What FreeCAD wants of a proxy; nothing of it is stored beyond its class."""

    planish_kind = ""
    inputs = []
    results = RESULTS
    hidden = []

    def __init__(self, document_object):
        document_object.Proxy = self
        self.part = None
        self.complete(document_object)

    def complete(self, document_object):
        """Adds the properties that an object lacks: a new one, or one of an earlier version."""
        for group, table in (("Planish", self.inputs), ("Result", self.results), ("Result", self.hidden)):
            for kind, name, help_text, value in table:
                if name not in document_object.PropertiesList:
                    document_object.addProperty(kind, name, group, help_text)
                    if value is not None:
                        setattr(document_object, name, value)
                if table is self.results:
                    document_object.setEditorMode(name, READ_ONLY)
                elif table is self.hidden:
                    document_object.setEditorMode(name, HIDDEN)

    def onDocumentRestored(self, document_object):
        self.part = None
        self.complete(document_object)

    def dumps(self):
        return None

    def loads(self, state):
        self.part = None

    __getstate__ = dumps  # FreeCAD before 0.22
    __setstate__ = loads

    def execute(self, document_object):
        """Called by FreeCAD, which shows the sentence at the object."""
        try:
            self.update(document_object)
        except Exception as error:
            raise RuntimeError(sentence(error)) from None

    def update(self, document_object):
        """Makes it again. Raises what planish raises."""
        try:
            self.part = self.made(document_object)
            self.show(document_object, self.part)
        except Exception as error:
            self.part = None
            document_object.Problem = sentence(error)
            document_object.Code = getattr(error, "code", "internal")
            document_object.Where = getattr(error, "where", "")
            document_object.Places = json.dumps(getattr(error, "places", []), ensure_ascii=False)
            document_object.Status = "refused"
            raise
        document_object.Problem = document_object.Code = document_object.Where = document_object.Places = ""

    def made(self, document_object):
        raise NotImplementedError

    def show(self, document_object, part):
        report = part.to_dict()
        document_object.Report = json.dumps(report, ensure_ascii=False)
        document_object.Status = report["status"]

    def current(self, document_object):
        """The part of planish, made again after the document was opened."""
        if self.part is None:
            self.part = self.made(document_object)
        return self.part


class Pattern(Proxy):
    """An object with a flat pattern, whose lines other objects draw."""

    results = RESULTS + PATTERN
    hidden = [("Part::PropertyPartShape", name, "", None) for name in PARTS_OF_PATTERN]

    def show(self, document_object, part):
        drawn = {name: [] for name in PARTS_OF_PATTERN}
        right = 0.0
        for flat in part.flats:
            curves = flat.curves()
            piece = {"Flat": shapes.face(curves),
                     "BendsUp": shapes.bend_lines(flat.to_dict()["bends"], "up"),
                     "BendsDown": shapes.bend_lines(flat.to_dict()["bends"], "down"),
                     "Slits": shapes.open_curves(curves["slits"]),
                     "Forms": shapes.open_curves([outline for form in curves["features"] for outline in form])}
            box = piece["Flat"].BoundBox
            for name, shape in piece.items():
                if right:
                    shape.translate(App.Vector(right - box.XMin, 0, 0))
                drawn[name].append(shape)
            right = drawn["Flat"][-1].BoundBox.XMax + GAP
        for name, pieces in drawn.items():
            pieces = [shape for shape in pieces if shape.Edges]
            setattr(document_object, name, pieces[0] if len(pieces) == 1 else
                    Part.makeCompound(pieces) if pieces else Part.Shape())
        super().show(document_object, part)
        document_object.Thickness = _sheet(part)["thickness"]
        document_object.Area = sum(flat.area for flat in part.flats)
        document_object.Bends = sum(len(flat.bends) for flat in part.flats)


class Unfold(Pattern):
    """The flat pattern of a solid."""

    planish_kind = "unfold"
    inputs = [
        *SOLID,
        *BENDING,
        ("App::PropertyEnumeration", "Up", "The skin that faces up; auto: the one from which more bends go up", UP),
        ("App::PropertyEnumeration", "Relief", "How to mend corners without relief that overlap a little when flat", RELIEF),
        ("App::PropertyEnumeration", "BendRelief", "Reliefs to cut beside bends where the rules ask for one", BEND_RELIEF),
        ("App::PropertyEnumeration", "Extruded", "What is cut for holes through forms", EXTRUDED),
        ("App::PropertyString", "RipEdges", "Edges along which a closed solid is cut open, as its refusal names them: 21,56", ""),
    ]

    def made(self, document_object):
        return planish().unfold(solid_of(document_object), name=_name(document_object.Source),
                                up=document_object.Up, relief=document_object.Relief, extruded=document_object.Extruded,
                                bend_relief=document_object.BendRelief, rip_edges=document_object.RipEdges or None, **bending(document_object))

    def show(self, document_object, part):
        super().show(document_object, part)
        place(document_object, document_object.Flat)


class Folded(Pattern):
    """A part that is made bent; its flat pattern is drawn by an object of its own."""

    def show(self, document_object, part):
        super().show(document_object, part)
        document_object.Shape = shapes.folded(part)


class Connect(Folded):
    """Plates joined by bends."""

    planish_kind = "connect"
    inputs = [
        ("App::PropertyLinkSubListGlobal", "Plates", "Faces, or closed sketches", None),
        ("App::PropertyLinkListGlobal", "Frames", "Parts in which the plates stand, which move them", None),
        ("App::PropertyLength", "SheetThickness", "Of the sheet", 2.0),
        ("App::PropertyEnumeration", "FacesAre", "The plates' middle surface, or the skin that is seen, with the material "
         "behind it", FACES_ARE),
        ("App::PropertyLength", "InsideRadius", "Of every bend; 0: chosen so that the least is added to the plates", 0.0),
        ("App::PropertyEnumeration", "Lateral", "Lateral boundaries of the bends", LATERAL),
        *BENDING,
    ]

    def document_of(self, document_object):
        """The plates file, as a dictionary."""
        if not document_object.Plates:
            raise Refusal("no_plates", f"{document_object.Label} has no plates: select faces or closed sketches.")
        thickness = document_object.SheetThickness.Value
        behind = thickness / 2 if document_object.FacesAre == "skin" else 0.0
        plates = []
        for name, outer, holes, normal in sources.plates(document_object.Plates):
            def coordinates(points, shift=normal * behind):
                return [[*(point - shift)] for point in points]
            plates.append({"id": name, "outline": coordinates(outer), "holes": [coordinates(hole) for hole in holes]})
        return {"format": "planish/plates", "version": 1, "thickness": thickness, "plates": plates}

    def made(self, document_object):
        radius = document_object.InsideRadius.Value
        lateral = document_object.Lateral
        return planish().connect(self.document_of(document_object), name=f"{document_object.Name}.json",
                                 inside_radius=radius if radius > 0 else None,
                                 lateral=lateral if lateral != "auto" else None, **bending(document_object))


class Transition(Folded):
    """A developable shape from one closed profile to another."""

    planish_kind = "transition"
    inputs = [
        ("App::PropertyLinkSubGlobal", "From", "A sketch, a wire or a face", None),
        ("App::PropertyLinkSubGlobal", "To", "A sketch, a wire or a face", None),
        ("App::PropertyLinkListGlobal", "Frames", "Parts in which the profiles stand, which move them", None),
        ("App::PropertyLength", "SheetThickness", "Of the sheet", 1.0),
        ("App::PropertyEnumeration", "SizesAre", "The surface for which the profiles are given", SIZES_ARE),
        ("App::PropertyEnumeration", "Pieces", "In how many pieces it is cut", PIECES),
        ("App::PropertyAngle", "PressAngle", "Largest angle of a stroke on curved parts; 0: they are rolled", 10.0),
        ("App::PropertyInteger", "SeamEdge", "The edge of From, from 0, in whose middle the seam lies; −1: where it is "
         "shortest", -1),
        ("App::PropertyFloatConstraint", "KFactor", "Where the neutral line lies, in thicknesses from the inside",
         (0.5, 0.0, 1.0, 0.01)),
    ]

    def document_of(self, document_object):
        """The transition file, as a dictionary."""
        ends = []
        for name in ("From", "To"):
            link = getattr(document_object, name)
            if not link or link[0] is None:
                raise Refusal("no_profile", f"{document_object.Label} has no profile in {name}: choose a closed sketch or wire.")
            ends.append(profiles.end(sources.profile_wire(*link), link[0].Label))
        start, finish = profiles.turned_alike(*ends)
        made = {"format": "planish/transition", "version": 1, "thickness": document_object.SheetThickness.Value,
                "k_factor": document_object.KFactor, "sizes_are": document_object.SizesAre, "from": start, "to": finish,
                "pieces": "per_side" if document_object.Pieces == "per_side" else int(document_object.Pieces)}
        if document_object.PressAngle.Value > 0:
            made["press_lines"] = {"max_angle": document_object.PressAngle.Value}
        if document_object.SeamEdge >= 0:
            made["seam"] = {"edge": document_object.SeamEdge}
        return made

    def made(self, document_object):
        return planish().transition(self.document_of(document_object), name=f"{document_object.Name}.json")


class BendPlan(Proxy):
    """The order in which a press brake bends a solid."""

    planish_kind = "bend_plan"
    inputs = [
        *SOLID,
        *BENDING,
        ("App::PropertyEnumeration", "Metal", "Sets strength and springback; empty: mild steel without springback", METAL),
        ("App::PropertyFile", "Tools", "The press brake and its tools (JSON); empty: common European ones", ""),
    ]
    results = [*RESULTS, ("App::PropertyStringList", "Strokes", "In order", [])]

    def made(self, document_object):
        return planish().bend(solid_of(document_object), name=_name(document_object.Source),
                              metal=document_object.Metal or None, tools=_file(document_object.Tools),
                              **bending(document_object))

    def show(self, document_object, part):
        super().show(document_object, part)
        document_object.Strokes = [
            f"{number}. {', '.join(stroke['bends'])} by {stroke['angle']:.1f}°, {stroke['punch']} / {stroke['die']}, "
            f"{stroke['force']:.0f} kN" for number, stroke in enumerate(part.to_dict()["plan"]["strokes"], 1)]


class Drawn(Proxy):
    """The pattern of a bent part, or bend lines, slits or forms of a pattern, drawn where the pattern lies."""

    planish_kind = "drawn"
    inputs = [
        ("App::PropertyLinkGlobal", "Owner", "What it belongs to", None),
        ("App::PropertyLinkGlobal", "Beside", "The pattern with which it moves", None),
        ("App::PropertyEnumeration", "What", "What is drawn", PARTS_OF_PATTERN),
    ]
    results = []

    def update(self, document_object):
        if document_object.Owner is None:
            return
        place(document_object, getattr(document_object.Owner, document_object.What))
        if document_object.Beside is not None:
            document_object.Placement = document_object.Beside.Placement


def solid_of(document_object):
    if document_object.Source is None:
        raise Refusal("no_source", f"{document_object.Label} has no source any more: choose one in Source.")
    return sources.solid(document_object.Source, document_object.Body)


def place(document_object, shape):
    """Sets a shape and leaves the object where it is."""
    placement = document_object.Placement
    document_object.Shape = shape
    document_object.Placement = placement


def bending(document_object):
    """K as options of planish: a table or a shop before the factor."""
    table, shop = _file(document_object.KTable), _file(document_object.Shop)
    if table or shop:
        return {"k_table": table, "shop": shop if not table else None}
    return {"k": document_object.KFactor}


def _file(path):
    if not path:
        return None
    if not os.path.isfile(path):
        raise Refusal("cannot_read", f"{path} is not there.", path)
    return path


def _name(source):
    return source.Label or source.Name


def _sheet(part):
    report = part.to_dict()
    return (report.get("pieces") or [report])[0]["sheet"]
