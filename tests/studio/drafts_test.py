#!/usr/bin/python3
"""Drafts over the WebSocket: the same answers as by HTTP, and to nobody but the page."""

import base64
import json
import os
import pathlib
import socket
import struct
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_studio import Shape, StudioTest, main, until  # noqa: E402

TEXT, BINARY, CLOSE = 1, 2, 8


class WebSocket:
    """As much of RFC 6455 as a page needs."""

    def __init__(self, port, path, origin):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=60)
        fields = {"Host": f"127.0.0.1:{port}", "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                  "Sec-WebSocket-Key": base64.b64encode(os.urandom(16)).decode()}
        if origin is not None:
            fields["Origin"] = origin
        head = f"GET {path} HTTP/1.1\r\n" + "".join(f"{key}: {value}\r\n" for key, value in fields.items())
        self.socket.sendall((head + "\r\n").encode())
        self.file = self.socket.makefile("rb")
        try:
            self.status = int(self.file.readline().split()[1])
        except (OSError, IndexError):
            self.__exit__()
            raise ConnectionError("turned away") from None
        self.headers = list(iter(self.file.readline, b"\r\n"))

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.file.close()
        self.socket.close()

    def send(self, text, kind=TEXT):
        body, mask = text.encode() if isinstance(text, str) else text, os.urandom(4)
        size = bytes([0x80 | len(body)]) if len(body) < 126 else b"\xfe" + struct.pack(">H", len(body)) if len(body) < 1 << 16 else b"\xff" + struct.pack(">Q", len(body))
        self.socket.sendall(bytes([0x80 | kind]) + size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(body)))

    def receive(self):
        """Kind and content of the next message, of however many frames."""
        content, kind = b"", None
        while True:
            first, length = self.file.read(2)
            length &= 127
            if length > 125:
                (length,) = struct.unpack(">H", self.file.read(2)) if length == 126 else struct.unpack(">Q", self.file.read(8))
            content += self.file.read(length)
            kind = kind or first & 15
            if first & 0x80:
                return kind, content


class Drafts(StudioTest):
    def socket(self, path=None, origin="own"):
        port = self.studio.get("/api/socket").json()["port"]
        own = f"http://127.0.0.1:{self.studio.port}"
        return WebSocket(port, f"/{self.studio.token}" if path is None else path, own if origin == "own" else origin)

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
                connection.sendall(rubbish)
                connection.shutdown(socket.SHUT_WR)
                try:
                    while connection.recv(4096):
                        pass
                except ConnectionResetError:
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
