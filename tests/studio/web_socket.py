"""A WebSocket as a page has one."""

import base64
import os
import socket
import struct

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


def draft_socket(studio, path=None, origin="own"):
    """The one over which a studio's page asks for drafts; `path` and `origin` other than its own to be turned away."""
    port = studio.get("/api/socket").json()["port"]
    own = f"http://127.0.0.1:{studio.port}"
    return WebSocket(port, f"/{studio.token}" if path is None else path, own if origin == "own" else origin)
