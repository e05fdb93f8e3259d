#!/usr/bin/python3
"""tools/fetch_parts.py against a server of our own, which also does what servers do wrong."""

import contextlib
import hashlib
import http.server
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest
import urllib.parse
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", HERE.parents[1]))
SCRIPT = SOURCE / "tools" / "fetch_parts.py"
sys.path.insert(0, str(SOURCE / "tools"))
import fetch_parts  # noqa: E402
import step_solids  # noqa: E402
from known_parts import catalogue  # noqa: E402
from known_parts.step_text import step_text  # noqa: E402

COMMIT = "0123456789abcdef0123456789abcdef01234567"
POINTER = b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"


class Server:
    """Serves `files` by path; `cut` are sent by half, `busy` are refused so many times."""

    def __init__(self):
        self.files, self.cut, self.busy, self.asked = {}, set(), {}, []
        outer = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                outer.answer(self)

            def log_message(self, *_):
                pass
        self.http = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.url = f"http://127.0.0.1:{self.http.server_address[1]}"
        threading.Thread(target=self.http.serve_forever, daemon=True).start()

    def answer(self, request):
        path = urllib.parse.unquote(request.path).lstrip("/")
        self.asked.append(path)
        if self.busy.get(path, 0) > 0:
            self.busy[path] -= 1
            return request.send_error(503)
        if path not in self.files:
            return request.send_error(404)
        data = self.files[path]
        request.send_response(200)
        request.send_header("Content-Length", str(len(data)))
        request.end_headers()
        with contextlib.suppress(OSError):
            request.wfile.write(data[:len(data) // 2] if path in self.cut else data)
        return None

    def close(self):
        self.http.shutdown()
        self.http.server_close()


def sha(data):
    return hashlib.sha256(data).hexdigest()


def row(name, path, data, **more):
    return {"id": name, "class": "sheet_metal", "repository": "maker/parts", "commit": COMMIT,
            "path": path, "sha256": sha(data), "bytes": len(data), "licence": "CC0", **more}


class Fetch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        parts = catalogue.bent()
        cls.solids = {name: parts[name].solid for name in ("angle", "zed", "hat", "angle_inch")}
        cls.steps = {name: step_text(name, [(name, solid, False)]).encode()
                     for name, solid in cls.solids.items()}
        cls.both = step_text("both", [("hat", cls.solids["hat"], True), ("zed", cls.solids["zed"], False),
                                      ("more", cls.solids["angle_inch"], True)]).encode()

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-fetch-")
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)
        self.to = self.dir / "parts"
        self.server = Server()
        self.addCleanup(self.server.close)
        self.rows = []

    def offer(self, name, path, data, **more):
        self.rows.append(row(name, path, data, **more))
        self.server.files[f"maker/parts/{COMMIT}/{path}"] = data
        return f"maker/parts/{COMMIT}/{path}"

    def offer_solid(self, name, whole, path="both.step"):
        """A part that is one solid of a larger file; the list has the checksum of another copy."""
        file = step_solids.StepSolids(self.steps[name])
        solid = {"index": 1, **file.facts(file.solids[0])}
        self.offer(name, path, b"written anew", source_sha256=sha(whole), solid=solid)
        self.server.files[f"maker/parts/{COMMIT}/{path}"] = whole

    def run_script(self, *options):
        listed = self.dir / "list.jsonl"
        listed.write_text("".join(json.dumps(r) + "\n" for r in self.rows), encoding="utf-8")
        done = subprocess.run([sys.executable, str(SCRIPT), "--parts", str(listed), "--to", str(self.to),
                               "--mirror", self.server.url, *options],
                              capture_output=True, text=True, timeout=120, check=False,
                              env=os.environ | {"no_proxy": "127.0.0.1"})
        self.assertEqual([p for p in self.dir.rglob("*.part")], [], "half files")
        return done.returncode, done.stdout

    def there(self):
        return sorted(p.name for p in self.to.glob("*.step"))

    def test_brings_what_is_listed_and_nothing_twice(self):
        self.offer("a", "plain.step", self.steps["angle"])
        self.offer("b", "Thin & bent/Größe #2 %.stp", self.steps["zed"])
        status, out = self.run_script()
        self.assertEqual((status, self.there()), (0, ["a.step", "b.step"]), out)
        self.assertEqual((self.to / "b.step").read_bytes(), self.steps["zed"])
        self.assertIn("2 of 2 parts are in", out)
        asked = len(self.server.asked)
        status, out = self.run_script()
        self.assertEqual((status, len(self.server.asked)), (0, asked))
        self.assertIn("2 of them were there before", out)
        self.assertEqual(self.run_script("--check")[0], 0)

    def test_one_part_alone(self):
        self.offer("a", "a.step", self.steps["angle"])
        self.offer("b", "b.step", self.steps["zed"])
        self.assertEqual(self.run_script("--only", "b")[0], 0)
        self.assertEqual(self.there(), ["b.step"])
        self.assertEqual(self.run_script("--only", "c")[0], 2)

    def test_a_failure_is_one_sentence_and_the_others_are_brought(self):
        self.offer("gone", "gone.step", self.steps["angle"])
        self.server.files.clear()
        other = self.offer("other", "other.step", self.steps["zed"])
        self.server.files[other] = self.steps["hat"]
        self.server.cut.add(self.offer("half", "half.step", self.steps["zed"]))
        self.offer("good", "good.step", self.steps["hat"])
        status, out = self.run_script()
        self.assertEqual((status, self.there()), (1, ["good.step"]), out)
        lines = out.splitlines()
        self.assertEqual(len(lines), 4, out)
        self.assertRegex(lines[0], r"^gone: the server answers 404 \(Not Found\) for http.*\.$")
        self.assertRegex(lines[1], r"^other: http.* is another file than listed: its SHA-256 is .*\.$")
        self.assertRegex(lines[2], r"^half: only \d+ bytes of http.* arrived\.$")
        self.assertIn("1 of 4 parts are in", lines[3])

    def test_goes_on_where_it_stopped(self):
        self.offer("a", "a.step", self.steps["angle"])
        path = self.offer("b", "b.step", self.steps["zed"])
        data = self.server.files.pop(path)
        self.assertEqual(self.run_script()[0], 1)
        self.server.files[path] = data
        self.server.asked.clear()
        self.assertEqual(self.run_script()[0], 0)
        self.assertEqual(self.server.asked, [path])

    def test_a_busy_server_is_asked_again(self):
        path = self.offer("a", "a.step", self.steps["angle"])
        self.server.busy[path] = 1
        self.assertEqual(self.run_script()[0], 0)
        self.assertEqual(self.server.asked, [path, path])

    def test_a_server_that_is_not_there(self):
        self.offer("a", "a.step", self.steps["angle"])
        status, out = self.run_script("--mirror", "http://127.0.0.1:1")
        self.assertEqual((status, self.there()), (1, []))
        self.assertIn("a: http://127.0.0.1:1/", out)
        self.assertIn("cannot be reached", out)

    def test_a_damaged_file_is_found_and_brought_again(self):
        self.offer("a", "a.step", self.steps["angle"])
        self.run_script()
        (self.to / "a.step").write_bytes(self.steps["angle"][:-40])
        status, out = self.run_script("--check")
        self.assertEqual(status, 1)
        self.assertIn("a: the file is another than listed (SHA-256).", out)
        self.assertEqual(self.run_script()[0], 0)
        self.assertEqual((self.to / "a.step").read_bytes(), self.steps["angle"])

    def test_check_says_what_is_missing_and_asks_nobody(self):
        self.offer("a", "a.step", self.steps["angle"])
        status, out = self.run_script("--check")
        self.assertEqual((status, self.server.asked), (1, []))
        self.assertIn("a: it is not there.", out)

    def test_a_member_of_an_archive(self):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as archive:
            archive.writestr("in here/zed.step", self.steps["zed"])
        path = self.offer("z", "parts.zip", self.steps["zed"], member="in here/zed.step")
        self.server.files[path] = packed.getvalue()
        self.assertEqual(self.run_script()[0], 0)
        self.assertEqual((self.to / "z.step").read_bytes(), self.steps["zed"])

    def test_a_file_that_git_keeps_elsewhere(self):
        path = self.offer("a", "a.step", self.steps["angle"])
        self.server.files["media/" + path] = self.server.files[path]
        self.server.files[path] = POINTER
        self.assertEqual(self.run_script()[0], 0)
        self.assertEqual((self.to / "a.step").read_bytes(), self.steps["angle"])

    def test_a_solid_is_taken_out_of_a_larger_file(self):
        self.offer_solid("zed", self.both)
        self.offer_solid("hat", self.both)  # listed in mm, in inches there
        status, out = self.run_script()
        self.assertEqual((status, self.there()), (0, ["hat.step", "zed.step"]), out)
        self.assertEqual(len(self.server.asked), 1, "the larger file is brought once")
        self.assertEqual(self.run_script("--check")[0], 0)
        for name in ("hat", "zed"):
            file = step_solids.StepSolids((self.to / f"{name}.step").read_bytes())
            alone = step_solids.StepSolids(self.steps[name])
            self.assertEqual(len(file.solids), 1)
            self.assertTrue(step_solids.matches(file.facts(file.solids[0]), alone.facts(alone.solids[0])))
        (self.to / "zed.step").write_bytes(self.steps["angle"])
        status, out = self.run_script("--check")
        self.assertIn("zed: the file does not hold the solid that is listed.", out)

    def test_a_larger_file_without_the_solid(self):
        self.offer_solid("angle", self.both)
        status, out = self.run_script()
        self.assertEqual((status, self.there()), (1, []))
        self.assertIn("none of the 3 solids in", out)

    @unittest.skipUnless("PLANISH_CLI" in os.environ, "needs the program")
    def test_what_is_taken_out_unfolds_as_it_does_alone(self):
        self.offer_solid("zed", self.both)
        self.run_script()
        areas = []
        (self.dir / "zed.step").write_bytes(self.steps["zed"])
        for path in (self.to / "zed.step", self.dir / "zed.step"):
            subprocess.run([os.environ["PLANISH_CLI"], "unfold", str(path), "--check", "--quiet", "--json",
                            str(self.dir / "report.json")], timeout=100, check=True)
            areas.append(json.loads((self.dir / "report.json").read_text())["flat"]["area"])
        self.assertAlmostEqual(areas[0], areas[1], places=9)


class List(unittest.TestCase):
    """tests/corpus/parts.jsonl itself."""

    def test_is_complete_sorted_and_well_formed(self):
        rows = fetch_parts.read_list(HERE / "parts.jsonl")
        names = [r["id"] for r in rows]
        self.assertEqual(names, sorted(set(names)))
        self.assertEqual(len(rows), 207)
        for r in rows:
            self.assertRegex(r["commit"], r"^[0-9a-f]{40}$", r["id"])
            self.assertRegex(r["sha256"], r"^[0-9a-f]{64}$", r["id"])
            self.assertEqual("solid" in r, "source_sha256" in r, r["id"])
            self.assertRegex(r["repository"], r"^[\w.-]+/[\w.-]+$", r["id"])
            self.assertTrue(r["licence"] and r["class"], r["id"])
            self.assertTrue(fetch_parts.url_of(r).isascii(), r["id"])

    def test_the_parts_that_are_there_are_those_listed(self):
        folder = pathlib.Path(os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts")
        if not folder.is_dir():
            self.skipTest("the real parts are not there: tools/fetch_parts.py brings them")
        for r in fetch_parts.read_list(HERE / "parts.jsonl"):
            self.assertIn(fetch_parts.state(r, folder), ("", "it is not there"), r["id"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
