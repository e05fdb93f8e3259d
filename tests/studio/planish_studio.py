"""Starts `planish studio` as a user does and talks to it as its page does."""

import contextlib
import http.client
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).parent / "../support"))
from processes import children_of, until  # noqa: E402, F401

CLI = os.environ.get("PLANISH_CLI", "planish")
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
EXAMPLES = SOURCE / "examples"
SECONDS = 120
TYPES = {"f32": "f", "u32": "I", "i32": "i"}


class Answer:
    def __init__(self, response):
        self.status = response.status
        self.headers = {key.lower(): value for key, value in response.getheaders()}
        self.body = response.read()

    def json(self):
        return json.loads(self.body)

    @property
    def is_problem(self):
        """Whether it is what the program says of invalid input."""
        return self.status == 200 and self.headers.get("content-type") == "application/problem+json"

    @property
    def is_good(self):
        return self.status == 200 and not self.is_problem


class Shape:
    """A shape's JSON, and its arrays as lists of numbers."""

    def __init__(self, content):
        assert content[:4] == b"PLN1", content[:40]
        (length,) = struct.unpack_from("<I", content, 4)
        assert (8 + length) % 4 == 0, length
        self.json = json.loads(content[8:8 + length])
        data = content[8 + length:]
        self.arrays, end = {}, 0
        for name, place in self.json["arrays"].items():
            assert place["at"] % 4 == 0, (name, place)
            self.arrays[name] = struct.unpack_from(f"<{place['count']}{TYPES[place['type']]}", data, place["at"])
            end = max(end, place["at"] + 4 * place["count"])
        assert end == len(data), (end, len(data))

    @property
    def report(self):
        return self.json["report"]


class Studio:
    """A running `planish studio`; a context manager."""

    def __init__(self, *arguments, folder=None, state=None):
        self.folder = folder or tempfile.mkdtemp(prefix="planish-test-")
        self.state = state or tempfile.mkdtemp(prefix="planish-test-state-")
        environment = dict(os.environ, TMPDIR=str(self.folder), XDG_STATE_HOME=str(self.state))
        self.process = subprocess.Popen([CLI, "studio", "--no-browser", *map(str, arguments)], env=environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.line = self.process.stdout.readline()
        match = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/#([0-9a-f]{32})\n", self.line)
        if not match:
            raise AssertionError(f"no address: {self.line!r} {self.process.stderr.read()}")
        self.port, self.token = int(match[1]), match[2]
        self.taken = []

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.stop()
        with contextlib.suppress(OSError):
            os.rmdir(self.folder)
        shutil.rmtree(self.state)

    def stop(self, how=signal.SIGTERM):
        if self.process.poll() is None:
            self.process.send_signal(how)
        try:
            self.process.wait(timeout=10)
        finally:
            self.process.kill()
            self.process.stdout.close()
            self.process.stderr.close()
        return self.process.returncode

    def connection(self):
        return http.client.HTTPConnection("127.0.0.1", self.port, timeout=SECONDS)

    def ask(self, method, path, body=None, headers=None):
        """An answer; `headers` beyond the token, None as a value leaves one out."""
        sent = {"X-Planish-Token": self.token, **(headers or {})}
        connection = self.connection()
        try:
            connection.request(method, path, body, {key: value for key, value in sent.items() if value is not None})
            return Answer(connection.getresponse())
        finally:
            connection.close()

    def get(self, path, **more):
        return self.ask("GET", path, **more)

    def take(self, name, content):
        """The answer to a file that is sent, before it is read."""
        answer = self.ask("POST", "/api/documents?name=" + urllib.parse.quote(name), content)
        if answer.is_good:
            self.taken.append(answer.json()["id"])
        return answer

    def open_taken(self, document):
        return self.ask("POST", f"/api/documents/{document}/open", b"")

    def open(self, name, content):
        """The answer that says what was opened, or why it was not."""
        taken = self.take(name, content)
        return self.open_taken(taken.json()["id"]) if taken.is_good else taken

    def open_example(self, name):
        """Its id and its spec (None of STEP files)."""
        path = EXAMPLES / name
        opened = self.open(path.name, path.read_bytes())
        assert opened.is_good, opened.body
        document = opened.json()
        spec = None if document["text"] is None else json.loads(document["text"])
        for scan in (spec or {}).get("scan", []):
            if isinstance(scan["points"], str):
                points = (path.parent / scan["points"]).read_bytes()
                put = self.ask("PUT", f"/api/documents/{document['id']}/attachments/{scan['points']}", points)
                assert put.status == 204, put.body
        return document["id"], spec

    def post(self, document, verb, spec=None, **options):
        request = {"options": options} if spec is None else {"spec": spec, "options": options}
        return self.ask("POST", f"/api/documents/{document}/{verb}", json.dumps(request))

    def shape(self, document, verb, spec=None, **options):
        answer = self.post(document, verb, spec, **options)
        assert answer.is_good, (answer.status, answer.body[:400])
        return Shape(answer.body)

    def workers(self):
        """Process numbers of its workers."""
        return children_of(self.process.pid)


class StudioTest(unittest.TestCase):
    """All tests of a class talk to one server."""

    maxDiff = None
    arguments = ()

    @classmethod
    def setUpClass(cls):
        cls.studio = Studio(*cls.arguments)
        cls.addClassCleanup(cls.studio.__exit__)

    def tearDown(self):
        while self.studio.taken:
            self.studio.ask("DELETE", f"/api/documents/{self.studio.taken.pop()}")

    def assert_problem(self, answer, code=None):
        """What the program says of input is a good answer of a type of its own."""
        self.assertTrue(answer.is_problem, (answer.status, answer.headers, answer.body[:400]))
        return self.assert_said(answer, code)

    def assert_error(self, answer, status, code=None):
        self.assertEqual(answer.status, status, answer.body[:400])
        self.assertEqual(answer.headers["content-type"], "application/json")
        return self.assert_said(answer, code)

    def assert_said(self, answer, code):
        error = answer.json()
        self.assertLessEqual({"code", "message", "where"}, set(error))
        if code:
            self.assertEqual(error["code"], code, error)
        self.assertTrue(error["message"])
        return error


def main():
    unittest.main(verbosity=2)
