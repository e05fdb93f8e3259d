#!/usr/bin/python3
"""Orders the strokes of parts that a press brake can bend; refuses those that it cannot, and tools that cannot be."""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

import ezdxf
from ezdxf import bbox

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import CLI, CliTest, main  # noqa: E402

PARTS = pathlib.Path(os.environ.get("PLANISH_PARTS") or pathlib.Path(__file__).parents[3] / "shared" / "parts")
WEIGHTS = {"turn_over": 3, "rotate": 2, "tool_change": 5, "stroke": 1, "ungauged": 4}


def channel(leg, lip=0, out=False):
    """A channel of 2 mm, web 60, legs of the given height, 100 long; with lips, turned in or out, if they are wanted."""
    room = 5
    upright = lambda x, z: [[x, 0, room], [x, 100, room], [x, 100, z], [x, 0, z]]
    top = leg - room if lip else leg
    plates = [{"id": "web", "outline": [[room, 0, 0], [60 - room, 0, 0], [60 - room, 100, 0], [room, 100, 0]]},
              {"id": "left", "outline": upright(0, top)}, {"id": "right", "outline": upright(60, top)}]
    pairs = [["web", "left"], ["web", "right"]]
    if lip:
        for name, x, into in (("left", 0, 1), ("right", 60, -1)):
            way = -into if out else into
            near, far = x + way * room, x + way * lip
            plates.append({"id": f"{name} lip",
                           "outline": [[near, 0, leg], [near, 100, leg], [far, 100, leg], [far, 0, leg]]})
            pairs.append([name, f"{name} lip"])
    return {"thickness": 2, "defaults": {"inside_radius": 2}, "plates": plates,
            "bends": [{"between": pair} for pair in pairs]}


def large_channel():
    """A channel of 400 by 200 with bends of 25 mm inside."""
    part = channel(200) | {"defaults": {"inside_radius": 25}}
    part["plates"][0]["outline"] = [[30, 0, 0], [370, 0, 0], [370, 100, 0], [30, 100, 0]]
    for plate, x in zip(part["plates"][1:], (0, 400)):
        plate["outline"] = [[x, 0, 30], [x, 100, 30], [x, 100, 200], [x, 0, 200]]
    return part


def tabbed():
    """A base of 400 by 300 in 1 mm with tabs, up and down, on all sides; some have lips turned out."""
    pad = 1.5
    plates = [{"id": "base", "outline": [[x, y, 0] for x, y in ((pad, pad), (400 - pad, pad), (400 - pad, 300 - pad),
                                                                (pad, 300 - pad))]}]
    pairs = []

    def tab(at, span, height, lip=0):
        """`at` gives the point of the rim's corner at a distance along the side, and one so far out of it."""
        name = f"tab {len(plates)}"
        up = pad if height > 0 else -pad
        end = height - up if lip else height
        rim = [at(s, 0) for s in span]
        plates.append({"id": name, "outline": [[*p, up] for p in rim] + [[*p, end] for p in rim[::-1]]})
        pairs.append(["base", name])
        if lip:
            near, far = ([at(s, out) for s in span] for out in (pad, lip))
            plates.append({"id": f"{name} lip", "outline": [[*p, height] for p in near + far[::-1]]})
            pairs.append([name, f"{name} lip"])

    tab(lambda s, out: [s, -out], (16, 384), 15)
    for number, (height, lip) in enumerate(((-40, 0), (40, 0), (-40, 10))):
        tab(lambda s, out: [s, 300 + out], (16 + number * 380 / 3, 16 + number * 380 / 3 + 344 / 3), height, lip)
    for number, height in enumerate((20, -20, -20)):
        tab(lambda s, out: [400 + out, s], (16 + number * 280 / 3, 16 + number * 280 / 3 + 244 / 3), height)
    for number, (height, lip) in enumerate(((25, 10), (25, 15), (40, 0), (25, 0))):
        tab(lambda s, out: [-out, s], (16 + 70 * number, 74 + 70 * number), height, lip)
    return {"thickness": 1, "defaults": {"inside_radius": 1}, "plates": plates,
            "bends": [{"between": pair} for pair in pairs]}


def mirrored(part):
    """The same with x the other way."""
    return part | {"plates": [plate | {"outline": [[-x, y, z] for x, y, z in plate["outline"]]}
                              for plate in part["plates"]]}


class BendTest(CliTest):
    def plan(self, plates, *arguments, status=0):
        self.write("part.json", json.dumps(plates))
        self.run_cli("bend", "part.json", "--json", "r.json", "-q", *arguments, status=status)
        report = self.json("r.json")
        self.assertEqual(report["command"], "bend")
        return report

    def tools(self):
        return json.loads(self.run_cli("bend", "--print-tools")[0])

    def cost_of(self, strokes, weights):
        cost, last = 0, None
        for stroke in strokes:
            cost += weights["stroke"] + (0 if stroke["gauge"] else weights["ungauged"])
            if last:
                cost += weights["turn_over"] * (stroke["side_up"] != last["side_up"])
                cost += weights["rotate"] * (stroke["gauge_direction"] != last["gauge_direction"])
                cost += weights["tool_change"] * ((stroke["punch"], stroke["die"]) != (last["punch"], last["die"]))
            last = stroke
        return cost


class Plans(BendTest):
    def test_cost_is_that_of_the_strokes(self):
        for part in (channel(30), channel(30, lip=15), channel(30, lip=15, out=True)):
            plan = self.plan(part)["plan"]
            self.assertEqual(plan["status"], "optimal")
            self.assertAlmostEqual(plan["cost"], self.cost_of(plan["strokes"], WEIGHTS) + plan["v_away"])
            self.assertEqual(sorted(b for s in plan["strokes"] for b in s["bends"]),
                             [f"B{i + 1}" for i in range(len(part["bends"]))])

    def test_lips_that_turn_out_take_one_turning_over(self):
        # The insides of the bends of web and lips are on opposite sides.
        self.assertEqual(self.plan(channel(30, lip=15, out=True))["plan"]["turn_overs"], 1)
        self.assertEqual(self.plan(channel(30, lip=15))["plan"]["turn_overs"], 0)

    def test_few_segments_on_a_short_press_are_enough_either_way_round(self):
        """No plan is cheaper with a shop's every segment and three metres to lay them on."""
        tools = self.tools()
        tools["punches"] = [tool for tool in tools["punches"] if tool["id"] in ("P88-R1", "P88-R0.8")]
        tools["dies"] = [tool for tool in tools["dies"] if tool["id"] in ("V8-88", "V12-88")]
        self.write("all.json", json.dumps(tools))
        tools["machine"]["length"] = 1050
        for tool in tools["punches"]:
            tool["segments"] = [200, 100, 50, 40, 20, 10]
        for tool in tools["dies"]:
            tool["segments"] = [300, 200, 100, 50, 40, 20, 15, 10]
        self.write("few.json", json.dumps(tools))
        least = self.plan(tabbed(), "--tools", "all.json")["plan"]["cost"]
        for part in (tabbed(), mirrored(tabbed())):
            plan = self.plan(part, "--tools", "few.json")["plan"]
            self.assertEqual((plan["status"], plan["cost"], plan["tool_changes"]), ("optimal", least, 0))

    def test_weights_are_those_given(self):
        weights = {"turn_over": 7, "rotate": 0.5, "tool_change": 1, "stroke": 2, "ungauged": 0}
        words = ",".join(f"{name}={value}" for name, value in weights.items())
        plan = self.plan(channel(30, lip=15, out=True), "--weights", words)["plan"]
        self.assertAlmostEqual(plan["cost"], self.cost_of(plan["strokes"], weights))

    def test_begins_as_it_is_told(self):
        for first in ("B1", "B2"):
            report = self.plan(channel(30), "--fix", first)
            self.assertEqual(report["plan"]["strokes"][0]["bends"], [first])
            orders = {bend["id"]: bend["order"] for bend in report["flat"]["bends"]}
            self.assertEqual(orders[first], 1)

    def test_force_is_that_of_the_metal(self):
        # 1.42 · R_m · T² / V over the pressed length, V 12 for 2 mm.
        plain = self.plan(channel(30))["plan"]["strokes"][0]["force"]
        stainless = self.plan(channel(30), "--material", "stainless", "--opening", "12")["plan"]["strokes"][0]["force"]
        self.assertAlmostEqual(stainless / plain, 700 / 450, places=6)

    def test_the_summary_lists_the_strokes(self):
        self.write("part.json", json.dumps(channel(30)))
        out, _ = self.run_cli("bend", "part.json")
        self.assertRegex(out, r"plan: optimal, cost \d+: 2 strokes")
        self.assertEqual(len(re.findall(r"^ +\d  B\d ", out, re.M)), 2)

    def test_standard_input_is_read_once(self):
        out, _ = self.run_cli("bend", "-", "--json", "-", "-q", stdin=json.dumps(channel(30)).encode())
        self.assertEqual(json.loads(out)["plan"]["status"], "optimal")

    def test_a_sheet_without_bends_takes_no_stroke(self):
        flat = channel(30)
        flat["plates"], flat["bends"] = flat["plates"][:1], []
        self.assertEqual(self.plan(flat)["plan"]["strokes"], [])


class Infeasible(BendTest):
    def test_a_channel_too_deep_for_the_tools_is_refused_with_its_pattern(self):
        report = self.plan(channel(250), status=4)
        self.assertEqual((report["status"], report["reason"]["code"]), ("refused", "cannot_bend"))
        self.assertEqual((report["plan"]["status"], report["plan"]["strokes"]), ("infeasible", []))
        self.assertEqual(report["sheet"]["bends"], 2)
        self.assertEqual(len(report["flat"]["bends"]), 2)

    def test_more_tools_never_make_it_worse_and_more_clearance_never_better(self):
        tools = self.tools()
        thick = dict(tools["punches"][0], id="thick", profile=[[0, 0], [12, 12.4], [12, 120], [-12, 120], [-12, 12.4]])
        self.write("all.json", json.dumps(dict(tools, punches=[thick, *tools["punches"]])))
        self.write("few.json", json.dumps(dict(tools, punches=[thick])))
        rows = set()
        for lip in (10, 13, 16, 19, 22):
            self.write("part.json", json.dumps(channel(30, lip=lip)))
            costs = [self.cost("--tools", f"{tools}.json", "--clearance", clearance)
                     for tools, clearance in (("all", 0), ("few", 0), ("few", 3))]
            self.assertEqual(costs, sorted(costs), lip)
            rows.add(tuple(cost == float("inf") for cost in costs))
        # Some lip is too long for all, some for few, some for few with clearance only.
        self.assertGreaterEqual(len(rows), 3, rows)

    def cost(self, *arguments):
        """Of the cheapest order; infinite if there is none."""
        subprocess.run([CLI, "bend", "part.json", "--json", "r.json", "-q", *map(str, arguments)], cwd=self.dir,
                       capture_output=True, check=False)
        plan = self.json("r.json")["plan"]
        self.assertIn(plan["status"], ("optimal", "infeasible"))
        return float("inf") if plan["cost"] is None else plan["cost"]

    def test_unfold_tells_it_as_a_finding(self):
        self.write("part.json", json.dumps(channel(250)))
        self.run_cli("connect", "part.json", "-o", "deep.step", "-q")
        self.run_cli("unfold", "deep.step", "--check", "--check-bending", "--json", "r.json", "-q")
        report = self.json("r.json")
        (finding,) = [check for check in report["checks"] if check["code"] == "cannot_bend"]
        self.assertEqual(finding["severity"], "warning")  # the pattern is right
        self.assertNotIn("plan", report)
        self.run_cli("unfold", "deep.step", "--check", "--json", "r.json", "-q")
        self.assertNotIn("cannot_bend", [check["code"] for check in self.json("r.json")["checks"]])

    def test_every_bend_table_has_the_order(self):
        part = channel(30, lip=15, out=True)
        strokes = self.plan(part)["plan"]["strokes"]
        order = {bend: number for number, stroke in reversed(list(enumerate(strokes, 1))) for bend in stroke["bends"]}
        self.assertNotEqual(list(order.values()), sorted(order.values()))  # not the order in which bends are numbered
        out, _ = self.run_cli("connect", "part.json", "--check-bending", "--bend-text", "--flat", "f.dxf", "--flat", "f.svg",
                              "--json", "r.json")
        bends = self.json("r.json")["flat"]["bends"]
        self.assertEqual({bend["id"]: bend["order"] for bend in bends}, order)
        table = out[out.index("stroke\n"):out.index("extension area")]
        rows = {line.split()[0]: line.split()[-1] for line in table.splitlines() if re.match(r"B\d+ ", line)}
        self.assertEqual(rows, {bend: str(number) for bend, number in order.items()})
        drawn = (self.dir / "f.svg").read_text()
        texts = re.findall(r"\nTEXT\n(?:.*\n)*?  1\n(.*)\n", (self.dir / "f.dxf").read_text())
        for bend, number in order.items():
            self.assertIn(f">{number}: {bend} ", drawn)
            self.assertEqual(len([text for text in texts if text.startswith(f"{number}: {bend} ")]), 1)
        self.run_cli("connect", "part.json", "--check-bending", "--flat", "f.dxf", "-q")
        self.assertNotIn("\nTEXT\n", (self.dir / "f.dxf").read_text())

    def test_step_and_plates_have_one_plan(self):
        self.write("part.json", json.dumps(channel(30, lip=15)))
        self.run_cli("connect", "part.json", "-o", "part.step", "-q")
        self.run_cli("bend", "part.step", "--json", "s.json", "-q")
        plates = self.plan(channel(30, lip=15))["plan"]
        step = self.json("s.json")["plan"]
        for key in ("status", "cost", "turn_overs", "rotations", "tool_changes"):
            self.assertEqual(step[key], plates[key], key)


class Proposals(BendTest):
    def proposals(self, plates, *arguments):
        plan = self.plan(plates, *arguments, status=4)["plan"]
        self.assertEqual(plan["status"], "infeasible")
        return {proposal["kind"]: proposal for proposal in plan["proposals"]}

    def test_a_smaller_v_is_one_that_does(self):
        # V 12 with shoulders of 1.2 takes flanges from 7.2 mm.
        low = channel(7)
        proposal = self.proposals(low, "--v", "wanted")["smaller_v"]
        self.assertLess(proposal["opening"], 12)
        self.assertTrue(proposal["tools"])
        for choice in "wanted", "choice":
            strokes = self.plan(low, "--opening", str(proposal["opening"]), "--v", choice)["plan"]["strokes"]
            for stroke in strokes:
                self.assertIn(stroke["die"], proposal["tools"])

    def test_a_flange_shorter_by_that_much_can_be_bent(self):
        tools = self.tools()
        straight = [punch for punch in tools["punches"] if punch["id"] == "P88-R1"]
        self.write("straight.json", json.dumps(dict(tools, punches=straight)))
        by = self.proposals(channel(80), "--tools", "straight.json")["shorter_flange"]["by"]
        of = lambda leg, status: self.plan(channel(leg), "--tools", "straight.json", status=status)["plan"]["status"]
        self.assertEqual(of(80 - by, 0), "optimal")
        self.assertEqual(of(80 - by + 0.2, 4), "infeasible")

    def test_a_punch_of_the_common_tools_is_named(self):
        tools = self.tools()
        wide = dict(tools["punches"][0], id="wide", profile=[[0, 0], [25, 25.9], [25, 120], [-25, 120], [-25, 25.9]])
        self.write("wide.json", json.dumps(dict(tools, punches=[wide])))
        proposal = self.proposals(channel(45), "--tools", "wide.json")["punch"]
        (name,) = proposal["tools"]
        (punch,) = [punch for punch in tools["punches"] if punch["id"] == name]
        self.write("both.json", json.dumps(dict(tools, punches=[wide, punch])))
        strokes = self.plan(channel(45), "--tools", "both.json")["plan"]["strokes"]
        self.assertIn(name, [stroke["punch"] for stroke in strokes])

    def test_they_are_in_the_summary(self):
        self.write("part.json", json.dumps(channel(80)))
        out, _ = self.run_cli("bend", "part.json", status=4)
        self.assertRegex(out, r"it can be bent\n  .*\n")

    def test_a_part_that_can_be_bent_needs_none(self):
        self.assertNotIn("proposals", self.plan(channel(30))["plan"])


class WrongRequests(BendTest):
    def setUp(self):
        super().setUp()
        self.write("part.json", json.dumps(channel(30)))

    def test_options(self):
        for arguments, words in (
                (["--weights", "turn=3"], "--weights must be like turn_over=3"),
                (["--weights", "rotate=-1"], "--weights must be like"),
                (["--fix", "B7"], 'there is no bend B7; the bends are B1, B2'),
                (["--springback", "90"], "--springback"),
                (["--clearance", "-1"], "--clearance"),
                (["-o", "plan.dxf"], "End the name in one of .pdf, .svg"),
                (["-o", "a.pdf", "-o", "a.pdf"], "a.pdf"),
                (["--body", "1"], "--body does not go with a plates file")):
            self.assertIn(words, self.refused("bend", "part.json", *arguments, status=2), arguments)

    def test_tools_that_cannot_be(self):
        def refused_with(change):
            tools = self.tools()
            change(tools)
            self.write("tools.json", json.dumps(tools))
            return self.refused("bend", "part.json", "--tools", "tools.json", status=3)

        crossed = refused_with(lambda t: t["punches"][1].update(profile=[[0, 0], [9, 90], [-9, 90], [9, 30]]))
        self.assertIn("crosses", crossed)
        self.assertIn("tools.json/punches/1/profile", crossed)
        self.assertIn("tools.json/dies/0/segments", refused_with(lambda t: t["dies"][0].update(segments=[])))
        self.assertIn("tools.json/dies", refused_with(lambda t: t.update(dies=[])))
        self.assertIn("tools.json/punches/0/id", refused_with(lambda t: t["punches"][0].pop("id")))
        self.assertIn("(tools.json/punches)", refused_with(lambda t: t.update(punches=[])))
        self.assertIn("tools.json/dies/1/segments", refused_with(lambda t: t["dies"][1].pop("segments")))
        self.assertIn("tools.json/punches/2/profile", refused_with(
            lambda t: t["punches"][2].update(profile=[[1, 1], [9, 90], [-9, 90]])))

    def test_files_that_no_maker_reads(self):
        self.write("other.json", "{}")
        self.assertIn("not one of these", self.refused("bend", "other.json", status=3))
        self.assertIn("missing.step", self.refused("bend", "missing.step", status=3))

    def test_parts_that_no_tool_bears(self):
        sharp = dict(channel(30), defaults={"inside_radius": 0.1})
        # No tip is as sharp, so any will do that the V hides.
        stroke = self.plan(sharp)["plan"]["strokes"][0]
        tips = {punch["id"]: punch["tip_radius"] for punch in self.tools()["punches"]}
        self.assertLessEqual(tips[stroke["punch"]], stroke["radius_made"])
        reason = self.plan(sharp, "--as-drawn", status=4)["reason"]
        self.assertEqual((reason["code"], reason["where"]), ("no_tool", "B1"))
        self.assertIn("no punch and die that leave an inside radius within a third of 0.1 mm", reason["message"])
        # 1.42 · 450 · 2² / 12 N/mm are 213 kN per metre.
        tools = self.tools()
        for die in tools["dies"]:
            die["max_force"] = 20
        self.write("weak.json", json.dumps(tools))
        reason = self.plan(channel(30), "--tools", "weak.json", status=4)["reason"]
        self.assertEqual(reason["code"], "no_tool")
        self.assertRegex(reason["message"], r"no punch and die that bear [\d.]+ kN/m")

    def test_a_press_that_is_too_short_or_too_weak(self):
        # 100 mm over V 12 take 21.3 kN, over V 20 12.78, the widest within 12 T that the set has.
        for force, status in (21.4, 0), (12.79, 0), (12.7, 4):
            tools = self.tools()
            tools["machine"]["force"] = force
            self.write("press.json", json.dumps(tools))
            report = self.plan(channel(60), "--tools", "press.json", status=status)
            if status:
                self.assertEqual(report["reason"]["code"], "press_too_small")
                self.assertEqual({"force", "most"} - report["reason"]["numbers"].keys(), set())
            else:
                self.assertTrue(all(stroke["force"] <= force for stroke in report["plan"]["strokes"]))
        tools["machine"].update(force=1000, length=90)
        self.write("press.json", json.dumps(tools))
        reason = self.plan(channel(60), "--tools", "press.json", status=4)["reason"]
        self.assertEqual((reason["code"], reason["where"]), ("press_too_small", "B1"))
        self.assertIn("the machine holds 90 mm", reason["message"])

    def test_the_flat_as_made_is_written(self):
        # Legs of 60 over a V of 20: 3.2 instead of 2 mm inside shortens each bend by (2 − π/2) 1.2 mm.
        tools = self.tools()
        tools["dies"] = [die for die in tools["dies"] if die["id"] == "V20-85"]
        self.write("v20.json", json.dumps(tools))
        self.write("part.json", json.dumps(channel(60)))
        self.run_cli("bend", "part.json", "--tools", "v20.json", "--as-made", "made.dxf", "--json", "r.json", "-q")
        report, drawing = self.json("r.json"), ezdxf.readfile(self.dir / "made.dxf")
        box = bbox.extents(drawing.modelspace().query('*[layer=="OUTER_PROFILE"]'))
        made = report["plan"]["as_made"]
        self.assertAlmostEqual(max(box.size.x, box.size.y), made["length"], 6)
        self.assertAlmostEqual(made["length"], report["flat"]["size"][0], 6)
        drawn = self.plan(channel(60), "--tools", "v20.json")
        self.assertAlmostEqual(made["length"] - drawn["flat"]["size"][0], 2 * (math.pi / 2 - 2) * 1.2, 6)
        # Gauge and check belong to one flat: drawn flanges from the one as made, longer ones from the drawn one.
        for plan, leg in ((report, 61), (drawn, 61 + (2 - math.pi / 2) / 2 * 1.2)):
            self.assertAlmostEqual(plan["plan"]["strokes"][0]["check_dimension"]["length"], leg, 4)
        self.refused("bend", "part.json", "--as-made", "made.pdf", status=2)

    def test_what_is_in_the_way_has_a_reason(self):
        # Of two joggles one bend each can be formed, and is then in the way of the other one of its joggle only.
        name = "sf011_Original-Prusa_long-profile-R1.step"
        part = PARTS / name
        if not part.is_file():
            self.skipTest(f"{part} is absent")
        self.run_cli("bend", str(part), "--json", "r.json", "-o", "plan.svg", "-q", status=4)
        report = self.json("r.json")
        told = [note for note in report["notes"] if "where the order gets furthest" in note]
        self.assertEqual(len(told), len(report["plan"]["in_the_way"]))
        self.assertTrue(told)
        for note in told:
            self.assertRegex(note, r"^where the order gets furthest, B\d cannot be bent: \S")
        last = report["plan"]["in_the_way"][-1]
        self.assertIn(f"flat; {last['bend']}: ", report["reason"]["message"])
        remarks = [one for one in report["plan"]["remarks"] if one["code"] == "furthest_stage"]
        self.assertEqual([one["message"] for one in remarks], told)
        for remark, blocked in zip(remarks, report["plan"]["in_the_way"]):
            self.assertEqual(remark["places"][0], {"kind": "bend", "id": blocked["bend"]})
            if blocked["hits"]:
                self.assertAlmostEqual(remark["numbers"]["depth"]["value"], blocked["depth"])

    def test_a_flat_sheet_is_nothing_to_bend(self):
        plate = {"thickness": 2, "plates": [{"id": "a", "outline": [[0, 0, 0], [80, 0, 0], [80, 50, 0], [0, 50, 0]]}]}
        self.write("part.json", json.dumps(plate))
        said = self.run_cli("bend", "part.json", "--json", "r.json", "-o", "plan.svg")[0]
        self.assertIn("plan: nothing to bend\n", said)
        plan = self.json("r.json")["plan"]
        self.assertEqual((plan["status"], plan["strokes"]), ("nothing_to_bend", []))
        self.assertIn(">nothing to bend<", (self.dir / "plan.svg").read_text())

    def test_what_is_rolled_is_nothing_to_bend(self):
        report = self.plan(large_channel(), "--large-radii", "roll", "-o", "plan.svg")
        self.assertEqual((report["plan"]["status"], report["plan"]["strokes"]), ("nothing_to_bend", []))
        warning = [check for check in report["checks"] if check["code"] == "rolled_bend"]
        self.assertEqual(len(warning), 1)
        self.assertNotIn("no V", warning[0]["message"])
        self.assertIn(">no strokes: what is bent is rolled<", (self.dir / "plan.svg").read_text())

    def test_what_takes_no_bumps_is_rolled(self):
        # The sides of a U are 16 mm apart, and no punch is so narrow over 90 mm.
        side = lambda z: [[10, 0, z], [100, 0, z], [100, 100, z], [10, 100, z]]
        part = {"thickness": 2, "defaults": {"inside_radius": 8}, "bends": [{"between": ["a", "b"]}],
                "plates": [{"id": "a", "outline": side(0)}, {"id": "b", "outline": side(18)}]}
        plan = self.plan(part)["plan"]
        self.assertEqual((plan["status"], [one["formed"] for one in plan["large_radii"]]),
                         ("nothing_to_bend", ["rolled"]))
        self.assertEqual([remark["code"] for remark in plan["remarks"]], ["rolled"])
        report = self.plan(part, "--large-radii", "bump", status=4)
        self.assertEqual(report["plan"]["large_radii"][0]["formed"], "bumps")
        remedy = report["reason"]["remedy"]
        self.assertEqual((remedy["option"], remedy["value"]), ("--large-radii", "roll"))

    def test_bumps_without_a_gauge_are_one_finding(self):
        # The gauge reaches 50 mm, and each bump is at another distance from the edges.
        tools = self.tools()
        tools["machine"]["gauge"]["range"] = [5, 50]
        self.write("near.json", json.dumps(tools))
        report = self.plan(large_channel(), "--tools", "near.json", "--large-radii", "bump")
        self.assertGreater(sum(not stroke["gauge"] for stroke in report["plan"]["strokes"]), 4)
        found = [check["message"] for check in report["checks"] if check["code"] == "no_gauge_edge"]
        self.assertLessEqual(len(found), 2)
        self.assertTrue(any("the gauge reaches from 5 mm to 50 mm" in message for message in found), found)

    def test_the_pages_name_the_machine_and_are_as_fine_in_metres(self):
        tools = self.tools()
        tools["machine"]["name"] = "Hall 3"
        self.write("named.json", json.dumps(tools))
        report = self.plan(channel(60), "--tools", "named.json", "-o", "plan.svg", "--units", "m")
        page = (self.dir / "plan.svg").read_text()
        self.assertIn(", on Hall 3<", page)
        self.assertIn(f">gauge {report['plan']['strokes'][0]['gauge']['distance']:.4f} m<", page)

    def test_a_length_that_is_a_little_too_long_is_told_so_exactly(self):
        tools = self.tools()
        tools["machine"]["length"] = 3060
        self.write("press.json", json.dumps(tools))
        part = json.loads(json.dumps(channel(60)).replace("100", "3064.1"))
        message = self.plan(part, "--tools", "press.json", status=4)["reason"]["message"]
        self.assertIn("takes 3060.1 mm of tools, and the machine holds 3060 mm", message)

    def test_lengths_to_check_are_those_of_the_drawing(self):
        # Plates give middle surfaces: legs of 30 to the middle of the web, and half of its 2 mm.
        strokes = self.plan(channel(30))["plan"]["strokes"]
        self.assertEqual(len({stroke["check_dimension"]["flange"] for stroke in strokes}), 2)
        for stroke in strokes:
            self.assertAlmostEqual(stroke["check_dimension"]["length"], 31, delta=1e-9)

    def test_a_bend_without_a_straight_line(self):
        lofted = pathlib.Path(__file__).parents[2] / "examples/connect/b_lofted.json"
        self.run_cli("bend", str(lofted), "--json", "r.json", "-q", status=4)
        self.assertEqual(self.json("r.json")["reason"]["code"], "no_straight_bend")


class Pages(BendTest):
    def test_pages_hold_the_strokes(self):
        self.write("part.json", json.dumps(channel(30, lip=15, out=True)))
        self.run_cli("bend", "part.json", "-o", "plan.pdf", "-o", "plan.svg", "--json", "r.json", "-q")
        report = self.json("r.json")
        self.assertEqual(report["files"], ["plan.pdf", "plan.svg"])
        pdf = (self.dir / "plan.pdf").read_bytes()
        self.assertTrue(pdf.startswith(b"%PDF-1.") and pdf.rstrip().endswith(b"%%EOF"))
        texts = [e.text for e in xml.etree.ElementTree.parse(self.dir / "plan.svg").iter() if e.tag.endswith("text")]
        self.assertIn("Set-up 1 on the bed of 3060 mm, from your left (drawn where tools stand)", texts)
        for stroke in report["plan"]["strokes"]:
            self.assertIn(f"A: punch {stroke['punch']}", texts)
            self.assertIn(f"die {stroke['die']}", texts)
            if not stroke["gauge"]:
                self.assertIn("no gauge: mark the line while flat", texts)
                continue
            distance = f"{stroke['gauge']['distance']:.1f}"
            self.assertIn(f"gauge {distance} mm", texts)
            self.assertIn(distance, texts)  # the dimension of the lying sheet
        self.assertEqual(len([t for t in texts if t and "TURN OVER" in t]), report["plan"]["turn_overs"])

    def test_a_part_that_cannot_be_bent_has_a_page_that_says_why(self):
        self.write("part.json", json.dumps(channel(250)))
        self.run_cli("bend", "part.json", "-o", "plan.pdf", "-o", "plan.svg", "--json", "r.json", "-q", status=4)
        report = self.json("r.json")
        self.assertEqual(report["files"], ["plan.pdf", "plan.svg"])
        page = " ".join(e.text or "" for e in xml.etree.ElementTree.parse(self.dir / "plan.svg").iter()
                        if e.tag.endswith("text"))
        (in_the_way,) = report["plan"]["in_the_way"]
        self.assertIn("CANNOT BE BENT", page)
        flange = in_the_way["with"].replace("F", "flange ")
        self.assertIn(f"{in_the_way['bend']}: {flange} hits {in_the_way['hits']}", page)
        self.assertTrue(report["plan"]["proposals"])
        for proposal in report["plan"]["proposals"]:
            self.assertIn(proposal["sentence"], page)

    def test_a_part_refused_before_it_is_planned_leaves_no_pages(self):
        self.write("part.json", json.dumps(dict(channel(30), defaults={"inside_radius": 0.1})))
        self.run_cli("bend", "part.json", "--as-drawn", "-o", "plan.pdf", "--json", "r.json", "-q", status=4)
        self.assertEqual(self.names(), ["part.json", "r.json"])


if __name__ == "__main__":
    main()
