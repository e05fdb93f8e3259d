"""What needs FreeCAD's window: commands, panels, icons."""

import pathlib

FOLDER = pathlib.Path(__file__).resolve().parents[1]


def folder():
    """Of the icons."""
    return str(FOLDER / "icons")


def icon(name):
    return str(FOLDER / "icons" / f"{name}.svg")


def page():
    """The page of the preferences."""
    return str(FOLDER / "gui" / "preferences.ui")
