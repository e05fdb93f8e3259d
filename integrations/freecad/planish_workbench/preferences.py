"""What new objects start with: Edit > Preferences > Planish."""

import os

import FreeCAD as App

GROUP = "User parameter:BaseApp/Preferences/Mod/Planish"
PROFILES = ["default", "inventor", "onshape", "solidedge"]  # in the order of the page


def _group():
    return App.ParamGet(GROUP)


def k_factor():
    return _group().GetFloat("KFactor", 0.44)


def k_table():
    """Path of a bend table; "" for none."""
    return _group().GetString("KTable", "")


def shop():
    """Path of a shop profile; "" for none."""
    return _group().GetString("Shop", "")


def folder():
    """That of the Python package planish, where it is not installed; "" for none."""
    return _group().GetString("Folder", "") or os.environ.get("PLANISH_PYTHON_FOLDER", "")


def profile():
    """Layers of the DXF."""
    number = _group().GetInt("Profile", 0)
    return PROFILES[number] if 0 <= number < len(PROFILES) else PROFILES[0]
