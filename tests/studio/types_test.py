#!/usr/bin/python3
"""The page's types (web/src/types.ts, and those made from the schemas) against what the server answers and takes.

Answers are written down as TypeScript, each with the type that it should have, and compiled: a key that is missing,
of another kind, or not in the types is an error of the compiler."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
import step_files  # noqa: E402
from planish_studio import CLI, EXAMPLES, SOURCE, StudioTest, main  # noqa: E402

WEB = SOURCE / "web"
FILES = {"connect": ("plates", "Plates"), "transition": ("transition", "Transition"), "slit": ("slits", "Slits")}  # their modules and types
# Every option, with a value that the kind takes.
OPTIONS = {
    "unfold": {"body": 1, "thickness": 2, "root": "largest", "up": "other", "rip_edges": "21", "din6935": True, "bend_k": {"B1": 0.4}, "density": 7.85, "units": "inch",
               "extruded": "through", "shop": {"name": "shop.json", "content": {"format": "planish/shop", "materials": [{"name": "steel", "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]}]}},
               "materials": {"name": "m.csv", "content": "part;material\n*;steel\n"}, "process": "punch", "relief": "round", "bend_relief": "square", "rip_width": 0.3,
               "material": {"content": {"tension": {"power_law": {"strength": 500, "exponent": 0.2}}}}},
    "transition": {"piece": 0, "k": 0.4},
    "slit": {"write_overlapping": False, "write_anyway": False, "arc_tolerance": 0.1, "bend_marks": "ticks", "tick_length": 3, "tangent_lines": True, "bend_text": True, "turn_to_blank": True, "overbend": True},
    "connect": {"inside_radius": 1, "lateral": "arc", "trade_off": 0.5, "largest_span": 500, "trim": "no", "profile": "onshape", "splines": "arcs", "r12": True, "no_rules": True,
                "k_table": {"name": "steel.csv", "content": "r/t, k\n1, 0.4\n"}, "rules": {"content": {"k_low": 0.1}}}}


class Types(StudioTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        subprocess.run(["npm", "run", "--silent", "types"], cwd=WEB, check=True, timeout=60)

    def setUp(self):
        self.lines, self.names, self.modules = [], set(), {}

    def expect(self, value, type_name):
        self.names |= set(re.findall(r"[A-Z]\w+", type_name)) - {"Record", "Required"}
        self.lines.append(f"export const a{len(self.lines)}: {type_name} = {json.dumps(value)};")

    def shape(self, document, verb, spec, **options):
        shape = self.studio.shape(document, verb, spec, **options)
        self.expect(shape.json, "ShapeHeader")
        return shape

    def compiled(self):
        """What the compiler has against the answers."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "answers.ts"
            types = WEB / "src" / "types.ts"
            imports = [f"import type {{ {name} }} from '{self.modules.get(name, types)}';" for name in sorted(self.names)]
            path.write_text("\n".join(imports + self.lines) + "\n")
            done = subprocess.run([WEB / "node_modules" / ".bin" / "tsc", "--noEmit", "--strict", "--skipLibCheck", "--target", "es2022", "--module", "esnext",
                                   "--moduleResolution", "bundler", "--allowImportingTsExtensions", path],
                                  cwd=WEB, capture_output=True, text=True, timeout=280)
            return (done.stdout + done.stderr)[:3000]

    def small(self, name):
        """An example with its spec, of which slit sheets are not subdivided."""
        document, spec = self.studio.open_example(name)
        return document, {**spec, "subdivisions": 0} if name.startswith("slit/") else spec

    def test_answers_are_of_their_types(self):
        self.expect(self.studio.get("/api/examples").json(), "Example[]")
        for name in ("bracket.step", "connect/a_folded.json", "connect/d_irregular.json", "transition/a_square_to_round.json",
                     "transition/h_hexagon_to_round.json", "slit/chair.json", "slit/scanned_chair.json"):
            document, spec = self.small(name)
            for verb in ("draft", "result"):
                self.shape(document, verb, spec)
        self.expect(self.studio.get("/api/documents").json(), "OpenDocument[]")
        self.expect(self.studio.get(f"/api/documents/{document}/progress").json(), "Progress | null")
        self.expect(json.loads(self.studio.post(document, "result", {**spec, "thickness": "thick"}).body), "ApiProblem")
        self.expect(self.studio.get("/api/documents/d999/progress").json(), "ApiProblem")
        document, spec = self.small("transition/a_square_to_round.json")
        self.shape(document, "result", {**spec, "pieces": 2}, piece=1)
        self.assertEqual(self.compiled(), "")

    def test_orders_of_strokes_are_of_their_type(self):
        document, spec = self.studio.open_example("connect/a_folded.json")
        brake = {"metal": "stainless", "springback": 2, "clearance": 0.1, "shortfall": 3, "opening": 12,
                 "v": "wanted", "as_drawn": False, "large_radii": "roll", "chord_error": 0.3, "gauge_openings": True, "weights": "turn_over=4", "fix": "B1",
                 "search_time": 3, "tools": {"name": "tools.json", "content": subprocess.run([CLI, "bend", "--print-tools"], capture_output=True, text=True, timeout=60).stdout}}
        self.expect(brake, "Required<BrakeOptions>")
        for more in ({}, {"brake": brake}, {"order": []}):
            answer = self.studio.ask("POST", f"/api/documents/{document}/plan", json.dumps({"spec": spec, "options": {}, **more}))
            self.assertTrue(answer.is_good, answer.body[:300])
            self.assertTrue(answer.json()["strokes"])
            self.expect(answer.json(), "OrderAnswer")
        self.assertEqual(self.compiled(), "")

    def test_what_is_refused_is_of_its_type(self):
        document, spec = self.studio.open_example("connect/a_folded.json")
        corners = {"floor": [[0, 0, 0], [100, 0, 0], [100, 100, 0], [0, 100, 0]], "up": [[106, 0, 6], [106, 200, 6], [106, 200, 100], [106, 0, 100]],
                   "down": [[0, 106, -6], [200, 106, -6], [200, 106, -100], [0, 106, -100]]}
        overlapping = {"thickness": 2, "plates": [{"id": name, "outline": outline} for name, outline in corners.items()]}
        self.assertEqual(self.shape(document, "result", overlapping).report["status"], "refused")
        self.assertEqual(self.compiled(), "")

    def test_examples_are_of_the_types_of_their_files(self):
        for kind, (module, type_name) in FILES.items():
            self.modules[type_name] = WEB / "generated" / f"{module}.ts"
            for path in sorted((EXAMPLES / kind).glob("*.json")):
                spec = json.loads(path.read_text())
                # What its author says of it.
                self.expect({key: value for key, value in spec.items() if key not in ("title", "notes")}, type_name)
        self.assertEqual(self.compiled(), "")

    def test_every_option_is_known_to_both(self):
        every = {key: value for options in OPTIONS.values() for key, value in options.items()}
        self.expect(every, "Required<Options>")
        self.assertEqual(self.compiled(), "")
        for kind, options in OPTIONS.items():
            name = {"unfold": "bracket.step", "connect": "connect/a_folded.json", "transition": "transition/a_square_to_round.json", "slit": "slit/chair.json"}[kind]
            document, spec = self.small(name) if kind != "unfold" else self.studio.open_example(name)
            for key, value in options.items():
                # The length of ticks goes with ticks.
                given = {"bend_marks": "ticks"} if key == "tick_length" else {}
                # A rip needs a closed part.
                part = self.studio.open("tube.step", step_files.square_tube()).json()["id"] if key == "rip_edges" else document
                answer = self.studio.post(part, "draft", spec, **given, **{key: value})
                self.assertTrue(answer.is_good, (kind, key, answer.body[:300]))
        self.assertEqual(self.studio.post(document, "draft", spec, no_such_option=1).status, 400)

    def test_every_artifact_of_the_description_can_be_had(self):
        description = self.studio.get("/api/description").json()
        self.expect(description, "Description")
        self.assertEqual(self.compiled(), "")
        names = {"unfold": "bracket.step", "connect": "connect/a_folded.json", "transition": "transition/a_square_to_round.json", "slit": "slit/arch.json"}
        types = {row["name"]: row["media_type"] for row in description["artifacts"]}
        self.assertEqual({row["name"] for row in description["makers"]}, set(names))
        for row in description["makers"]:
            document, spec = self.studio.open_example(names[row["name"]])
            for name in row["artifacts"]:
                answer = self.studio.post(document, f"files/{name}", spec)
                self.assertTrue(answer.is_good, (row["name"], name, answer.body[:300]))
                self.assertEqual(answer.headers["content-type"], types[name])
            self.assertEqual(self.studio.post(document, "files/spec", spec).is_good, row["editable"])

    def test_arrays_are_those_that_the_page_knows(self):
        known = subprocess.run(["npx", "tsx", "-e", f"import {{ arrayNames }} from '{WEB}/src/shape.ts'; console.log(arrayNames.join(' '))"],
                               cwd=WEB, capture_output=True, text=True, timeout=60).stdout.split()
        document, spec = self.studio.open_example("connect/a_folded.json")
        self.assertLessEqual(set(self.studio.shape(document, "result", spec).arrays), set(known))


if __name__ == "__main__":
    main()
