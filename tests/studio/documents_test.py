#!/usr/bin/python3
"""Documents of each kind from opening to a DXF that another program reads; what is refused, with the program's sentence."""

import io
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import ezdxf

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
from planish_studio import CLI, EXAMPLES, Shape, Studio, StudioTest, main, until  # noqa: E402
import step_files  # noqa: E402

EXAMPLE = {"unfold": "bracket.step", "connect": "connect/a_folded.json", "transition": "transition/a_square_to_round.json", "slit": "slit/chair.json"}
FORMATS = {"unfold": ["dxf", "svg", "step", "stl", "obj", "json"], "connect": ["dxf", "svg", "flat.step", "step", "stl", "obj", "json", "spec"],
           "transition": ["dxf", "svg", "step", "stl", "json", "spec"], "slit": ["dxf", "svg", "step", "stl", "obj", "mould.stl", "mould.obj", "mould.step", "json", "spec"]}


def extent(dxf):
    document = ezdxf.read(io.StringIO(dxf.decode()))
    assert not document.audit().has_errors
    points = [p for e in document.modelspace().query("LWPOLYLINE") for p in e.get_points("xy")]
    return [max(p[i] for p in points) - min(p[i] for p in points) for i in (0, 1)]


class Kinds(StudioTest):
    def test_each_from_opening_to_its_files(self):
        for kind, example in EXAMPLE.items():
            document, spec = self.studio.open_example(example)
            listed = {row["id"]: row for row in self.studio.get("/api/documents").json()}
            self.assertEqual(listed[document]["kind"], kind)
            self.assertEqual(listed[document]["name"], pathlib.Path(example).name)
            shape = self.studio.shape(document, "result", spec)
            self.assertIn(shape.report["status"], ("ok", "warning"))
            for form in FORMATS[kind]:
                with self.subTest(kind=kind, format=form):
                    made = self.studio.post(document, f"files/{form}", spec)
                    self.assertTrue(made.is_good, made.body[:300])
                    self.check_file(form, made.body, spec, shape)
            self.assert_problem(self.studio.post(document, "files/exe", spec), "bad_option")

    def check_file(self, form, content, spec, shape):
        if form == "dxf":
            flat = shape.report["flat"]
            xs, ys = shape.arrays["points"][0::2], shape.arrays["points"][1::2]
            for got, wanted in zip(extent(content), (max(xs) - min(xs), max(ys) - min(ys))):
                self.assertAlmostEqual(got, wanted, delta=0.2)
            self.assertGreater(flat["area"], 0)
        elif form == "svg":
            self.assertIn(b"<svg", content[:400])
        elif form.endswith("step"):
            self.assertTrue(content.startswith(b"ISO-10303-21;"))
        elif form.endswith("stl"):
            self.assertEqual(len(content), 84 + 50 * int.from_bytes(content[80:84], "little"))
            self.assertGreater(len(content), 84 + 50 * 4)
        elif form.endswith("obj"):
            self.assertGreater(content.count(b"\nf "), 4)
        elif form == "spec":
            self.assertEqual(json.loads(content), spec)
            self.assertGreater(content.count(b"\n"), 5)
        else:
            self.assertEqual(json.loads(content)["flat"], shape.report["flat"])

    def test_options_of_files_are_those_of_the_dxf(self):
        document, _ = self.studio.open_example("bracket.step")
        mm, inch = (extent(self.studio.post(document, "files/dxf", units=units).body) for units in ("mm", "inch"))
        self.assertAlmostEqual(mm[0], 25.4 * inch[0], delta=1e-6)
        r12 = ezdxf.read(io.StringIO(self.studio.post(document, "files/dxf", r12=True, profile="inventor").body.decode()))
        self.assertEqual(r12.dxfversion, "AC1009")
        self.assertIn("IV_OUTER_PROFILE", {layer.dxf.name for layer in r12.layers})

    def test_the_result_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "report.json"
            for kind, example in EXAMPLE.items():
                subprocess.run([CLI, kind, EXAMPLES / example, "--check", "--quiet", "--json", report], check=True, timeout=120)
                told = json.loads(report.read_text())
                document, spec = self.studio.open_example(example)
                shown = self.studio.shape(document, "result", spec).report
                self.assertEqual(shown["flat"], told["flat"], kind)
                self.assertEqual([c["code"] for c in shown["checks"]], [c["code"] for c in told["checks"]])

    def test_info_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([CLI, "info", "bracket.step", "--json", f"{folder}/info.json"], cwd=EXAMPLES, check=True, timeout=60, stdout=subprocess.DEVNULL)
            opened = self.studio.open("bracket.step", (EXAMPLES / "bracket.step").read_bytes()).json()
            self.assertEqual(opened["info"], json.loads(pathlib.Path(folder, "info.json").read_text()))
            self.assertIsNone(opened["text"])

    def test_bodies_are_chosen_by_number(self):
        opened = self.studio.open("three.step", step_files.two_angles_and_a_block())
        document = opened.json()["id"]
        bodies = opened.json()["info"]["bodies"]
        self.assertEqual([self.studio.shape(document, "draft", body=b["number"]).report["body"] for b in bodies], [b["name"] for b in bodies])
        self.assert_problem(self.studio.post(document, "draft", body=len(bodies) + 1), "no_such_body")

    def test_pieces_are_chosen_by_number(self):
        document, spec = self.studio.open_example("transition/h_hexagon_to_round.json")
        pieces = self.studio.shape(document, "result", spec).report["pieces"]
        self.assertGreater(len(pieces), 1)
        shapes = [self.studio.shape(document, "draft", spec, piece=i) for i in range(len(pieces))]
        self.assertTrue(all(len(shape.arrays["points"]) for shape in shapes))
        self.assert_problem(self.studio.post(document, "draft", spec, piece=len(pieces)), "bad_option")
        self.assertGreater(extent(self.studio.post(document, "files/dxf", spec, piece=1).body)[0], 10)

    def test_scans_are_attachments(self):
        document, spec = self.studio.open_example("slit/scanned_chair.json")
        shape = self.studio.shape(document, "result", spec)
        self.assertGreater(len(shape.json["handles"]["scan"]), 100)
        self.assertLessEqual(len(shape.json["handles"]["scan"]), 5000)

    def test_what_was_changed_is_what_is_computed(self):
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        low = self.studio.shape(document, "draft", spec).report["flat"]["area"]
        spec["to"]["frame"]["origin"][2] = 400
        self.assertGreater(self.studio.shape(document, "draft", spec).report["flat"]["area"], 1.2 * low)


class Opening(StudioTest):
    CONTENT = (EXAMPLES / "transition/a_square_to_round.json").read_bytes()

    def listed(self):
        return self.studio.get("/api/documents").json()

    def test_a_file_is_taken_before_it_is_read(self):
        taken = self.studio.take("räumlich.json", self.CONTENT).json()
        self.assertEqual(sorted(taken), ["id", "name"])
        self.assertEqual(taken["name"], "räumlich.json")
        self.assertEqual(self.listed(), [])
        self.assertEqual(self.studio.workers(), [])
        opened = self.studio.open_taken(taken["id"]).json()
        self.assertEqual({**opened, "text": None},
                         {"id": taken["id"], "given": False, "kind": "transition", "name": "räumlich.json", "info": None, "text": None})
        self.assertEqual(opened["text"].encode(), self.CONTENT)
        self.assertEqual(self.listed(), [opened])

    def test_asked_again_it_answers_the_same(self):
        document = self.studio.take("a.json", self.CONTENT).json()["id"]
        first = self.studio.open_taken(document)
        (worker,) = self.studio.workers()
        os.kill(worker, signal.SIGKILL)
        self.assertTrue(until(lambda: not self.studio.workers()))
        self.assertEqual(self.studio.open_taken(document).body, first.body)
        self.assertEqual(self.studio.workers(), [])

    def test_what_was_not_opened_is_opened_when_it_is_asked_for(self):
        for verb in ("draft", "result", "files/dxf"):
            document = self.studio.take("a.json", self.CONTENT).json()["id"]
            self.assertTrue(self.studio.post(document, verb, json.loads(self.CONTENT)).is_good)
            self.assertIn(document, [row["id"] for row in self.listed()])

    def test_what_cannot_be_read_stays_until_it_is_closed(self):
        document = self.studio.take("a.json", b"{}").json()["id"]
        for _ in range(2):
            self.assert_problem(self.studio.open_taken(document), "invalid_input")
        for verb in ("draft", "files/dxf"):
            self.assert_problem(self.studio.post(document, verb, {}), "invalid_input")
        self.assertEqual(self.listed(), [])
        self.assertEqual(self.studio.workers(), [])
        self.assertEqual(self.studio.ask("DELETE", f"/api/documents/{document}").status, 204)
        self.assert_error(self.studio.open_taken(document), 404, "no_such_document")

    def test_what_cannot_be_read_makes_room(self):
        unread = [self.studio.take("a.json", self.CONTENT).json()["id"] for _ in range(6)]
        unreadable = [self.studio.take("a.json", b"{}").json()["id"] for _ in range(2)]
        self.assert_error(self.studio.take("a.json", self.CONTENT), 429, "too_many_documents")
        for document in unreadable:
            self.assert_problem(self.studio.open_taken(document))
        for left in (unreadable[1:], []):
            self.assertTrue(self.studio.open("a.json", self.CONTENT).is_good)
            self.assertEqual([d for d in unreadable if self.studio.get(f"/api/documents/{d}/progress").status == 200], left)
        self.assert_error(self.studio.take("a.json", self.CONTENT), 429, "too_many_documents")
        self.assertTrue(self.studio.open_taken(unread[0]).is_good)


class Rubbish(StudioTest):
    def test_files_that_are_none(self):
        step = (EXAMPLES / "bracket.step").read_bytes()
        for name, content, code in (("a.step", b"", "empty_file"), ("a.step", b"\0\1\2" * 100, "not_step"), ("a.step", b"hello", "not_step"),
                                    ("a.step", step[:2000], "truncated_file"), ("a.step", step_files.surface_only(), "shell_not_solid"),
                                    ("a.json", b"{", "invalid_input"), ("a.json", b"[]", "invalid_input"), ("a.json", b"{}", "invalid_input"),
                                    ("a.json", b'{"format": "planish/cake"}', "invalid_input"), ("a.json", b'{"plates": 3}', "invalid_input"),
                                    ("a.json", b'{"from": {}, "to": {}}', "invalid_input"), ("a.json", b'{"leg_curve": 1}', "invalid_input"),
                                    ("a.json", b'{"plates": "\xff\xfe"}', "invalid_input"), ("a.json", b"[" * 100_000, "invalid_input"),
                                    ("a.json", b'{"a":' * 5000 + b"1" + b"}" * 5000, "invalid_input")):
            with self.subTest(name=name, content=content[:30]):
                self.assert_problem(self.studio.open(name, content), code)
        self.assertEqual(self.studio.get("/api/documents").json(), [])

    def test_the_sentence_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "a.json").write_text('{"thickness": -1, "plates": []}')
            done = subprocess.run([CLI, "connect", "a.json", "--check"], cwd=folder, capture_output=True, text=True, timeout=60)
            error = self.assert_problem(self.studio.open("a.json", pathlib.Path(folder, "a.json").read_bytes()))
            self.assertIn(error["message"].rstrip("."), done.stderr)
            self.assertEqual(error["where"], "a.json/thickness")

    def test_requests_that_are_none(self):
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        for body in (b"", b"no", b"[]", b"{", b'{"what": 1}', b'{"options": 1}', b'{"options": {"k": 2}}', b'{"options": {"k": "x"}}',
                     b'{"options": {"cake": true}}', b'{"options": {"piece": -1}}', b'{"options": {"profile": "x"}}', b'{"options": {"bend_k": {"B1": 7}}}',
                     b'{"spec": ' + b"[" * 50_000 + b"]" * 50_000 + b"}"):
            self.assert_error(self.studio.ask("POST", f"/api/documents/{document}/draft", body), 400, "bad_request")
        self.assert_problem(self.studio.post(document, "draft"), "bad_option")
        self.assert_problem(self.studio.post(document, "draft", spec, din6935=True), "bad_option")
        error = self.assert_problem(self.studio.post(document, "draft", dict(spec, thickness=-1)), "invalid_input")
        self.assertEqual(error["where"], "a_square_to_round.json/thickness")
        self.assertTrue(self.studio.post(document, "draft", spec).is_good)

    def test_files_of_options_are_input(self):
        document, _ = self.studio.open_example("bracket.step")
        shop = json.loads((EXAMPLES / "shop" / "example.json").read_text())
        del shop["materials"][0]["gauges"]
        for options, where in (({"shop": {"content": shop}}, "/options/shop/content/materials/0"),
                               ({"k_table": {"name": "a.csv", "content": "r/t, k\n1, 3\n"}}, "/options/k_table/content"),
                               ({"k_table": {"content": "nothing"}}, "/options/k_table/content")):
            error = self.assert_problem(self.studio.post(document, "draft", **options))
            self.assertTrue(error["where"].startswith(where), error)

    def test_faces_that_are_none(self):
        document, _ = self.studio.open_example("bracket.step")
        self.assert_problem(self.studio.post(document, "draft", root=9999), "no_such_face")
        self.assert_error(self.studio.post(document, "draft", up="sideways"), 400, "bad_request")

    def test_files_of_what_is_refused(self):
        document = self.studio.open("block.step", step_files.block()).json()["id"]
        self.assert_problem(self.studio.post(document, "files/dxf"), "not_a_sheet")
        self.assertEqual(self.studio.post(document, "files/json").json()["status"], "refused")

    def test_files_of_what_has_an_error_are_there_for_the_asking(self):
        # A plate that comes back through the bend between the two others.
        plates = [[[0, 0, 0], [200, 0, 0], [200, 100, 0], [0, 100, 0]],
                  [[0, 120, 20], [200, 120, 20], [200, 120, 120], [0, 120, 120]],
                  [[50, 72.4, 109.9], [150, 72.4, 109.9], [150, 118.1, -1.1], [50, 118.1, -1.1]]]
        spec = {"thickness": 4, "plates": [{"id": name, "outline": outline} for name, outline in zip("ABC", plates)],
                "bends": [{"between": ["A", "B"], "inside_radius": 12}, {"between": ["B", "C"]}]}
        document = self.studio.open("through.json", json.dumps(spec)).json()["id"]
        shape = self.studio.shape(document, "result", spec)
        self.assertEqual(shape.report["status"], "refused")
        self.assertGreater(len(shape.arrays["points"]), 0)  # it is seen all the same
        error = self.assert_problem(self.studio.post(document, "files/dxf", spec), "self_intersection")
        self.assertEqual(error["remedy"]["option"], "--write-anyway")
        self.assertTrue(self.studio.post(document, "files/dxf", spec, write_anyway=True).is_good)

    def test_documents_that_are_not_there(self):
        for document in ("d99", "d", "x", "d-1", "d1x", "1"):
            for method, what in (("POST", "draft"), ("POST", "result"), ("POST", "open"), ("POST", "files/dxf"), ("POST", "cancel"), ("GET", "progress"), ("PUT", "attachments/a.xyz")):
                self.assert_error(self.studio.ask(method, f"/api/documents/{document}/{what}", b"{}" if method != "GET" else None), 404)
            self.assert_error(self.studio.ask("DELETE", f"/api/documents/{document}"), 404)

    def test_names_with_folders(self):
        for name in ("", "../a.step", "/etc/passwd", "a/b.step", ".hidden", "..", "a\\b", "a\nb", "x" * 300):
            self.assert_problem(self.studio.open(name, b"x"), "invalid_input")
        for name in ("%ff.step", "%c3.step", "a%00b"):
            self.assert_problem(self.studio.ask("POST", f"/api/documents?name={name}", b"x"), "invalid_input")
        document, _ = self.studio.open_example("slit/chair.json")
        for name in ("%ff", "..", "..%2Fa", "%2Fetc%2Fpasswd", "a%5Cb", ".a", "a%00b", "x" * 300, ""):
            answer = self.studio.ask("PUT", f"/api/documents/{document}/attachments/{name}", b"0 0 0\n")
            self.assertTrue(answer.is_problem or answer.status in (400, 404), name)

    def test_slit_files_cannot_name_files_of_the_disk(self):
        document, spec = self.studio.open_example("slit/chair.json")
        for name in ("/etc/passwd", "../document", "../../../../etc/passwd", "./x", "a/b", "", ".", "..", "x" * 300):
            named = dict(spec, scan=[{"strip": 0, "points": name}])
            for verb in ("draft", "result", "files/dxf"):
                error = self.assert_problem(self.studio.post(document, verb, named), "invalid_input")
                self.assertEqual(error["where"], "chair.json/scan/0/points")
            self.assert_problem(self.studio.open("s.json", json.dumps(named)), "invalid_input")
        missing = dict(spec, scan=[{"strip": 0, "points": "missing.xyz"}])
        self.assertEqual(self.assert_problem(self.studio.post(document, "draft", missing), "cannot_read")["where"], "chair.json/scan/0/points")
        self.studio.ask("PUT", f"/api/documents/{document}/attachments/bad.xyz", b"root:x:0:0:\n")
        self.assert_problem(self.studio.post(document, "draft", dict(spec, scan=[{"strip": 0, "points": "bad.xyz"}])), "invalid_input")

    def test_an_attachment_that_is_replaced_counts(self):
        document, spec = self.studio.open_example("slit/chair.json")
        named = dict(spec, scan=[{"strip": 0, "points": "a.xyz"}])
        for height in (300.0, 200.0):
            put = self.studio.ask("PUT", f"/api/documents/{document}/attachments/a.xyz", f"300 {height} 30\n310 {height} 30\n".encode())
            self.assertEqual(put.status, 204)
            self.assertEqual(self.studio.shape(document, "result", named).json["handles"]["scan"][0][1], height)


class Many(StudioTest):
    def test_eight_documents_are_the_most(self):
        content = (EXAMPLES / "transition/a_square_to_round.json").read_bytes()
        for _ in range(8):
            self.assertTrue(self.studio.open("a.json", content).is_good)
        self.assert_error(self.studio.open("a.json", content), 429, "too_many_documents")
        first = self.studio.get("/api/documents").json()[0]["id"]
        self.assertEqual(self.studio.ask("DELETE", f"/api/documents/{first}").status, 204)
        self.assertTrue(self.studio.open("a.json", content).is_good)


class FirstDocument(StudioTest):
    arguments = (EXAMPLES / "slit/scanned_chair.json",)

    def test_the_file_of_the_command_line_is_open_with_its_scans(self):
        (document,) = self.studio.get("/api/documents").json()
        self.assertEqual((document["given"], document["kind"], document["name"]), (True, "slit", "scanned_chair.json"))
        self.assertEqual(self.studio.open_taken(document["id"]).json(), document)
        self.assertEqual(document["text"], (EXAMPLES / "slit/scanned_chair.json").read_text())
        shape = self.studio.shape(document["id"], "draft", json.loads(document["text"]))
        self.assertGreater(len(shape.json["handles"]["scan"]), 100)


class CommandLine(StudioTest):
    def run_cli(self, *arguments, status):
        done = subprocess.run([CLI, "studio", "--no-browser", *arguments], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def test_files_that_cannot_be_opened_end_it(self):
        self.assertIn("[cannot_read]", self.run_cli("/nothing/here.step", status=3))
        with tempfile.TemporaryDirectory() as folder:
            rubbish = pathlib.Path(folder, "a.step")
            rubbish.write_bytes(b"rubbish")
            self.assertIn("[not_step]", self.run_cli(str(rubbish), status=3))
        self.assertIn("/dev/zero is a device, not a file [cannot_read]", self.run_cli("/dev/zero", status=3))
        self.assertIn("--port", self.run_cli("--port", "0", status=2))
        self.assertIn("--port", self.run_cli("--port", "70000", status=2))
        for seconds in ("0", "86401", "1.5", "long"):
            self.assertIn("--time-limit", self.run_cli("--time-limit", seconds, status=2))

    def test_a_file_has_any_name(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("ü" * 52 + ".json", b"st\xfcck.json", "a\nb.json"):
                path = pathlib.Path(os.fsdecode(os.path.join(os.fsencode(folder), os.fsencode(name))))
                path.write_bytes((EXAMPLES / "connect/a_folded.json").read_bytes())
                with Studio(path) as studio:
                    (document,) = studio.get("/api/documents").json()
                    self.assertTrue(document["name"].endswith(".json"), document["name"])

    def test_help_names_what_there_is(self):
        done = subprocess.run([CLI, "studio", "--help"], capture_output=True, text=True, timeout=60, check=True)
        for word in ("--port", "--no-browser", "--time-limit", "FILE"):
            self.assertIn(word, done.stdout)
        self.assertNotIn("studio-worker", subprocess.run([CLI, "--help"], capture_output=True, text=True, timeout=60, check=True).stdout)

    def test_a_chosen_port_is_taken(self):
        with Studio() as free:
            port = free.port
        time.sleep(0.1)
        with Studio("--port", port) as chosen:
            self.assertEqual(chosen.port, port)
            self.assertEqual(chosen.get("/api/documents").json(), [])



class Kept(StudioTest):
    def test_what_is_kept_is_there_at_the_next_start(self):
        with tempfile.TemporaryDirectory() as state:
            with Studio(state=pathlib.Path(state) / "new") as studio:
                self.assertEqual(studio.get("/api/kept").json(), [])
                self.assertEqual(list(pathlib.Path(state).iterdir()), [])  # nothing is written before
                self.assertEqual(studio.ask("PUT", "/api/kept/b.json", b"old").status, 204)
                self.assertEqual(studio.ask("PUT", "/api/kept/b.json", b"\0new\xff").status, 204)
                self.assertEqual(studio.ask("PUT", "/api/kept/a%20b", b"").status, 204)
                shutil.copytree(pathlib.Path(state) / "new", pathlib.Path(state) / "kept")
            with Studio(state=pathlib.Path(state) / "kept") as studio:
                self.assertEqual(studio.get("/api/kept").json(), [{"name": "a b", "size": 0}, {"name": "b.json", "size": 5}])
                self.assertEqual(studio.get("/api/kept/b.json").body, b"\0new\xff")
                self.assertEqual(studio.ask("DELETE", "/api/kept/b.json").status, 204)
                self.assert_error(studio.get("/api/kept/b.json"), 404, "not_found")
                self.assert_error(studio.ask("DELETE", "/api/kept/b.json"), 404, "not_found")
                folder = pathlib.Path(state) / "kept/planish/studio"
                self.assertEqual([path.name for path in folder.iterdir()], ["a b"])

    def test_others_cannot_look_and_names_stay_in_the_folder(self):
        self.assert_error(self.studio.get("/api/kept", headers={"X-Planish-Token": None}), 403, "forbidden")
        self.assertEqual(self.studio.ask("PUT", "/api/kept/a", b"x").status, 204)
        folder = pathlib.Path(self.studio.state) / "planish/studio"
        self.assertEqual(folder.stat().st_mode & 0o777, 0o700)
        for name in ("..%2Fa", ".a", "%2Fetc%2Fpasswd", "a%00b"):
            self.assertIn(self.studio.ask("PUT", f"/api/kept/{name}", b"x").status, (200, 400, 404), name)
            self.assertIn(self.studio.get(f"/api/kept/{name}").status, (400, 404), name)
        self.assertEqual([path.name for path in folder.rglob("*")], ["a"])
        self.assertEqual([path.name for path in pathlib.Path(self.studio.state).iterdir()], ["planish"])

    def test_there_is_an_end_to_it(self):
        self.assert_error(self.studio.ask("PUT", "/api/kept/large", bytes((24 << 20) + 1)), 413, "too_large")
        for number in range(64):
            self.studio.ask("PUT", f"/api/kept/{number}", b"x")
        self.assert_error(self.studio.ask("PUT", "/api/kept/another", b"x"), 429, "too_many_files")
        self.assertEqual(self.studio.ask("PUT", "/api/kept/7", b"again").status, 204)
        for entry in self.studio.get("/api/kept").json():
            self.studio.ask("DELETE", f"/api/kept/{entry['name']}")

    def test_a_folder_that_cannot_be_made_is_said(self):
        with tempfile.NamedTemporaryFile() as file, Studio(state=file.name + "-") as studio:
            pathlib.Path(studio.state).symlink_to(file.name)
            self.assert_error(studio.ask("PUT", "/api/kept/a", b"x"), 500, "cannot_write")
            self.assertEqual(studio.get("/api/kept").json(), [])
            pathlib.Path(studio.state).unlink()
            pathlib.Path(studio.state).mkdir()


if __name__ == "__main__":
    main()
