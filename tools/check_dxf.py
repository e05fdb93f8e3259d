#!/usr/bin/python3
"""Checks DXF files of flat patterns by the rules of a cutting shop, with ezdxf's eyes.

    check_dxf.py [--area A [--tol R]] [--slits L] [--texts] [--no-audit] file.dxf ...
    check_dxf.py --list files.tsv

Prints one JSON object per file, in one list when there are several or with --list, and exits with
1 when any file breaks a rule (its "errors" say which), 2 on wrong usage. Python 3 and python3-ezdxf.

Areas are in mm² for --area, --list and "area_mm2", in square units of the file for "area": exact
for lines, arcs, circles, bulges and splines (Green's theorem; splines by a quadrature that is exact
for cubics). --tol is relative to the expected area. A list has a line for each file:
path <tab> area [<tab> tol [<tab> slits]]; empty area: not compared; # starts a comment.
--slits is the length of all slits in mm, within 1e-6 of itself: cuts on the layer of the openings that
do not close. None are expected unless it is given.
--texts allows TEXT on the layer TEXT, which `planish` writes on request.
"""

import argparse
import json
import sys

import ezdxf

from dxf_contours import box_of, chain_piece, contours_of, distance

OUTER = {"OUTER_PROFILE", "IV_OUTER_PROFILE", "SHEETMETAL_CUT_LINES", "OUTER_LOOP"}
OPENINGS = {"INTERIOR_PROFILES", "IV_INTERIOR_PROFILES", "SHEETMETAL_CUT_LINES", "INTERIOR_LOOPS"}
SLITS = {"SLITS", "SHEETMETAL_CUT_LINES"}
BEND_UP = {"BEND_UP", "IV_BEND", "SHEETMETAL_BEND_LINES_UP", "UP_CENTERLINES"}
BEND_DOWN = {"BEND_DOWN", "IV_BEND_DOWN", "SHEETMETAL_BEND_LINES_DOWN", "DOWN_CENTERLINES"}
BEND_ZONE = {"BEND_TANGENT", "IV_TANGENT", "SHEETMETAL_BEND_TANGENT_LI"}
FEATURES = {"FEATURE_PROFILES", "IV_FEATURE_PROFILES", "SHEETMETAL_FEATURE_PROFILES"}
TEXTS = "TEXT"
KNOWN = OUTER | OPENINGS | SLITS | BEND_UP | BEND_DOWN | BEND_ZONE | FEATURES

MILLIMETRES = {1: 25.4, 4: 1.0, 5: 10.0, 6: 1000.0}
R12_FORBIDDEN = {"LWPOLYLINE", "SPLINE", "ELLIPSE"}
NOT_GEOMETRY = {"TEXT", "MTEXT", "DIMENSION", "LEADER", "MLEADER", "MULTILEADER", "INSERT", "HATCH"}


def sort_out(contours, errors):
    """The outer contour and the openings, after checking how they lie in each other."""
    if not contours:
        errors.append("no outer contour")
        return None, []
    outer = max(contours, key=lambda c: c.area)
    openings = [c for c in contours if c is not outer]
    count = 12 if len(openings) < 100 else 3
    if outer.layer not in OUTER:
        errors.append(f"the outer contour is on layer {outer.layer}")
    for opening in openings:
        if opening.layer not in OPENINGS:
            errors.append(f"a second contour on layer {opening.layer}")
        if not all(outer.holds(p) for p in opening.some_points(count)):
            errors.append(f"an opening at {opening.origin} outside the outer contour")
        for other in openings:
            if other is not opening and other.holds(opening.some_points(1)[0]):
                errors.append(f"an opening at {opening.origin} inside another")
    return outer, openings


def check_slits(slits, outer, length, expected, errors):
    if abs(length - expected) > 1e-6 * max(expected, 1.0):
        errors.append(f"the slits are {length!r} mm long, expected {expected!r}")
    for piece in (p for slit in slits for p in slit):
        (ax, ay), (bx, by) = piece.ends
        points = piece.points()
        middle = points[len(points) // 2] if len(points) > 1 else ((ax + bx) / 2, (ay + by) / 2)
        if outer and not outer.holds(middle):
            errors.append(f"a slit at {middle} where there is no material")


def check_bend_line(doc, line, outer, openings, errors):
    layer = line.dxf.layer
    record = doc.layers.get(layer) if layer in doc.layers else None
    if line.dxftype() != "LINE":
        errors.append(f"layer {layer}: {line.dxftype()} is not a bend line")
        return
    if line.dxf.get("linetype", "BYLAYER").upper() != "DASHED":
        errors.append(f"layer {layer}: a bend line that is not DASHED itself")
    if not 1 <= line.dxf.get("color", 256) <= 255:
        errors.append(f"layer {layer}: a bend line without a colour of its own")
    if record is None or record.dxf.linetype.upper() != "DASHED":
        errors.append(f"layer {layer}: not a DASHED layer")
    middle = ((line.dxf.start.x + line.dxf.end.x) / 2, (line.dxf.start.y + line.dxf.end.y) / 2)
    if outer and (not outer.holds(middle) or any(o.holds(middle) for o in openings)):
        errors.append(f"layer {layer}: a bend line at {middle} where there is no material")


def check_linetype(doc, errors):
    if "DASHED" not in doc.linetypes:
        errors.append("no linetype DASHED")
        return
    pattern = doc.linetypes.get("DASHED").pattern_tags
    if not pattern.tags.has_tag(49):
        errors.append("the linetype DASHED has no dashes")


def extents_of(entities, contours):
    """Of the cutting contours, the lines, and the outlines of formed features."""
    features = contours_of([e for e in entities if e.dxf.layer in FEATURES], [])
    boxes = [c.box for c in contours + features]
    boxes += [box_of(chain_piece(e).ends) for e in entities if e.dxftype() == "LINE"]
    return box_of([b[:2] for b in boxes] + [b[2:] for b in boxes]) if boxes else None


def header(doc, name, errors):
    if name not in doc.header:
        errors.append(f"{name} is not set")
        return None
    return doc.header[name]


def check_header(doc, extents, splines, errors):
    units = header(doc, "$INSUNITS", errors)
    measurement = header(doc, "$MEASUREMENT", errors)
    if units not in MILLIMETRES:
        errors.append(f"$INSUNITS is {units}")
    elif measurement != (0 if units == 1 else 1):
        errors.append(f"$MEASUREMENT is {measurement} with $INSUNITS {units}")
    low, high = header(doc, "$EXTMIN", errors), header(doc, "$EXTMAX", errors)
    if extents and low and high:
        size = distance(extents[:2], extents[2:])
        told = (low[0], low[1], high[0], high[1])
        slack = 1e-3 if splines else 1e-9  # a spline's are sampled here
        if any(abs(a - b) > slack * size for a, b in zip(told, extents)):
            errors.append(f"$EXTMIN, $EXTMAX are {told}, the drawing's are {extents}")
    return units


def raw_header(path):
    """Header variables as they stand in the file; ezdxf fills in defaults for missing ones."""
    names = set()
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = iter(file)
        for code in lines:
            value = next(lines, "").strip()
            if code.strip() == "9":
                names.add(value)
            if code.strip() == "0" and value == "ENDSEC":
                break
    return names


def audit(doc, errors):
    try:
        auditor = doc.audit()
    except (AssertionError, ezdxf.DXFError) as problem:  # the auditor trips over some files itself
        errors.append(f"audit: {problem!r}")
        return
    errors += [f"audit: {e.message}" for e in auditor.errors]
    # Owner handles are optional where dxflib leaves them out; anything else put right was wrong.
    errors += [f"audit, fixed: {e.message}" for e in auditor.fixes if "owner handle" not in e.message]


def check(path, expected, tolerance, slit_length=0.0, auditing=True, texts=False):
    errors = []
    report = {"path": path, "ok": False, "errors": errors}
    try:
        doc = ezdxf.readfile(path)
    except (OSError, ezdxf.DXFError, AssertionError) as problem:
        errors.append(f"cannot read: {problem}")
        return report
    version = doc.acad_release if doc.dxfversion != "AC1009" else "R12"
    for name in {"$INSUNITS", "$MEASUREMENT", "$EXTMIN", "$EXTMAX"} - raw_header(path):
        errors.append(f"{name} is not in the file")

    entities = list(doc.modelspace())
    layers = {}
    for entity in entities:
        kind, layer = entity.dxftype(), entity.dxf.layer
        layers[layer] = layers.get(layer, 0) + 1
        if kind in NOT_GEOMETRY and not (texts and (kind, layer) == ("TEXT", TEXTS)):
            errors.append(f"layer {layer}: {kind} in a cutting file")
        if version == "R12" and kind in R12_FORBIDDEN:
            errors.append(f"{kind} in an R12 file")
        if layer not in doc.layers:
            errors.append(f"layer {layer} is not in the table of layers")
    errors += [f"unknown layer {layer}" for layer in layers if layer not in KNOWN and not (texts and layer == TEXTS)]

    slits = []
    cuts = [e for e in entities if e.dxf.layer in OUTER | OPENINGS | SLITS]
    contours = contours_of(cuts, errors, slits, SLITS)
    outer, openings = sort_out(contours, errors)
    bends = [e for e in entities if e.dxf.layer in BEND_UP | BEND_DOWN]
    if bends:
        check_linetype(doc, errors)
    for line in bends:
        check_bend_line(doc, line, outer, openings, errors)

    count = lambda kind: sum(e.dxftype() == kind for e in entities)
    extents = extents_of(entities, contours)
    units = check_header(doc, extents, count("SPLINE") > 0, errors)
    area = outer.area - sum(o.area for o in openings) if outer else 0.0
    area_mm2 = area * MILLIMETRES.get(units, 1.0) ** 2
    if expected is not None and not abs(area_mm2 - expected) <= tolerance * abs(expected):
        errors.append(f"the area is {area_mm2!r} mm², expected {expected!r} within {tolerance}")
    slits_mm = sum(p.length() for slit in slits for p in slit) * MILLIMETRES.get(units, 1.0)
    check_slits(slits, outer, slits_mm, slit_length, errors)
    if auditing:
        audit(doc, errors)

    report.update(
        ok=not errors, area=area, area_mm2=area_mm2,
        outer=len([c for c in contours if c not in openings]), openings=len(openings),
        circles=sum(c.circle for c in contours), bend_lines=len(bends),
        bend_up=sum(e.dxf.layer in BEND_UP for e in bends),
        bend_down=sum(e.dxf.layer in BEND_DOWN for e in bends),
        slits=len(slits), slits_mm=slits_mm, splines=count("SPLINE"), features=sum(n for l, n in layers.items() if l in FEATURES),
        texts=sorted(e.dxf.text for e in entities if e.dxftype() == "TEXT"),
        extents=extents, dxfversion=doc.dxfversion if version != "R12" else "AC1009",
        insunits=units, layers=layers)
    return report


def jobs_of(arguments):
    jobs = [(path, arguments.area, arguments.tol, arguments.slits) for path in arguments.files]
    if arguments.list:
        for number, line in enumerate(open(arguments.list, encoding="utf-8"), 1):
            fields = line.rstrip("\n").split("\t")
            if not fields[0] or line.startswith("#"):
                continue
            try:
                area = float(fields[1]) if len(fields) > 1 and fields[1] else None
                tol = float(fields[2]) if len(fields) > 2 and fields[2] else arguments.tol
                slits = float(fields[3]) if len(fields) > 3 and fields[3] else arguments.slits
            except ValueError as problem:
                sys.exit(f"check_dxf: {arguments.list}, line {number}: {problem}")
            jobs.append((fields[0], area, tol, slits))
    return jobs


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("files", nargs="*")
    parser.add_argument("--list", help="tab-separated: path, area in mm², tolerance")
    parser.add_argument("--area", type=float, help="expected area, mm²")
    parser.add_argument("--tol", type=float, default=1e-9, help="of the area, relative")
    parser.add_argument("--slits", type=float, default=0.0, help="length of all slits, mm")
    parser.add_argument("--texts", action="store_true", help="allow texts on the layer TEXT")
    parser.add_argument("--no-audit", action="store_true", help="leave out ezdxf's audit")
    arguments = parser.parse_args()
    jobs = jobs_of(arguments)
    if not jobs:
        parser.error("no files")
    reports = [check(*job, auditing=not arguments.no_audit, texts=arguments.texts) for job in jobs]
    single = len(reports) == 1 and not arguments.list
    print(json.dumps(reports[0] if single else reports, indent=2))
    for report in reports:
        for error in report["errors"]:
            print(f"{report['path']}: {error}", file=sys.stderr)
    sys.exit(0 if all(r["ok"] for r in reports) else 1)


if __name__ == "__main__":
    main()
