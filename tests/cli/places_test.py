#!/usr/bin/python3
"""What a sentence names is there as data: every place, and every option, of as many refusals as inputs can bring about."""

import json
import pathlib
import re
import sys

sys.path[:0] = [str(pathlib.Path(__file__).parent), str(pathlib.Path(__file__).parent / "../serve")]
import step_files  # noqa: E402
from connect_test import ell  # noqa: E402
from planish_cli import main  # noqa: E402
from planish_serve import ServeTest  # noqa: E402
from slit_test import banner, chair  # noqa: E402
from transition_test import frustum, square_to_round  # noqa: E402

COUNTED_FROM_ZERO = {"strip", "ridge"}
PLURALS = {"bodies": "body"}
NAME = r'(?:"[^"]*"|B?\d+(?![\d.]*\d| ?(?:mm|°|%|×|kN)))'
# "faces 3, 5 and 12", "bend B2", 'plate "floor"', "line 7"; a number with a unit or a decimal point is a measure.
NAMED = re.compile(rf"\b(faces?|edges?|body|bodies|flanges?|bends?|plates?|strips?|ridges?|strokes?|lines?) "
                   rf"({NAME}(?:(?:, | and ){NAME})*)", re.IGNORECASE)
POINTER = re.compile(r"(?<![\w.>/\\*?:])/[a-z_]+(?:/[\w~-]+)*")
# What does not exist is no place, nor what one may choose instead, nor edges that a plate counts from 0.
NO_PLACE = re.compile(rf"(?:one of|which has) faces {NAME}(?:, {NAME})*|\bno (?:body|plate|face|edge) {NAME}|\bedges? {NAME}(?: and {NAME})*(?=\. Name free)")


def places_in(sentence):
    """What a sentence names, as (kind, id)."""
    found, sentence = [], NO_PLACE.sub("", sentence)
    for kind, names in NAMED.findall(sentence):
        kind = PLURALS.get(kind.lower(), kind.lower().rstrip("s"))
        for name in re.findall(NAME, names):
            if name.startswith('"'):
                found.append((kind, name.strip('"')))
            elif name.startswith("B"):
                found.append((kind, name))
            else:
                found.append((kind, int(name) - (kind in COUNTED_FROM_ZERO)))
    return found + [("pointer", pointer) for pointer in POINTER.findall(sentence)]


def changed(content, change):
    change(content)
    return content


def wrong(make, *path, value):
    """The content with another value somewhere."""
    content = make()
    at = content
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    return content


def third_plate(content):
    content["plates"].append({"id": "C", "outline": [[220, 0, 20], [220, 100, 20], [220, 100, 120], [220, 0, 120]]})


def meeting(origin, normal=(0, 0, 1)):
    content = frustum()
    content["to"]["frame"] = {"origin": list(origin), "normal": list(normal)}
    return content


def section(**bend):
    """A bend without plates."""
    return {"thickness": 2, "plates": [], "bends": [{"between": [], **bend}]}


def outline(corners):
    return wrong(ell, "plates", 1, "outline", value=corners)


# Inputs of each maker and the code with which it is refused.
CONNECT = [
    (wrong(ell, "thickness", value=-1), "invalid_input"),
    (wrong(ell, "plates", 1, "id", value="A"), "invalid_input"),
    (wrong(ell, "plates", 0, "outline", 2, value=[1, 2]), "invalid_input"),
    (wrong(ell, "plates", 0, "outline", 2, value=[1, 2, 1e13]), "invalid_input"),
    (wrong(ell, "plates", 0, "colour", value="red"), "invalid_input"),
    (wrong(ell, "bends", 0, "between", value=["A", "A"]), "invalid_input"),
    (wrong(ell, "bends", 0, "between", value=["A", "B", "C"]), "invalid_input"),
    (wrong(ell, "bends", 0, "edges", value={"C": [1]}), "invalid_input"),
    (wrong(ell, "bends", 0, "edges", value={"A": [1, 1]}), "invalid_input"),
    (wrong(ell, "bends", 0, "angle", value=90), "invalid_input"),
    (wrong(ell, "bends", 0, "inside_radii", value=[1, 2]), "invalid_input"),
    (section(angle=0, inside_radius=2, length=10), "invalid_input"),
    (section(angle=90, inside_radius=2, length=10, slope=0.1), "invalid_input"),
    ({"thickness": 2, "plates": [], "bends": []}, "invalid_input"),
    (wrong(ell, "format", value="planish/rules"), "invalid_input"),
    (outline([[0, 120, 20], [200, 120, 20]]), "too_few_corners"),
    (outline([[0, 120, 20], [200, 120, 20], [200, 120, 20], [0, 120, 120]]), "repeated_corner"),
    (outline([[0, 120, 20], [200, 120, 20], [200, 125, 120], [0, 120, 120]]), "not_planar"),
    (outline([[0, 120, 20], [200, 120, 20], [0, 120, 120], [200, 120, 120]]), "self_crossing"),
    (wrong(ell, "bends", 0, "between", value=["A", "C"]), "unknown_plate"),
    (wrong(ell, "root", value="C"), "unknown_plate"),
    (wrong(ell, "bends", 0, "edges", value={"A": [4]}), "unknown_edge"),
    (wrong(ell, "bends", 0, "edges", value={"A": [0, 2]}), "unknown_edge"),
    (changed(ell(), lambda c: (third_plate(c), c.update(bends=[{"between": p} for p in (["A", "B"], ["A", "C"], ["B", "C"])]))), "bend_loop"),
    (changed(ell(), third_plate), "not_connected"),
    (wrong(ell, "bends", 0, "inside_radius", value=40), "no_bend_fits"),
    (outline([[0, 50, -20], [200, 50, -20], [200, 50, 120], [0, 50, 120]]), "plates_intersect"),
    (outline([[0, 101, 0], [200, 101, 0], [200, 200, 0], [0, 200, 0]]), None),
]
TRANSITION = [
    (meeting((400, 0, 0)), "profiles_meet"),
    (meeting((0, 0, 50), (1, 0, 0)), "profile_hidden"),
    (wrong(square_to_round, "from", "profile", "polygon", 2, value=[-100, -100]), "profile_not_convex"),
    (frustum(thickness=250, sizes_are="outside"), "radius_too_small"),
    (square_to_round(seam={"edge": 4}), "unknown_seam"),
    (frustum(seam={"corner": 0}), "unknown_seam"),
    (wrong(square_to_round, "from", "profile", "polygon", value=[[0, 0], [100, 100], [100, 0], [0, 100]]), "self_crossing"),
    (wrong(frustum, "to", "frame", "x", value=[0, 0, 1]), "invalid_input"),
    (wrong(frustum, "to", "frame", "normal", value=[0, 0, 0]), "invalid_input"),
    (square_to_round(press_lines={"count": 1000000000}), "invalid_input"),
    (square_to_round(press_lines={"max_angle": 1e-6}), None),
]
SLIT = [
    (wrong(chair, "sheet", "half_length", value=300), "out_of_reach"),
    (chair(leg_curve={"bezier": [[360, 0], [360, 300]]}), "curve_too_short"),
    (chair(leg_curve={"bezier": [[360, 0], [360, 400]]}), "curve_too_long"),
    (chair(leg_curve={"bezier": [[360, 0], [390, 180], [360, 360]]}, min_inside_radius=5000), "radius_too_small"),
    (chair(anchors=[{"strip": 6, "ridge": 1, "at": [0, 0, 0]}]), "unknown_strip"),
    (chair(anchors=[{"strip": 0, "ridge": 11, "at": [0, 0, 0]}]), "unknown_ridge"),
    (chair(anchors=[{"strip": 0, "ridge": 5, "at": [200, 1200, 0]}]), "out_of_reach"),
    (chair(scan=[{"strip": 0, "points": []}]), "empty_scan"),
    (chair(scan=[{"strip": 9, "points": [[0, 0, 0]]}]), "unknown_strip"),
    (chair(ends=[{"strip": 0}]), "invalid_input"),
    (banner(ends=[{"strip": 5}]), "invalid_input"),
    (banner(ends=[{"strip": 1, "direction": [0, 1, 0]}, {"strip": 1}]), "invalid_input"),
    (banner(seat_curve={"bezier": [[0, 0], [0, 135]]}), "invalid_input"),
]
ANGLE = step_files.angle()
SOLIDS = [
    (step_files.block(), {}, "not_a_sheet"),
    (step_files.square_tube(), {}, "closed_loop"),
    (step_files.stepped_angle(), {}, "not_a_sheet"),
    (step_files.surface_only(), {}, "shell_not_solid"),
    ("", {}, "invalid_input"),
    ("solid", {}, "not_step"),
    (ANGLE[:len(ANGLE) // 2], {}, "truncated_file"),
    (ANGLE, {"body": "7"}, "no_such_body"),
    (ANGLE, {"body": "door"}, "no_such_body"),
    (step_files.two_angles_and_a_block(), {}, "no_such_body"),
    (ANGLE, {"root": 999}, "no_such_face"),
    (ANGLE, {"root": "face"}, None),
    (ANGLE, {"up": 999}, "no_such_face"),
    (ANGLE, {"bend_k": {"B9": 0.4}}, "bad_option"),
    (ANGLE, {"rip_edges": "a"}, "bad_option"),
    (ANGLE, {"rip_edges": "1"}, None),
    (ANGLE, {"k": 0.4, "din6935": True}, "bad_option"),
    (ANGLE, {"k": 7}, "invalid_input"),
    (ANGLE, {"lateral": "arc"}, "bad_option"),
    (ANGLE, {"tick_length": 2}, "bad_option"),
    (ANGLE, {"splines": "keep", "r12": True}, "bad_option"),
    (ANGLE, {"rules": {"content": {"k_low": 0.6, "k_high": 0.5}}}, "invalid_input"),
    (ANGLE, {"rules": {"content": {"flange_heigth_t": 2}}}, "invalid_input"),
    (ANGLE, {"k_table": {"name": "k.csv", "content": "radius,angle\n1,90\n"}}, "invalid_input"),
    (ANGLE, {"k_table": {"name": "k.csv", "content": "r/t,k\n1,0.4\n2,x\n"}}, "invalid_input"),
    (ANGLE, {"material": {"content": {"tension": {"points": [[0, 0], [0.2, 100], [0.1, 200]]}}}}, "invalid_input"),
]


class Sentences(ServeTest):
    def check_reason(self, reason, about):
        """`reason` with its message; places and options that it names are data."""
        message = reason["message"]
        self.assertNotRegex(message, r"\{@?\w+", about)
        self.assertNotRegex(message, r"\b1 (?:bodies|groups|bends|faces|strips|edges)\b|-0\.0\b|\b-0\b|\d{13}", about)
        self.assertRegex(message, r"[.?!]$", about)
        places = [(place["kind"], place.get("id")) for place in reason["places"]]
        places += [("face", face) for place in reason["places"] for face in place.get("faces", [])]
        self.assertEqual([one for one in places_in(message) if one not in places], [], f"{about}: {reason}")
        pieces = reason.get("wording", [{"text": message}])
        self.assertEqual("".join(piece["text"] for piece in pieces), message)
        for piece in pieces:
            if "place" in piece:
                self.assertIn(piece["place"], reason["places"], about)
            if "option" in piece:
                self.assertEqual(piece["text"], f"`{piece['option']}`")
        self.assertNotIn("`", "".join(piece["text"] for piece in pieces if "option" not in piece), about)

    def refusal(self, server, method, content, options, code):
        params = {"input": {"name": "input", "content": content}, "options": options}
        number = server.begin(method, params)
        answer = server.answer(number)
        about = f"{method} {json.dumps(options)} {str(content)[:300]}"
        if "error" in answer:
            error = answer["error"]
            reason = {**error["data"], "message": error["message"]}
        else:
            reason = answer["result"]["report"]["reason"]
        self.assertIsNotNone(reason, about)
        self.check_reason(reason, about)
        if code is not None:
            self.assertEqual(reason["code"], code, f"{about}: {reason}")
        return reason

    def test_each_place_of_a_sentence_is_data(self):
        server = self.server("--jobs", 1)
        codes = set()
        for method, cases in ("connect", CONNECT), ("transition", TRANSITION), ("slit", SLIT):
            for content, code in cases:
                with self.subTest(method=method, code=code, content=str(content)[:200]):
                    codes.add(self.refusal(server, method, content, {}, code)["code"])
        for content, options, code in SOLIDS:
            with self.subTest(code=code, options=options):
                codes.add(self.refusal(server, "unfold", content, options, code)["code"])
        self.assertGreaterEqual(len(codes), 28, codes)

    def test_mistakes_in_requests(self):
        self.angle()
        server = self.server("--jobs", 1)
        for params in ({"input": "part.step", "options": {"strips": 2}}, {"input": "part.step", "artifacts": ["step2"]}, {"input": "-"},
                       {"input": "part.step", "artifacts": ["mould.stl"]}, {"input": "part.step", "sheets": True}, {"input": "part.step", "maker": "slit"},
                       {"input": "part.step", "write": {"dxf": ""}}, {"input": "part.step", "write": []}, {"options": {}}, {"input": "none.step"},
                       {"input": "part.step", "write": {"dxf": "none/a.dxf"}}, {"input": "part.step", "write": {"dxf": "part.step"}},
                       {"input": "part.step", "options": {"k_table": "-"}}, {"input": "part.step", "effort": "much"},
                       {"input": "part.step", "options": {"material": "steel", "shop": {"content": {"materials": []}}}}):
            with self.subTest(params):
                error = server.fails("unfold", params)
                self.check_reason({**error["data"], "message": error["message"]}, params)

    def test_text_that_is_not_json_has_a_line(self):
        for text, line, column in ('{\n  "thickness" 4 }', 2, 15), ("[" * 200, 1, 101), ("{", 1, None):
            self.write("plates.json", text)
            self.refused("connect", "plates.json", "--json", "r.json", status=3)
            reason = self.json("r.json")["reason"]
            self.check_reason(reason, text)
            self.assertEqual(reason["places"], [{"kind": "line", "id": line}])
            if column:
                self.assertEqual(reason["numbers"]["column"]["value"], column)
                self.assertTrue(reason["where"].endswith(f":{line}:{column}"), reason)


class Reading(ServeTest):
    """The test's own reader finds what it is there for."""

    def test_places_of_sentences(self):
        for sentence, expected in (
                ("Face 12 curves.", [("face", 12)]),
                ('Plates "a" and "b" touch at (1, 2, 3).', [("plate", "a"), ("plate", "b")]),
                ("Edge 21 between face 7 and face 9 is 3 mm long.", [("edge", 21), ("face", 7), ("face", 9)]),
                ("Strips 1, 2 and 3 are short.", [("strip", 0), ("strip", 1), ("strip", 2)]),
                ("There is a mistake in line 3, column 5.", [("line", 3)]),
                ("/bends/0/k must be a number from 0 to 1, not 7.", [("pointer", "/bends/0/k")]),
                ("The bend is 3 mm wide; K is bd/2 of part.json/x.", []),
                ("2 bends of 90° each.", [])):
            self.assertEqual(places_in(sentence), expected, sentence)


if __name__ == "__main__":
    main()
