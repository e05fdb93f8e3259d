"""How objects look in the tree and in the view."""

import FreeCADGui as Gui

from . import icon

ICONS = {"unfold": "Unfold", "connect": "Connect", "transition": "Transition", "bend_plan": "BendPlan", "drawn": "Drawn"}
UP, DOWN, MARKED, CUT = (0.0, 0.2, 0.9), (0.85, 0.0, 0.0), (0.1, 0.55, 0.1), (0.0, 0.5, 0.55)
COLOURS = {"BendsUp": UP, "BendsDown": DOWN, "Slits": CUT, "Forms": MARKED}
DASHED = ("BendsUp", "BendsDown")


class View:
    """The view provider of all objects; a double click opens the panel."""

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object):
        self.made = view_object.Object

    def getIcon(self):
        return icon(ICONS.get(self.made.Proxy.planish_kind, "Planish"))

    def claimChildren(self):
        """Lines belong to the pattern with which they move, a net to its part."""
        drawn = [one for one in dict.fromkeys(self.made.InList)
                 if getattr(getattr(one, "Proxy", None), "planish_kind", "") == "drawn"]
        return [one for one in drawn if one.Beside == self.made or (one.Owner == self.made and one.Beside is None)]

    def doubleClicked(self, view_object):
        from . import panels

        return panels.edit(view_object.Object)

    def setEdit(self, view_object, mode=0):
        return False

    def updateData(self, made, name):
        pass

    def onChanged(self, view_object, name):
        pass

    def onDelete(self, view_object, names):
        """What is drawn of an object goes with it."""
        for one in self.claimChildren():
            for line in one.ViewObject.Proxy.claimChildren():
                one.Document.removeObject(line.Name)
            one.Document.removeObject(one.Name)
        return True

    def dumps(self):
        return None

    def loads(self, state):
        pass

    __getstate__ = dumps
    __setstate__ = loads


def attach(made):
    """Gives a new object its looks."""
    view = made.ViewObject
    View(view)
    view.Proxy.attach(view)
    colour = COLOURS.get(getattr(made, "What", ""))
    if colour is not None:
        view.LineColor = colour
        view.LineWidth = 2.0
        if made.What in DASHED and "Dashed" in view.getEnumerationsOfProperty("DrawStyle"):
            view.DrawStyle = "Dashed"
    elif hasattr(view, "ShapeColor") and made.Proxy.planish_kind != "bend_plan":
        view.ShapeColor = (0.75, 0.80, 0.86)
    if hasattr(view, "PointSize"):
        view.PointSize = 1.0


def look_at(document):
    Gui.getDocument(document.Name).activeView().fitAll()
