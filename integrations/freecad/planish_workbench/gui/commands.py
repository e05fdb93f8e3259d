"""Commands of the toolbar and the menu. Each is one step of undo."""

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from .. import make, places, sources
from ..library import Refusal, planish, sentence
from . import icon, panels, view


def register():
    """Registers all commands; returns their names."""
    for name, command in COMMANDS.items():
        Gui.addCommand(name, command)
    return list(COMMANDS)


def say(text):
    """One clear sentence, in the report view and in a window."""
    App.Console.PrintError(f"Planish: {text}\n")
    QtGui.QMessageBox.warning(Gui.getMainWindow(), "Planish", text)


def selected():
    """(object, names of faces and edges) of what is selected; Planish's own objects stand for themselves."""
    return [(one.Object, list(one.SubElementNames)) for one in Gui.Selection.getSelectionEx("", 1)]


def selected_solid():
    """The one selected object with a solid, and the number of the solid that holds the selected face."""
    chosen = selected()
    if len(chosen) != 1:
        raise Refusal("selection", "Select one solid: a body, a part or a link." if not chosen else
                      f"{len(chosen)} objects are selected: select one solid, or use Unfold document.")
    source, names = chosen[0]
    if kind_of(source) in ("unfold", "bend_plan"):
        return source.Source, source.Body
    if kind_of(source) == "drawn":
        return source.Owner, 1
    shape = sources.global_shape(source)
    if names and names[0].startswith("Face") and len(shape.Solids) > 1:
        face = shape.getElement(names[0])
        for number, solid in enumerate(shape.Solids, 1):
            if any(one.isSame(face) for one in solid.Faces):
                return source, number
    sources.solid(source)
    return source, 1


def kind_of(one):
    return getattr(getattr(one, "Proxy", None), "planish_kind", "")


def selected_pattern():
    """The selected object of Planish that has a flat pattern."""
    for one, _ in selected():
        if kind_of(one) == "drawn":
            one = one.Owner
        if kind_of(one) in ("unfold", "connect", "transition"):
            return one
    raise Refusal("selection", "Select a flat pattern, a bent plate or a transition of Planish.")


def point_out(source, number, error, rips=()):
    """Selects the edges that an error names, beside those ripped already, or else the faces."""
    of_error = getattr(error, "places", [])
    edges = places.named(of_error, "edge")
    names = sources.element_names(source, number, "Edge", [*rips, *edges]) if edges else \
        sources.element_names(source, number, "Face", places.named(of_error, "face"))
    if names:
        Gui.Selection.clearSelection()
    for name in names:
        Gui.Selection.addSelection(source.Document.Name, source.Name, name)


class Command:
    """A command whose work is undone at once."""

    text, tip, picture = "", "", ""

    def GetResources(self):
        return {"Pixmap": icon(self.picture), "MenuText": self.text, "ToolTip": self.tip}

    def IsActive(self):
        return App.ActiveDocument is not None

    def Activated(self, *_):
        document = App.ActiveDocument
        document.openTransaction(self.text)
        try:
            made = self.work(document)
            document.recompute()
        except Exception as error:
            document.abortTransaction()
            say(sentence(error))
            return
        if made is None or not panels.edit(made, in_transaction=True):
            document.commitTransaction()
        view.look_at(document)

    def work(self, document):
        """Does it; returns the object whose panel opens, or None."""
        raise NotImplementedError


class Unfold(Command):
    text, tip, picture = "Unfold", "Lay the selected solid flat, cut open along its selected edges", "Unfold"

    def work(self, document):
        source, number = selected_solid()
        rips = [edge for one, names in selected() if one is source
                for edge in sources.element_numbers(source, number, "Edge", names)]
        try:
            return make.unfold(source, body=number, rip_edges=rips, beside=True)
        except planish().Error as error:
            point_out(source, number, error, rips)
            raise


class UnfoldDocument(Command):
    text, tip, picture = "Unfold document", "Lay each different solid of the document flat", "UnfoldDocument"

    def work(self, document):
        made, refused = make.unfold_document(document, beside=True)
        if refused:
            say(f"{len(made)} laid flat, {len(refused)} not:\n" +
                "\n".join(f"{source.Label}: {sentence(error)}" for source, _, error in refused))
        return None


class Connect(Command):
    text, tip, picture = "Connect plates", "Join the selected faces or closed sketches by bends", "Connect"

    def work(self, document):
        chosen = selected()
        if sum(max(1, len(names)) for _, names in chosen) < 2:
            raise Refusal("selection", "Select at least two plates: plane faces, or closed sketches.")
        return make.connect([(one, names or [""]) for one, names in chosen], 2.0, inside_radius=2.0)


class Transition(Command):
    text, tip, picture = "Transition", "Make a developable shape between two closed sketches or wires", "Transition"

    def work(self, document):
        ends = [(one, names) for one, names in selected()]
        if len(ends) != 2:
            raise Refusal("selection", f"Select two closed sketches or wires; {len(ends)} are selected.")
        return make.transition(*((one, names or [""]) for one, names in ends), 1.0)


class BendPlan(Command):
    text, tip, picture = "Bend plan", "Find the order of strokes in which a press brake bends the selected solid", "BendPlan"

    def work(self, document):
        source, number = selected_solid()
        return make.bend_plan(source, body=number)


class Sketch(Command):
    text, tip, picture = "Sketch of the flat pattern", "Draw contours and bend lines as a sketch", "Sketch"

    def work(self, document):
        make.sketch(selected_pattern())


class Write(Command):
    text, tip, picture = "Write DXF", "Write the flat pattern for the laser: DXF, SVG, or a drawing as PDF", "Write"

    def Activated(self, *_):
        try:
            made = selected_pattern()
            planish()
        except Exception as error:
            say(sentence(error))
            return
        write(made)


def write(made):
    """Asks for a file and writes it."""
    path, _ = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), "Write the flat pattern", f"{made.Label}.dxf",
                                                "DXF (*.dxf);;SVG (*.svg);;PDF (*.pdf);;STEP (*.step);;Report (*.json)")
    if not path:
        return
    try:
        for one in make.write(made, path):
            App.Console.PrintMessage(f"Planish: {one}\n")
    except Exception as error:
        say(sentence(error))


COMMANDS = {"Planish_Unfold": Unfold(), "Planish_UnfoldDocument": UnfoldDocument(), "Planish_Connect": Connect(),
            "Planish_Transition": Transition(), "Planish_BendPlan": BendPlan(), "Planish_Sketch": Sketch(),
            "Planish_Write": Write()}
