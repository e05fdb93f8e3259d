"""Runs in FreeCAD's window: commands, panels, undo, findings that select faces, preferences, pictures."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD as App
import FreeCADGui as Gui
import inside
import Part
import unittest
from PySide import QtCore, QtGui

SIZE = (1280, 800)


def wait(milliseconds):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def picture(name):
    """Of the screen, whole."""
    wait(300)
    QtGui.QApplication.primaryScreen().grabWindow(0).save(str(inside.SCRATCH / f"{name}.png"))


def put_in_order():
    window = Gui.getMainWindow()
    window.setGeometry(0, 0, *SIZE)
    for name in ("Report view", "Python console", "Selection view"):
        dock = window.findChild(QtGui.QDockWidget, name)
        if dock is not None:
            dock.hide()
    dock = window.findChild(QtGui.QDockWidget, "Combo View")
    if dock is not None:
        window.resizeDocks([dock], [400], QtCore.Qt.Horizontal)


def answer_yes():
    """To the question that is asked next."""
    def answer():
        asked = QtGui.QApplication.activeModalWidget()
        if asked is None:
            QtCore.QTimer.singleShot(50, answer)
        else:
            asked.button(QtGui.QMessageBox.Yes).click()

    QtCore.QTimer.singleShot(50, answer)


class Window(unittest.TestCase):
    def setUp(self):
        self.document = App.newDocument("test")
        self.said = []
        from planish_workbench.gui import commands

        self._say, commands.say = commands.say, self.said.append

    def tearDown(self):
        from planish_workbench.gui import commands

        commands.say = self._say
        if self.panel():
            self.panel().reject()
        for name in list(App.listDocuments()):
            App.closeDocument(name)

    @staticmethod
    def panel():
        from planish_workbench.gui import panels

        return panels.Panel.current

    def solid(self, shape):
        source = self.document.addObject("Part::Feature", "Bracket")
        source.Shape = shape
        self.document.recompute()
        self.look()
        return source

    def look(self):
        view = Gui.activeDocument().activeView()
        view.viewAxometric()
        view.fitAll()

    def choose(self, *names):
        Gui.Selection.clearSelection()
        for name in names:
            Gui.Selection.addSelection(self.document.Name, *([name] if isinstance(name, str) else name))

    def names(self):
        return [one.Name for one in self.document.Objects]

    def test_the_workbench_is_there_with_all_its_commands(self):
        self.assertIn("PlanishWorkbench", Gui.listWorkbenches())
        from planish_workbench.gui import commands

        for name in commands.COMMANDS:
            self.assertIn(name, Gui.listCommands())
            self.assertTrue(os.path.isfile(commands.COMMANDS[name].GetResources()["Pixmap"]))

    def test_unfold_shows_live_values_and_is_one_step_of_undo(self):
        shape, area = inside.bent()
        self.solid(shape)
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.assertEqual(self.said, [])
        self.panel().fields["KFactor"].setValue(0.3)
        wait(1500)
        flat = self.document.Unfold
        self.assertAlmostEqual(flat.Shape.Area, area(0.3), delta=1e-6)
        self.assertIn(f"{area(0.3):.2f}", self.panel().results.text())
        self.panel().accept()
        self.assertEqual(self.document.UndoCount, 1)
        self.document.undo()
        self.assertEqual(self.names(), ["Bracket"])
        self.document.redo()
        self.assertEqual(self.names(), ["Bracket", "Unfold", "BendsUp", "BendsDown"])
        self.assertEqual([one.Name for one in flat_children(self.document.Unfold)], ["BendsUp", "BendsDown"])

    def test_cancel_leaves_nothing_behind(self):
        self.solid(inside.bracket())
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.panel().reject()
        self.assertEqual(self.names(), ["Bracket"])

    def test_a_double_click_edits_and_cancel_brings_the_old_values_back(self):
        shape, area = inside.bent()
        self.solid(shape)
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.panel().accept()
        flat = self.document.Unfold
        before = flat.KFactor
        flat.ViewObject.Proxy.doubleClicked(flat.ViewObject)
        self.panel().fields["KFactor"].setValue(0.1)
        wait(1500)
        self.assertAlmostEqual(flat.Shape.Area, area(0.1), delta=1e-6)
        self.panel().reject()
        self.assertAlmostEqual(flat.KFactor, before)
        self.assertAlmostEqual(flat.Shape.Area, area(before), delta=1e-6)

    def test_a_closed_tray_is_opened_by_unfolding_what_each_refusal_selects(self):
        shape, area = inside.tray()
        self.solid(shape)
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.assertEqual(len(self.said), 1)
        chosen, = Gui.Selection.getSelectionEx()
        self.assertEqual([name[:4] for name in chosen.SubElementNames], 4 * ["Edge"])
        Gui.runCommand("Planish_Unfold")
        self.assertEqual(len(self.said), 1)
        self.panel().fields["KFactor"].setValue(0.5)
        wait(1500)
        flat = self.document.Unfold
        self.assertAlmostEqual(flat.Shape.Area, area(0.5), delta=1e-6)
        self.assertEqual(self.panel().fields["RipEdges"].text(), flat.RipEdges)

    def test_the_row_of_a_finding_selects_the_face(self):
        face = inside.bracket().Faces[1]
        middle, normal = face.CenterOfMass, face.normalAt(0, 0)
        hole = Part.makeCylinder(0.4, 6, middle + normal * 3 - App.Vector(0, 15, 0), normal * -1)
        source = self.solid(inside.bracket().cut(hole))
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        rows = self.panel().rows
        self.assertEqual(len(rows), 1)
        self.assertIn("0.8 mm", rows[0].message)
        Gui.Selection.clearSelection()
        self.panel().findings.selectRow(0)
        chosen = [(one.ObjectName, tuple(one.SubElementNames)) for one in Gui.Selection.getSelectionEx()]
        self.assertEqual(len(chosen), 1)
        self.assertEqual(len(chosen[0][1]), 2)
        for name in chosen[0][1]:
            self.assertAlmostEqual(source.Shape.getElement(name).Area, face.Area - 0.16 * math.pi, delta=1e-6)
        self.look()
        picture("unfold")

    def test_a_refusal_is_said_once_and_nothing_is_made(self):
        self.solid(Part.makeSphere(10))
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.assertEqual(len(self.said), 1)
        self.assertIn("not a sheet", self.said[0])
        self.assertEqual(self.names(), ["Bracket"])
        self.choose()
        Gui.runCommand("Planish_Unfold")
        self.assertEqual(self.said[1], "Select one solid: a body, a part or a link.")

    def test_connect_and_transition_have_panels_and_nets(self):
        for name, length, width, placement in (
                ("Base", 200, 120, App.Placement()),
                ("Back", 200, 80, App.Placement(App.Vector(0, 130, 10), App.Rotation(App.Vector(1, 0, 0), 90))),
                ("Side", 70, 120, App.Placement(App.Vector(-10, 0, 10), App.Rotation(App.Vector(0, 1, 0), -90)))):
            plate = self.document.addObject("Part::Plane", name)
            plate.Length, plate.Width, plate.Placement = length, width, placement
        self.document.recompute()
        self.choose(("Base", "Face1"), ("Back", "Face1"), ("Side", "Face1"))
        Gui.runCommand("Planish_Connect")
        self.assertEqual(self.said, [])
        Gui.Selection.clearSelection()
        self.look()
        picture("connect")
        self.panel().fields["SheetThickness"].setValue(3.0)
        wait(1500)
        made = self.document.Connect
        self.assertAlmostEqual(made.Thickness.Value, 3.0, delta=1e-9)
        self.panel().accept()
        self.assertEqual(json.loads(made.Report)["sheet"]["bends"], 2)
        App.closeDocument(self.document.Name)
        self.document = App.newDocument("test")
        round_end = self.document.addObject("Part::Circle", "Round")
        round_end.Radius = 60
        round_end.Placement.Base = App.Vector(20, 0, 160)
        square = self.document.addObject("Part::RegularPolygon", "Square")
        square.Polygon, square.Circumradius = 4, 150
        square.Placement.Rotation = App.Rotation(App.Vector(0, 0, 1), 45)
        self.document.recompute()
        self.choose("Square", "Round")
        Gui.runCommand("Planish_Transition")
        self.assertEqual(self.said, [])
        Gui.Selection.clearSelection()
        self.look()
        picture("transition")
        self.panel().accept()
        net = [one for one in flat_children(self.document.Transition)]
        self.assertEqual([one.What for one in net], ["Flat"])

    def test_what_is_drawn_of_an_object_is_deleted_with_it(self):
        for name, height in (("Low", 0), ("High", 100)):
            circle = self.document.addObject("Part::Circle", name)
            circle.Radius = 80 - height / 4
            circle.Placement.Base = App.Vector(0, 0, height)
        self.document.recompute()
        self.choose("Low", "High")
        Gui.runCommand("Planish_Transition")
        self.panel().accept()
        self.assertEqual(len(self.names()), 6)
        self.choose("Transition")
        answer_yes()  # FreeCAD asks, because the net depends on it
        Gui.runCommand("Std_Delete")
        self.assertEqual(self.names(), ["Low", "High"])

    def test_a_bend_plan_lists_strokes(self):
        self.solid(inside.bracket())
        self.choose("Bracket")
        Gui.runCommand("Planish_BendPlan")
        self.assertEqual(self.said, [])
        self.assertEqual(self.panel().strokes.rowCount(), 2)
        Gui.Selection.clearSelection()
        self.look()
        picture("plan")
        self.panel().accept()

    def test_preferences_are_what_new_objects_start_with(self):
        group = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Planish")
        group.SetFloat("KFactor", 0.35)

        def shown():
            picture("preferences")
            dialog = QtGui.QApplication.activeModalWidget()
            field = dialog.findChild(QtGui.QDoubleSpinBox, "KFactor")
            self.found = field.value() if field else None
            dialog.reject()

        QtCore.QTimer.singleShot(1500, shown)
        Gui.showPreferences("Planish", 0)
        self.assertAlmostEqual(self.found, 0.35)
        shape, area = inside.bent()
        self.solid(shape)
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.assertAlmostEqual(self.document.Unfold.Shape.Area, area(0.35), delta=1e-6)
        group.RemFloat("KFactor")

    def test_a_document_that_is_opened_keeps_its_panels(self):
        self.solid(inside.bracket())
        self.choose("Bracket")
        Gui.runCommand("Planish_Unfold")
        self.panel().accept()
        path = str(inside.SCRATCH / "window.FCStd")
        self.document.saveAs(path)
        App.closeDocument(self.document.Name)
        self.document = App.openDocument(path)
        flat = self.document.Unfold
        self.assertEqual([one.Name for one in flat_children(flat)], ["BendsUp", "BendsDown"])
        self.assertTrue(flat.ViewObject.Proxy.getIcon().endswith("Unfold.svg"))
        flat.ViewObject.Proxy.doubleClicked(flat.ViewObject)
        self.assertIs(self.panel().made, flat)


def flat_children(made):
    return made.ViewObject.Proxy.claimChildren()


def run():
    put_in_order()
    inside.run(Window)


QtCore.QTimer.singleShot(1500, run)
