"""What tests need that run inside FreeCAD."""

import json
import os
import pathlib
import sys
import traceback
import unittest

SOURCE = pathlib.Path(os.environ["PLANISH_SOURCE_DIR"])
SCRATCH = pathlib.Path(os.environ["PLANISH_SCRATCH"])


def store(result):
    """Hands the result to the test outside, and ends FreeCAD."""
    pathlib.Path(os.environ["PLANISH_RESULT"]).write_text(json.dumps(result))
    sys.stdout.flush()
    os._exit(0)


def run(*cases):
    """Runs test cases and hands over what failed."""
    try:
        suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromTestCase(case) for case in cases)
        result = unittest.TestResult()
        suite.run(result)
        store({"run": result.testsRun, "failures": [f"{test}\n{text}" for test, text in result.failures + result.errors],
               "skipped": [str(test) for test, _ in result.skipped]})
    except BaseException:
        store({"run": 0, "failures": [traceback.format_exc()], "skipped": []})


def bracket():
    """The example part."""
    import Part

    shape = Part.Shape()
    shape.read(str(SOURCE / "examples/bracket.step"))
    return shape


def bent(length=80.0, width=50.0, height=40.0, thickness=2.0, radius=3.0):
    """An L of two flanges, its sizes without the bend, and the area of its pattern for K: by closed form."""
    import math

    import FreeCAD as App
    import Part

    r, t = radius, thickness
    arc = math.sqrt(0.5)
    outer, inner = r + t, r
    points = [App.Vector(-length, 0, 0), App.Vector(0, 0, 0)]
    bottom = Part.makeLine(points[0], points[1])
    outside = Part.Arc(App.Vector(0, 0, 0), App.Vector(outer * arc, 0, outer * (1 - arc)), App.Vector(outer, 0, outer)).toShape()
    up = Part.makeLine(App.Vector(outer, 0, outer), App.Vector(outer, 0, outer + height))
    top = Part.makeLine(App.Vector(outer, 0, outer + height), App.Vector(outer - t, 0, outer + height))
    down = Part.makeLine(App.Vector(outer - t, 0, outer + height), App.Vector(inner, 0, outer))
    inside = Part.Arc(App.Vector(inner, 0, outer), App.Vector(inner * arc, 0, outer - inner * arc), App.Vector(0, 0, t)).toShape()
    back = Part.makeLine(App.Vector(0, 0, t), App.Vector(-length, 0, t))
    end = Part.makeLine(App.Vector(-length, 0, t), App.Vector(-length, 0, 0))
    profile = Part.Face(Part.Wire([bottom, outside, up, top, down, inside, back, end]))
    solid = profile.extrude(App.Vector(0, width, 0))

    def area(k):
        return width * (length + height + math.pi / 2 * (r + k * t))

    return solid, area


def tray(length=100.0, width=60.0, height=40.0, thickness=2.0):
    """A closed sharp tray, and the area of its pattern for K, cut open at its four corners: by closed form."""
    import math

    import FreeCAD as App
    import Part

    inside = length - 2 * thickness, width - 2 * thickness
    solid = Part.makeBox(length, width, height).cut(Part.makeBox(*inside, height, App.Vector(thickness, thickness, thickness)))

    def area(k):
        around = 2 * sum(inside)
        return inside[0] * inside[1] + around * (height - thickness) + around * math.pi / 2 * k * thickness

    return solid, area
