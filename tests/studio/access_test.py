#!/usr/bin/python3
"""Who is answered, and what nobody gets: tokens, hosts, origins, sizes, paths."""

import contextlib
import http.client
import pathlib
import re
import socket
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_studio import EXAMPLES, Studio, StudioTest, main  # noqa: E402

TOO_LARGE = (64 << 20) + 1


class Callers(StudioTest):
    def test_the_token_opens(self):
        self.assertEqual(self.studio.get("/api/documents").json(), [])

    def test_other_tokens_do_not(self):
        right = self.studio.token
        wrong = [None, "", "0" * 32, right[:-1], right + "0", right.upper() if right.upper() != right else "x", right[:-1] + ("0" if right[-1] != "0" else "1")]
        for token in wrong:
            for method, path, body in (("GET", "/api/documents", None), ("GET", "/api/examples", None), ("GET", "/api/nothing", None),
                                       ("POST", "/api/documents?name=a.step", b"x"), ("DELETE", "/api/documents/d1", None),
                                       ("PUT", "/api/documents/d1/attachments/a", b"x")):
                answer = self.studio.ask(method, path, body, headers={"X-Planish-Token": token})
                self.assert_error(answer, 403, "forbidden")

    def test_the_token_is_in_no_answer_to_those_without_it(self):
        for path in ("/", "/index.html", "/api/documents"):
            answer = self.studio.get(path, headers={"X-Planish-Token": None})
            self.assertNotIn(self.studio.token.encode(), answer.body)
            self.assertNotIn(self.studio.token, str(answer.headers))

    def test_tokens_differ(self):
        with Studio() as other:
            self.assertNotEqual(other.token, self.studio.token)
            self.assert_error(self.studio.get("/api/documents", headers={"X-Planish-Token": other.token}), 403)

    def test_hosts(self):
        port = self.studio.port
        for host, status in ((f"127.0.0.1:{port}", 200), (f"localhost:{port}", 200), ("127.0.0.1", 403), (f"127.0.0.1:{port + 1}", 403),
                             (f"evil.example:{port}", 403), ("evil.example", 403), (f"127.0.0.1:{port}.evil.example", 403), ("", 403)):
            for path in ("/", "/api/documents"):
                self.assertEqual(self.studio.get(path, headers={"Host": host}).status, status, (host, path))

    def test_origins(self):
        port = self.studio.port
        for origin, status in ((f"http://127.0.0.1:{port}", 200), (f"http://localhost:{port}", 200), ("null", 403), ("http://evil.example", 403),
                               (f"https://127.0.0.1:{port}", 403), (f"http://127.0.0.1:{port + 1}", 403), (f"http://127.0.0.1:{port}/", 403)):
            self.assertEqual(self.studio.get("/api/documents", headers={"Origin": origin}).status, status, origin)

    def test_two_hosts_are_none(self):
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=10) as connection:
            host = f"Host: 127.0.0.1:{self.studio.port}\r\n"
            connection.sendall(f"GET / HTTP/1.1\r\n{host}Host: evil.example\r\nConnection: close\r\n\r\n".encode())
            self.assertIn(b" 403 ", connection.recv(4096).split(b"\r\n")[0])

    def test_what_a_request_leaves_unread_is_no_request(self):
        document, _ = self.studio.open_example("connect/a_folded.json")
        port, token = self.studio.port, self.studio.token
        hidden = f"DELETE /api/documents/{document} HTTP/1.1\r\nX-Swallow: ".encode()
        for kind in ("multipart/form-data; boundary=x", "text/plain", "application/x-www-form-urlencoded"):
            with socket.create_connection(("127.0.0.1", port), timeout=10) as connection:
                connection.sendall(f"POST /api/documents?name=a HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://evil.example\r\n"
                                   f"Content-Type: {kind}\r\nContent-Length: {len(hidden)}\r\n\r\n".encode())
                time.sleep(0.2)
                with contextlib.suppress(OSError):
                    connection.sendall(hidden)
                    time.sleep(0.2)
                    connection.sendall(f"GET /api/documents HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nX-Planish-Token: {token}\r\n\r\n".encode())
                answer = b""
                with contextlib.suppress(OSError):
                    while part := connection.recv(4096):
                        answer += part
            # The last one is a request of its own, unless the connection has ended with the rejected one.
            self.assertIn(re.findall(rb"HTTP/1\.1 (\d+)", answer), ([b"403"], [b"403", b"200"]))
        self.assertEqual([d["id"] for d in self.studio.get("/api/documents").json()], [document])

    def test_who_says_nothing_keeps_nobody_out_for_long(self):
        silent = [socket.create_connection(("127.0.0.1", self.studio.port), timeout=30) for _ in range(64)]
        begun = time.monotonic()
        self.assertEqual(self.studio.get("/api/documents").status, 200)
        self.assertLess(time.monotonic() - begun, 15.0)
        for connection in silent:
            connection.close()

    def test_it_listens_on_this_machine_alone(self):
        rows = pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]
        listening = [row.split()[1] for row in rows if row.split()[3] == "0A"]
        port = f":{self.studio.port:04X}"
        self.assertEqual([a for a in listening if a.endswith(port)], ["0100007F" + port])
        rows6 = pathlib.Path("/proc/net/tcp6")
        if rows6.exists():
            self.assertFalse([r for r in rows6.read_text().splitlines()[1:] if r.split()[1].endswith(port) and r.split()[3] == "0A"])

    def test_a_port_that_is_taken_is_refused(self):
        import subprocess

        from planish_studio import CLI
        done = subprocess.run([CLI, "studio", "--no-browser", "--port", str(self.studio.port)], capture_output=True, text=True, timeout=30)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stdout, "")
        self.assertIn(f"the port {self.studio.port} of 127.0.0.1 is not available", done.stderr)


class Paths(StudioTest):
    def test_every_answer_has_the_safety_headers(self):
        for answer in (self.studio.get("/"), self.studio.get("/api/documents"), self.studio.get("/nothing"),
                       self.studio.get("/api/documents", headers={"X-Planish-Token": None})):
            policy = answer.headers["content-security-policy"]
            self.assertIn("default-src 'self'", policy)
            self.assertIn("frame-ancestors 'none'", policy)
            self.assertNotIn("unsafe-eval", policy)
            self.assertNotIn("unsafe-inline", policy.split("script-src", 1)[1].split(";")[0])
            self.assertEqual(answer.headers["x-content-type-options"], "nosniff")
            self.assertEqual(answer.headers["referrer-policy"], "no-referrer")
            self.assertNotIn("access-control-allow-origin", answer.headers)

    def test_answers_are_not_compressed(self):
        for path in ("/", "/api/examples"):
            answer = self.studio.get(path, headers={"Accept-Encoding": "br, gzip, deflate"})
            self.assertEqual(answer.status, 200)
            self.assertNotIn("content-encoding", answer.headers)

    def test_the_page_is_there(self):
        page = self.studio.get("/", headers={"X-Planish-Token": None})
        self.assertEqual(page.status, 200)
        self.assertTrue(page.headers["content-type"].startswith("text/html"))
        self.assertIn(b"<!doctype html", page.body[:200].lower())

    def test_nothing_of_the_disk_is(self):
        for path in ("/../../../../../../etc/passwd", "/..%2f..%2f..%2f..%2fetc%2fpasswd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/etc/passwd",
                     "/page/../../etc/passwd", "/.", "/..", "/./index.html", "/index.html%00.txt", "/api/examples/../../etc/passwd",
                     "/api/examples/..%2f..%2f..%2fetc%2fpasswd", "/api/examples//etc/passwd", "/api/examples/connect/../bracket.step",
                     "/api/examples/connect", "/api/examples/../page/index.html", "/api/documents/d1/attachments/x", "/proc/self/environ"):
            answer = self.studio.get(path)
            self.assertIn(answer.status, (400, 404), path)
            self.assertNotIn(b"root:", answer.body, path)

    def test_long_addresses_are_refused(self):
        for length in (3000, 7000):
            self.assertEqual(self.studio.get("/" + "a" * length).status, 400)
        self.assertIn(self.studio.get("/" + "a" * 100_000).status, (400, 414))
        self.assertEqual(self.studio.get("/").status, 200)

    def test_other_methods_are_not_there(self):
        for method in ("PATCH", "OPTIONS", "TRACE", "CONNECT"):
            self.assertIn(self.studio.ask(method, "/api/documents").status, (400, 404), method)
        self.assert_error(self.studio.ask("POST", "/", b""), 404)
        self.assert_error(self.studio.ask("PUT", "/api/documents", b""), 404)

    def test_bodies_over_the_limit_are_refused(self):
        for headers in ({}, {"X-Planish-Token": None}):
            connection = self.studio.connection()
            sent = {"X-Planish-Token": self.studio.token, **headers}
            connection.putrequest("POST", "/api/documents?name=a.step")
            for key, value in sent.items():
                if value is not None:
                    connection.putheader(key, value)
            connection.putheader("Content-Length", str(TOO_LARGE))
            connection.endheaders()
            chunk = b" " * (1 << 20)
            for _ in range(TOO_LARGE // len(chunk)):
                connection.send(chunk)
            connection.send(b" ")
            self.assertEqual(connection.getresponse().status, 413 if not headers else 403)
            connection.close()
        self.assertEqual(self.studio.get("/api/documents").json(), [])

    def test_compressed_bodies_over_the_limit_are_refused(self):
        import gzip
        answer = self.studio.ask("POST", "/api/documents?name=a.step", gzip.compress(b" " * TOO_LARGE), headers={"Content-Encoding": "gzip"})
        self.assertEqual(answer.status, 413)

    def test_forms_are_not_understood(self):
        body = b'--x\r\nContent-Disposition: form-data; name="f"; filename="a.step"\r\n\r\nhello\r\n--x--\r\n'
        answer = self.studio.ask("POST", "/api/documents?name=a.step", body, headers={"Content-Type": "multipart/form-data; boundary=x"})
        self.assertEqual(answer.status, 400)
        self.assertEqual(self.studio.get("/api/documents").json(), [])

    def test_a_connection_that_was_turned_away_stays_usable(self):
        connection = self.studio.connection()
        connection.request("POST", "/api/documents?name=a.step", b"GET /api/documents HTTP/1.1\r\n\r\n" * 100)
        refused = connection.getresponse()
        refused.read()
        self.assertEqual(refused.status, 403)
        connection.request("GET", "/api/documents", headers={"X-Planish-Token": self.studio.token})
        self.assertEqual(connection.getresponse().status, 200)
        connection.close()

    def test_rubbish_on_the_wire_ends_nothing(self):
        for rubbish in (b"\0" * 4096, b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"POST /api/documents HTTP/1.1\r\nContent-Length: -1\r\n\r\n",
                        b"\x16\x03\x01" + bytes(range(256)), b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 5000 + b"\r\n"):
            with socket.create_connection(("127.0.0.1", self.studio.port), timeout=10) as connection:
                connection.settimeout(0.3)
                try:
                    connection.sendall(rubbish)
                    connection.recv(4096)
                except (TimeoutError, ConnectionError):
                    pass
        self.assertEqual(self.studio.get("/api/documents").status, 200)


class Connections(StudioTest):
    def opened(self, content):
        """A connection on which that was sent, and nothing more comes."""
        connection = socket.create_connection(("127.0.0.1", self.studio.port), timeout=30)
        self.addCleanup(connection.close)
        connection.sendall(content)
        return connection

    def test_half_open_connections_delay_nobody(self):
        for content in (b"", b"GET / HTTP/1.1\r\nHost: 127.0.0.1"):
            for _ in range(100):
                self.opened(content)
        time.sleep(0.3)
        begun = time.monotonic()
        self.assertEqual(self.studio.get("/api/documents").status, 200)
        self.assertLess(time.monotonic() - begun, 2.0)  # they wait for 5 s

    def test_headers_that_take_too_long_are_cut_off(self):
        connection = self.opened(b"GET / HTTP/1.1\r\n")
        begun = time.monotonic()
        with self.assertRaises(OSError):  # the server has closed it
            while time.monotonic() - begun < 30:
                connection.sendall(b"A: b\r\n")
                time.sleep(0.5)
        self.assertLess(time.monotonic() - begun, 15.0)
        self.assertGreater(time.monotonic() - begun, 5.0)

    def test_a_connection_without_data_is_closed(self):
        connection = self.opened(b"GET / HTTP/1.1\r\n")
        begun = time.monotonic()
        while connection.recv(4096):
            pass
        self.assertLess(time.monotonic() - begun, 9.0)

    def request(self, method, path, *lines, body=b"", token=None):
        head = [f"{method} {path} HTTP/1.1", f"Host: 127.0.0.1:{self.studio.port}", f"X-Planish-Token: {token or self.studio.token}", *lines]
        return "\r\n".join([*head, "", ""]).encode() + body

    def answers(self, content):
        """The states of all answers on one connection to that content, which is all that comes."""
        connection, got = self.opened(content), b""
        connection.shutdown(socket.SHUT_WR)
        while piece := connection.recv(65536):
            got += piece
        return [int(status) for status in re.findall(rb"HTTP/1\.1 (\d+)", got)]

    def test_one_connection_carries_many_requests(self):
        connection = self.studio.connection()
        self.addCleanup(connection.close)
        sockets = set()
        for method, path, body, token, status in (("GET", "/api/documents", None, True, 200), ("POST", "/api/documents?name=a.json", b"{}", True, 200),
                                                  ("PUT", "/api/documents/d1/attachments/a", b"x" * 100_000, True, 204),
                                                  ("POST", "/api/documents?name=b.json", b"x" * 100_000, False, 403), ("GET", "/nothing", None, True, 404),
                                                  ("DELETE", "/api/documents/d1", None, True, 204), ("GET", "/api/documents", None, True, 200)):
            connection.request(method, path, body, {"X-Planish-Token": self.studio.token if token else "0" * 32})
            sockets.add(id(connection.sock))
            answer = connection.getresponse()
            answer.read()
            self.assertEqual(answer.status, status, (method, path))
        self.assertEqual(len(sockets), 1)

    def test_requests_that_come_at_once_are_answered_in_order(self):
        self.assertEqual(self.answers(self.request("GET", "/api/documents") + self.request("GET", "/api/nothing")
                                      + self.request("POST", "/api/documents?name=a.json", "Content-Length: 2", body=b"{}")
                                      + self.request("GET", "/api/documents", "Connection: close") + self.request("GET", "/api/documents")), [200, 404, 200, 200])

    def test_a_body_is_never_taken_for_a_request(self):
        inner = self.request("GET", "/api/documents")
        for body, lines, status in ((inner, [f"Content-Length: {len(inner)}"], 403), (inner, [], 403),
                                    (b"%x\r\n%s\r\n0\r\n\r\n" % (len(inner), inner), ["Transfer-Encoding: chunked"], 403),
                                    (b"0\r\n\r\n" + inner, ["Transfer-Encoding: chunked"], 403),
                                    (inner, ["Content-Length: 0", f"Content-Length: {len(inner)}"], 403),
                                    (inner, ["Content-Length: 0x0"], 403)):
            with self.subTest(lines=lines):
                self.assertEqual(self.answers(self.request("POST", "/api/documents?name=a", *lines, body=body, token="0" * 32)), [status])

    def test_a_connection_ends_after_a_body_that_is_too_large(self):
        connection = self.opened(self.request("POST", "/api/documents?name=a", f"Content-Length: {TOO_LARGE}"))
        got = b""
        with contextlib.suppress(OSError):
            while piece := connection.recv(65536):
                got += piece
        self.assertTrue(got.startswith(b"HTTP/1.1 413"), got[:60])

    def test_a_request_that_comes_by_pieces_is_answered(self):
        connection = self.opened(b"")
        request = f"GET /api/documents HTTP/1.1\r\nHost: 127.0.0.1:{self.studio.port}\r\nX-Planish-Token: {self.studio.token}\r\n\r\n"
        for at in range(0, len(request), 7):
            connection.sendall(request[at:at + 7].encode())
            time.sleep(0.01)
        self.assertTrue(connection.recv(4096).startswith(b"HTTP/1.1 200"))


class Examples(StudioTest):
    def test_the_list_names_what_can_be_had(self):
        listed = self.studio.get("/api/examples").json()
        self.assertEqual({row["kind"] for row in listed}, {"unfold", "connect", "transition", "slit"})
        self.assertEqual({row["name"] for row in listed}, {"bracket.step"} | {str(p.relative_to(EXAMPLES)) for p in EXAMPLES.glob("*/*.json") if p.parent.name != "shop"})
        for row in listed:
            self.assertEqual(self.studio.get("/api/examples/" + row["name"]).body, (EXAMPLES / row["name"]).read_bytes())
            self.assertTrue(row["title"][0].isupper(), row)

    def test_scans_can_be_had_too(self):
        name = "slit/low_chair_scan0.xyz"
        self.assertEqual(self.studio.get("/api/examples/" + name).body, (EXAMPLES / name).read_bytes())


if __name__ == "__main__":
    main()
