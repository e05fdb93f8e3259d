"""A client of `planish serve --stdio`, as a program would write it."""

import contextlib
import json
import pathlib
import queue
import subprocess
import sys
import threading

HERE = pathlib.Path(__file__).parent
sys.path[:0] = [str(HERE.parent / "cli"), str(HERE.parent / "support")]
from planish_cli import CLI, SOURCE, CliTest  # noqa: E402,F401

SECONDS = 120
EXAMPLES = SOURCE / "examples"


class Server:
    """The program and what it says, message by message; `headers` is the framing of language servers."""

    def __init__(self, folder, *arguments, headers=False):
        self.program = subprocess.Popen([CLI, "serve", "--stdio", *map(str, arguments)], cwd=folder, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.headers = headers
        self.ids = 0
        self.answers, self.told = {}, []
        self.said = queue.Queue()
        self.errors = []
        self.threads = [threading.Thread(target=self.listen, daemon=True),
                        threading.Thread(target=lambda: self.errors.append(self.program.stderr.read()), daemon=True)]
        for thread in self.threads:
            thread.start()

    def listen(self):
        out = self.program.stdout
        while line := out.readline():
            if self.headers:
                size = int(line.removeprefix(b"Content-Length: "))
                assert out.readline() == b"\r\n"
                line = out.read(size)
            self.said.put(json.loads(line))
        self.said.put(None)

    def send_bytes(self, line):
        self.program.stdin.write(line)
        self.program.stdin.flush()

    def send(self, message):
        text = json.dumps(message).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n%s" % (len(text), text) if self.headers else text + b"\n")

    def begin(self, method, params=None):
        """Sends a request; returns its id."""
        self.ids += 1
        self.send({"jsonrpc": "2.0", "id": self.ids, "method": method, **({} if params is None else {"params": params})})
        return self.ids

    def notify(self, method, params=None):
        self.send({"jsonrpc": "2.0", "method": method, **({} if params is None else {"params": params})})

    def hear(self):
        """The next message, None at the end."""
        message = self.said.get(timeout=SECONDS)
        if message is None:
            self.said.put(None)  # it stays so
        if isinstance(message, dict):
            assert message["jsonrpc"] == "2.0", message
            if "method" in message:
                self.told.append(message)
        return message

    def answer(self, number):
        """The answer to a request; others are kept."""
        while number not in self.answers:
            message = self.hear()
            if message is None:
                raise EOFError(number)
            if isinstance(message, dict) and "method" not in message:
                assert message["id"] not in self.answers, message
                self.answers[message["id"]] = message
        return self.answers.pop(number)

    def ask(self, method, params=None):
        """The result of a request."""
        answer = self.answer(self.begin(method, params))
        if "result" not in answer:
            raise AssertionError(answer)
        return answer["result"]

    def fails(self, method, params=None):
        """The error of a request."""
        return self.answer(self.begin(method, params))["error"]

    def line(self, line):
        """What is answered to a line of any kind."""
        self.send_bytes(line + b"\n")
        return self.hear()

    def end(self):
        """Ends the input; exit status, and what else was said on standard output and error."""
        with contextlib.suppress(OSError):
            self.program.stdin.close()
        rest = []
        while (message := self.hear()) is not None:
            rest.append(message)
        status = self.program.wait(timeout=SECONDS)
        for thread in self.threads:
            thread.join()
        self.program.stdout.close()
        self.program.stderr.close()
        return status, rest, self.errors[0].decode()


class ServeTest(CliTest):
    def server(self, *arguments, **how):
        server = Server(self.dir, *arguments, **how)
        self.addCleanup(self.clean_up, server)
        return server

    def clean_up(self, server):
        server.program.kill()
        server.end()

    def check_end(self, server, status=0):
        self.assertEqual(server.end(), (status, [], ""))
