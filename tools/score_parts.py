#!/usr/bin/env python3
"""Scores a program that unfolds sheet metal on parts of known size (make_known_parts.py).

RESULTS is a report or a summary of `planish unfold --json`, a folder of them, or a CSV file that any
program can write: a line of column names, then one line a part. Columns: id; area, perimeter (of all
contours), width, height (of the smallest rectangle), thickness, volume, in mm; bends, openings (how
many); refused (why, or any word). Only id is needed: what is empty or left out is not scored.

Prints hits, misses and the worst deviation of each quantity. Exit status: 0 without a miss, 1 with
one, 2 if a file cannot be read."""

import argparse
import csv
import json
import pathlib
import sys

MM = {"mm": 1.0, "inch": 25.4, "m": 1000.0}
NUMBERS = ("thickness", "volume", "area", "perimeter", "outer", "inner", "width", "height", "openings",
           "bends")
UNITS = {"area": "mm²", "volume": "mm³", "openings": "", "bends": "", "refusal": "", "result": "",
         "bend angle": "°", "bend direction": ""}
DEGREES = 0.01  # of an angle


class Unreadable(Exception):
    pass


# ---- results

def read_results(path):
    """id -> {quantity: value in mm}, with `bend list` where the file says more than their number."""
    if path.is_dir():
        files = sorted(path.glob("*.json"))
        rows = [row for file in files for row in read_json(file)]
    elif path.suffix.lower() == ".csv":
        rows = read_csv(path)
    else:
        rows = read_json(path)
    results = {}
    for name, row in rows:
        if name in results:
            raise Unreadable(f"{path}: two results for {name}")
        results[name] = row
    return results


def read_csv(path):
    with open(path, newline="", encoding="utf-8-sig") as stream:
        for line, row in enumerate(csv.DictReader(stream), 2):
            if not row.get("id"):
                raise Unreadable(f"{path}, line {line}: there is no id")
            try:
                values = {key: float(row[key]) for key in NUMBERS if (row.get(key) or "").strip()}
            except ValueError as error:
                raise Unreadable(f"{path}, line {line}: {error}") from None
            yield row["id"].strip(), values | {"refused": (row.get("refused") or "").strip() or None}


def read_json(path):
    try:
        whole = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise Unreadable(f"{path}: {error}") from None
    kind = whole.get("format") if isinstance(whole, dict) else None
    if kind == "planish/report":
        return [(part_of(whole, path), values_of(whole))]
    if kind == "planish/summary":
        return [(body["body"], values_of(body)) for body in whole["bodies"]]
    return []


def part_of(report, path):
    return report.get("body") or pathlib.Path(report.get("input") or path).stem


def values_of(report):
    mm = MM[report.get("units") or "mm"]
    sheet, flat, reason = report.get("sheet"), report.get("flat"), report.get("reason")
    values = {"refused": reason["code"] if reason else None}
    if sheet:
        values |= {"thickness": sheet["thickness"] * mm, "volume": sheet["volume"] * mm ** 3}
    if flat:
        values |= {"area": flat["area"] * mm ** 2, "perimeter": flat["perimeter"] * mm,
                   "outer": flat["cutting"]["outer"] * mm, "inner": flat["cutting"]["inner"] * mm,
                   "width": flat["size"][0] * mm, "height": flat["size"][1] * mm,
                   "openings": flat["openings"], "bends": len(flat["bends"]),
                   "bend list": [bend_of(bend, mm) for bend in flat["bends"]]}
    return values


def bend_of(bend, mm):
    lengths = ("inside_radius", "allowance", "deduction", "length")
    row = {key: bend[key] * mm for key in lengths if bend[key] is not None}
    return row | {"angle": bend["angle"], "direction": bend["direction"]}


# ---- scores

class Score:
    """`entries`: (quantity, part, expected, found, deviation); a miss is off by more than `limit`."""

    def __init__(self, tolerance):
        self.tolerance, self.entries, self.misses = tolerance, [], []

    def exact(self, quantity, part, expected, found):
        self._add(quantity, part, expected, found, 0.0 if expected == found else 1.0, 0.0)

    def near(self, quantity, part, expected, found, limit):
        self._add(quantity, part, expected, found, abs(found - expected), limit)

    def _add(self, quantity, part, expected, found, deviation, limit):
        entry = (quantity, part, expected, found, deviation)
        self.entries.append(entry)
        if not deviation <= limit:  # also where it is not a number
            self.misses.append(entry)


def score(known, results, rule, tolerance, only_given=False):
    total = Score(tolerance)
    for part in known["parts"]:
        found = results.get(part["id"])
        if found is None:
            if not only_given:
                total.exact("result", part["id"], "one", "none")
        elif "refused" in part:
            total.exact("refusal", part["id"], "refused", "refused" if found["refused"] else "unfolded")
        elif rule in part["flat"]:
            score_part(total, part, part["flat"][rule], found)
    return total


def score_part(total, part, flat, found):
    name = part["id"]
    if found["refused"]:
        total.exact("refusal", name, "unfolded", f"refused: {found['refused']}")
        return
    total.exact("refusal", name, "unfolded", "unfolded")
    expected = {key: flat[key] for key in ("area", "perimeter", "outer", "inner")}
    expected |= {"thickness": part["thickness"], "volume": part["volume"]}
    around = total.tolerance * flat["perimeter"]  # a contour off by the tolerance all along
    limits = {"area": around, "volume": around * part["thickness"]}
    for key, value in expected.items():
        if key in found:
            total.near(key, name, value, found[key], limits.get(key, total.tolerance))
    if flat["size"] and "width" in found and "height" in found:
        sides = sorted((found["width"], found["height"]), reverse=True)
        for key, value, side in zip(("length of blank", "width of blank"), flat["size"], sides):
            total.near(key, name, value, side, total.tolerance)
    for key, count in (("openings", flat["openings"]), ("bends", len(flat["bends"]))):
        if key in found:
            total.exact(key, name, count, int(found[key]))
    if len(found.get("bend list", [])) == len(flat["bends"]):
        score_bends(total, name, flat["bends"], found.get("bend list", []))


def order(bend):
    return [round(bend.get(key) or 0.0, 3) for key in ("angle", "inside_radius", "length")] + [
        bend["direction"]]


def score_bends(total, name, expected, found):
    """Up and down may be exchanged for the whole part: it depends on the side one looks at."""
    turned = [dict(bend, direction={"up": "down", "down": "up"}[bend["direction"]]) for bend in found]
    pairings = [list(zip(sorted(expected, key=order), sorted(way, key=order)))
                for way in (found, turned)]
    pairs = min(pairings, key=lambda p: sum(a["direction"] != b["direction"] for a, b in p))
    for a, b in pairs:
        total.exact("bend direction", name, a["direction"], b["direction"])
        if a["angle"] is not None:
            total.near("bend angle", name, a["angle"], b["angle"], DEGREES)
        for key in ("inside_radius", "allowance", "deduction", "length"):
            if a[key] is not None and key in b:
                label = "bend " + key.replace("_", " ")
                total.near(label, name, a[key], b[key], total.tolerance)


# ---- printing

def show(value):
    return f"{value:.6f}" if isinstance(value, float) else str(value)


def print_table(total, out=sys.stdout):
    quantities = list(dict.fromkeys(entry[0] for entry in total.entries))
    rows = [("quantity", "scored", "hits", "misses", "worst deviation", "part")]
    for quantity in quantities:
        entries = [e for e in total.entries if e[0] == quantity]
        missed = sum(e[0] == quantity for e in total.misses)
        worst = max(entries, key=lambda e: e[4])
        unit = UNITS.get(quantity, "mm")
        counted = not isinstance(worst[2], float) and unit == ""
        deviation = "" if counted else f"{worst[4]:.1e} {unit}"
        rows.append((quantity, str(len(entries)), str(len(entries) - missed), str(missed), deviation,
                     worst[1] if worst[4] > 0 else ""))
    widths = [max(len(row[i]) for row in rows) for i in range(6)]
    for row in rows:
        cells = [cell.ljust(w) if i in (0, 5) else cell.rjust(w)
                 for i, (cell, w) in enumerate(zip(row, widths))]
        print("  ".join(cells).rstrip(), file=out)
    for quantity, part, expected, found, _ in total.misses:
        print(f"miss: {part}: {quantity} is {show(found)}, expected {show(expected)}", file=out)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("known", type=pathlib.Path, help="known_parts.json")
    parser.add_argument("results", type=pathlib.Path, help="JSON file, folder or CSV file")
    parser.add_argument("--rule", default="k=0.44",
                        help="where the results' K comes from: one of those in known_parts.json; "
                             "default k=0.44")
    parser.add_argument("--tolerance", type=float, default=0.01, metavar="MM",
                        help="of lengths, and of areas as a contour that is off by so much; "
                             "default 0.01")
    parser.add_argument("--only-given", action="store_true",
                        help="leave out parts that the results do not name")
    options = parser.parse_args()
    try:
        known = json.loads(options.known.read_text(encoding="utf-8"))
        rules = sorted({rule for part in known["parts"] for rule in part.get("flat", {})})
        if options.rule not in rules:
            raise Unreadable(f"no sizes for {options.rule}: there are {', '.join(rules)}")
        results = read_results(options.results)
        if not results:
            raise Unreadable(f"{options.results}: no results in it")
    except (OSError, KeyError, ValueError, Unreadable) as error:
        print(f"score_parts: {error}", file=sys.stderr)
        return 2
    total = score(known, results, options.rule, options.tolerance, options.only_given)
    print_table(total)
    print(f"{len(total.entries)} values of {len(known['parts'])} parts scored, "
          f"{len(total.misses)} missed")
    return 1 if total.misses else 0


if __name__ == "__main__":
    sys.exit(main())
