#!/usr/bin/python3
"""Drafts over the WebSocket: the same answers as by HTTP, and to nobody but the page."""

import contextlib
import json
import pathlib
import socket
import struct
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_studio import Shape, StudioTest, main, until  # noqa: E402
from web_socket import BINARY, CLOSE, TEXT, draft_socket  # noqa: E402

class Drafts(StudioTest):
    def socket(self, *arguments):
        return draft_socket(self.studio, *arguments)

    def ask(self, connection, document, request):
        connection.send(f"{document}\n{json.dumps(request)}")
        return connection.receive()

    def test_a_draft_is_that_of_http(self):
        for name in ("connect/a_folded.json", "transition/a_square_to_round.json"):
            document, spec = self.studio.open_example(name)
            there = self.studio.shape(document, "draft", spec)
            with self.socket() as connection:
                kind, content = self.ask(connection, document, {"spec": spec, "options": {}})
            self.assertEqual(kind, BINARY)
            here = Shape(content)
            self.assertEqual(here.arrays, there.arrays)
            self.assertEqual(here.report, there.report)

    def test_what_is_refused_is_said_with_its_status(self):
        document, spec = self.studio.open_example("connect/a_folded.json")
        with self.socket() as connection:
            for asked, request, status, code in (
                    (document, {"spec": {**spec, "thickness": -1}, "options": {}}, 422, "invalid_input"),
                    (document, {"spec": spec, "options": {"no": 1}}, 400, "bad_request"),
                    ("d999", {"spec": spec, "options": {}}, 404, "no_such_document")):
                kind, content = self.ask(connection, asked, request)
                self.assertEqual(kind, TEXT)
                problem = json.loads(content)
                self.assertEqual((problem["status"], problem["code"]), (status, code))
            connection.send("no line feed")
            self.assertEqual(json.loads(connection.receive()[1])["status"], 400)
            self.assertEqual(self.ask(connection, document, {"spec": spec, "options": {}})[0], BINARY)

    def test_nobody_but_the_page_is_answered(self):
        token, port = self.studio.token, self.studio.port
        for path, origin in ((None, None), (None, "http://evil.example"), (None, f"http://127.0.0.1:{port + 1}"), (None, "null"),
                             ("/", "own"), (f"/{token[:-1]}", "own"), (f"/{token}0", "own"), (f"/?{token}", "own")):
            with self.socket(path, origin) as connection:
                self.assertEqual(connection.status, 403, (path, origin))
        with self.socket() as connection:
            self.assertEqual(connection.status, 101)

    def test_it_listens_on_this_machine_alone(self):
        port = self.studio.get("/api/socket").json()["port"]
        rows = pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]
        listening = [row.split()[1] for row in rows if row.split()[3] == "0A"]
        self.assertEqual([a for a in listening if a.endswith(f":{port:04X}")], [f"0100007F:{port:04X}"])

    def test_rubbish_ends_its_connection_alone(self):
        port = self.studio.get("/api/socket").json()["port"]
        for rubbish in (b"\x00" * 100, b"GET / HTTP/1.1\r\n\r\n", b"A" * 100_000):
            with socket.create_connection(("127.0.0.1", port), timeout=10) as connection:
                with contextlib.suppress(OSError):  # it may be closed from there at any moment
                    connection.sendall(rubbish)
                    connection.shutdown(socket.SHUT_WR)
                    while connection.recv(4096):
                        pass
        with self.socket() as connection:
            connection.socket.sendall(bytes([0x80 | TEXT]) + b"\xff" + struct.pack(">Q", 65 << 20) + b"mask")  # larger than is read
            self.assertEqual(connection.receive()[0], CLOSE)
        document, spec = self.studio.open_example("connect/a_folded.json")
        with self.socket() as connection:
            self.assertEqual(self.ask(connection, document, {"spec": spec, "options": {}})[0], BINARY)

    def test_many_connections_are_turned_away_and_none_is_lost(self):
        taken = [self.socket() for _ in range(16)]
        self.assertEqual({c.status for c in taken}, {101})
        with self.assertRaises(ConnectionError):
            self.socket()
        for connection in taken:
            connection.__exit__()

        def free():
            try:
                with self.socket() as connection:
                    return connection.status == 101
            except ConnectionError:
                return False
        self.assertTrue(until(free))

    def test_who_says_nothing_keeps_nobody_out(self):
        port = self.studio.get("/api/socket").json()["port"]
        silent = [socket.create_connection(("127.0.0.1", port), timeout=30) for _ in range(16)]
        self.assertTrue(until(lambda: all(s.recv(1) == b"" for s in silent[:1])))  # closed from there, after some seconds
        for connection in silent:
            connection.close()
        with self.socket() as connection:
            self.assertEqual(connection.status, 101)

    def test_pages_do_not_wait_for_each_other(self):
        documents = [self.studio.open_example("connect/a_folded.json") for _ in range(2)]
        failures = []

        def drag(document, spec):
            with self.socket() as connection:
                for _ in range(20):
                    spec["plates"][-1]["outline"] = [[x, y, z + 0.5] for x, y, z in spec["plates"][-1]["outline"]]
                    if self.ask(connection, document, {"spec": spec, "options": {}})[0] != BINARY:
                        failures.append(document)
        threads = [threading.Thread(target=drag, args=d) for d in documents]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
        self.assertEqual(failures, [])


if __name__ == "__main__":
    main()
