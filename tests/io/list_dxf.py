#!/usr/bin/python3
"""Lists what ezdxf reads in a DXF file, as JSON, for tests that judge it themselves.

    list_dxf.py file.dxf

Per layer: circles [x, y, radius], lines [x, y, x, y], texts [text, x, y, height], polylines
{closed, area, box}; the layers that are off or dashed, $INSUNITS, and what ezdxf's audit finds.
"""

import json
import math
import sys

import ezdxf
from ezdxf import bbox
from ezdxf.lldxf.encoding import decode_dxf_unicode
from ezdxf.math import bulge_to_arc


def polyline(entity):
    if entity.dxftype() == "LWPOLYLINE":
        points = [(x, y, b) for x, y, b in entity.get_points("xyb")]
        closed = entity.closed
    else:
        points = [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0)) for v in entity.vertices]
        closed = entity.is_closed
    area = 0.0
    for (ax, ay, bulge), (bx, by, _) in zip(points, points[1:] + points[:1]):
        area += (ax * by - bx * ay) / 2
        if bulge:
            # The segment of a circle between chord and arc.
            angle = 4 * math.atan(abs(bulge))
            _, _, _, radius = bulge_to_arc((ax, ay), (bx, by), bulge)
            area += math.copysign(radius**2 * (angle - math.sin(angle)) / 2, bulge)
    low, high = bbox.extents([entity], flatten=1e-4)
    return {"closed": bool(closed), "area": area, "box": [low.x, low.y, high.x, high.y]}


def main():
    doc = ezdxf.readfile(sys.argv[1])
    layers = {}
    for entity in doc.modelspace():
        here = layers.setdefault(entity.dxf.layer, {"circles": [], "lines": [], "texts": [], "polylines": []})
        kind = entity.dxftype()
        if kind == "CIRCLE":
            here["circles"].append([entity.dxf.center.x, entity.dxf.center.y, entity.dxf.radius])
        elif kind == "LINE":
            here["lines"].append([*entity.dxf.start.vec2, *entity.dxf.end.vec2])
        elif kind == "TEXT":
            at = entity.dxf.align_point
            here["texts"].append([decode_dxf_unicode(entity.dxf.text), at.x, at.y, entity.dxf.height])
        else:
            here["polylines"].append(polyline(entity))
    report = {
        "layers": layers,
        "off": [layer.dxf.name for layer in doc.layers if layer.is_off()],
        "dashed": [layer.dxf.name for layer in doc.layers if layer.dxf.linetype == "DASHED"],
        "units": doc.header["$INSUNITS"],
        "version": doc.dxfversion,
        "audit": [error.message for error in doc.audit().errors],
    }
    json.dump(report, sys.stdout)


main()
