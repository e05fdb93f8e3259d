# FreeCAD runs this when its window opens. Each function stands by itself: the names of this file are gone afterwards.
import FreeCADGui


class PlanishWorkbench(FreeCADGui.Workbench):
    """Sheet metal laid flat, bent together, and planned for the press brake."""

    MenuText = "Planish"
    ToolTip = "Unfold sheet metal, connect plates, make transitions, plan bends"

    def __init__(self):
        from planish_workbench.gui import icon

        self.__class__.Icon = icon("Planish")

    def Initialize(self):
        from planish_workbench.gui import commands

        names = commands.register()
        self.appendToolbar("Planish", names)
        self.appendMenu("Planish", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def register():
    from planish_workbench import gui

    FreeCADGui.addPreferencePage(gui.page(), "Planish")
    FreeCADGui.addIconPath(gui.folder())


FreeCADGui.addWorkbench(PlanishWorkbench())
register()
