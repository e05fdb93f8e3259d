#!/usr/bin/python3
"""The order of strokes through the studio's interface: the program's plan, and orders that are given."""

import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_studio import CLI, EXAMPLES, StudioTest, main  # noqa: E402

# One leg of 90 beside a web of 60 in 1.5 mm: bent second, the other leg finds it in the way of the punch.
CHANNEL = {"format": "planish/plates", "version": 1, "thickness": 1.5, "defaults": {"inside_radius": 2}, "plates": [
    {"id": "web", "outline": [[0, 0, 0], [60, 0, 0], [60, 80, 0], [0, 80, 0]]},
    {"id": "long", "outline": [[-2.75, 0, 2.75], [-2.75, 80, 2.75], [-2.75, 80, 92.75], [-2.75, 0, 92.75]]},
    {"id": "short", "outline": [[62.75, 0, 2.75], [62.75, 80, 2.75], [62.75, 80, 32.75], [62.75, 0, 32.75]]}]}


class Plan(StudioTest):
    def plan(self, document, spec=None, **more):
        request = {"options": {}, **({"spec": spec} if spec else {}), **more}
        return self.studio.ask("POST", f"/api/documents/{document}/plan", json.dumps(request))

    def planned(self, *given, **more):
        answer = self.plan(*given, **more)
        self.assertTrue(answer.is_good, answer.body[:400])
        return answer.json()

    def channel(self):
        opened = self.studio.open("channel.json", json.dumps(CHANNEL).encode())
        self.assertTrue(opened.is_good, opened.body)
        return opened.json()["id"]

    def program(self, path, *arguments):
        done = subprocess.run([CLI, "bend", path, "--json", "-", "--quiet", *arguments], capture_output=True, text=True, timeout=120)
        return json.loads(done.stdout)["plan"]

    def test_the_plan_is_that_of_the_program(self):
        path = EXAMPLES / "bracket.step"
        document, _ = self.studio.open_example("bracket.step")
        for brake, arguments in (({}, []), ({"metal": "stainless", "clearance": 0.1}, ["--material", "stainless", "--clearance", "0.1"])):
            plan, wanted = self.planned(document, brake=brake), self.program(path, *arguments)
            self.assertEqual(plan["status"], "optimal")
            self.assertEqual(plan["cost"], wanted["cost"])
            self.assertEqual(len(plan["strokes"]), len(wanted["strokes"]))
            for key in ("turn_overs", "rotations", "tool_changes", "ungauged"):
                self.assertEqual(plan[key], wanted[key])
            for stroke in plan["strokes"]:
                self.assertIsNone(stroke["blocked"])
                self.assertIn(stroke["punch"], plan["tools"]["punches"])
                self.assertIn(stroke["die"], plan["tools"]["dies"])

    def test_a_scene_has_sheet_and_tools_where_they_stand(self):
        document, _ = self.studio.open_example("bracket.step")
        thickness = self.studio.shape(document, "result").report["sheet"]["thickness"]
        for stroke in self.planned(document)["strokes"]:
            scene = stroke["scene"]
            moments = scene["moments"]
            self.assertEqual(moments["turn"][0], 0)
            self.assertAlmostEqual(moments["turn"][-1], stroke["angle"], places=9)  # no springback
            self.assertAlmostEqual(moments["die"][0], -thickness, places=9)
            self.assertEqual({len(column) for column in moments.values()}, {len(moments["turn"])})
            # Segments stand side by side and are those of the stroke.
            self.assertEqual(sorted(length for _, length in scene["punch"]), sorted(stroke["punch_segments"]))
            for (a, length), (b, _) in itertools.pairwise(scene["punch"]):
                self.assertAlmostEqual(a + length, b, places=9)
            # The edge at the gauge is at the gauge's distance behind the bend line.
            (ox, oy), (ux, uy) = scene["origin"], scene["along"]
            side = 1 if scene["pattern_up"] else -1
            for x, y in scene["gauge"]:
                self.assertAlmostEqual(side * (ux * (y - oy) - uy * (x - ox)), stroke["gauge"]["distance"], places=6)

    def test_an_order_is_checked_and_what_collides_is_named(self):
        document = self.channel()
        plan = self.planned(document, CHANNEL)
        self.assertEqual(plan["status"], "optimal")
        order = [{"bends": stroke["bends"]} for stroke in plan["strokes"]]
        again = self.planned(document, CHANNEL, order=order)
        self.assertEqual((again["status"], again["cost"]), ("possible", plan["cost"]))
        self.assertEqual([s["scene"] for s in again["strokes"]], [s["scene"] for s in plan["strokes"]])
        other = self.planned(document, CHANNEL, order=order[::-1])
        self.assertEqual((other["status"], other["cost"]), ("blocked", None))
        self.assertEqual([s["bends"] for s in other["strokes"]], [s["bends"] for s in plan["strokes"]][::-1])
        self.assertIsNone(other["strokes"][0]["blocked"])
        blocked = other["strokes"][1]["blocked"]
        self.assertIn(blocked["tool"], ("punch", "upper beam"))
        self.assertTrue(blocked["with"].startswith("F"))
        self.assertGreater(blocked["depth"], 0.05)
        self.assertIn(blocked["hits"], blocked["sentence"])

    def test_orders_that_make_no_sense_are_problems(self):
        document = self.channel()
        for order, code, where in (([{"bends": ["B1"]}, {"bends": ["B1"]}], "bad_option", None), ([{"bends": ["B9"]}], "invalid_input", "/order/0"),
                                   ([{"bends": "B1"}], "invalid_input", "/order/0/bends"), ({"bends": []}, "invalid_input", "/order"),
                                   ([{"bends": ["B1"], "flattening": True}], "bad_option", None)):
            said = self.assert_problem(self.plan(document, CHANNEL, order=order), code)
            if where is not None:
                self.assertEqual(said["where"], where)
        self.assert_problem(self.plan(document, CHANNEL, brake={"springback": 50}))
        self.assert_problem(self.plan(document, CHANNEL, brake={"k": 0.4}))
        self.assert_problem(self.plan(document, CHANNEL, brake={"tools": {"name": "t.json", "content": "{}"}}))
        self.assertTrue(self.plan(document, CHANNEL).is_good)

    def test_tools_of_ones_own(self):
        document = self.channel()
        tools = json.loads(subprocess.run([CLI, "bend", "--print-tools"], capture_output=True, text=True, timeout=60).stdout)
        for punch in tools["punches"]:
            punch["id"] += "-mine"
        plan = self.planned(document, CHANNEL, brake={"tools": {"name": "mine.json", "content": json.dumps(tools)}})
        self.assertTrue(all(s["punch"].endswith("-mine") for s in plan["strokes"]))
        tools["dies"] = tools["dies"][:0]
        self.assert_problem(self.plan(document, CHANNEL, brake={"tools": {"content": json.dumps(tools)}}))


if __name__ == "__main__":
    main()
