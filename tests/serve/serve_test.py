#!/usr/bin/python3
"""`planish serve --stdio`: the same results as the command line's, several at a time, with progress and cancel; whatever a client
sends, and whatever a file does, is answered."""

import base64
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_serve import CLI, EXAMPLES, SECONDS, SOURCE, ServeTest  # noqa: E402
import step_files  # noqa: E402
from damaged_test import long_work  # noqa: E402
from planish_cli import main  # noqa: E402
from processes import children_of, is_alive, until  # noqa: E402

MAKERS = {"connect": "connect", "transition": "transition", "slit": "slit"}
CORPUS = sorted((SOURCE / "tests" / "fuzz" / "corpus").iterdir())


def without_times(report):
    return {key: value for key, value in report.items() if key not in ("timing", "files")}


def bytes_of(artifact):
    return artifact["text"].encode() if "text" in artifact else base64.b64decode(artifact["base64"])


class Results(ServeTest):
    def check_like_cli(self, server, maker, path, artifacts, option):
        """The report and all files; those of several pieces are numbered."""
        folder = self.dir / path.name
        folder.mkdir(exist_ok=True)
        names = [f"{path.name}/cli.{artifact}" for artifact in artifacts]
        words = [maker, path, *[word for name in names for word in (option, name)], "--json", "cli.json", "-q"]
        self.run_cli(*words)
        result = server.ask(maker, {"input": str(path), "artifacts": artifacts})
        self.assertEqual(without_times(result["report"]), without_times(self.json("cli.json")))
        self.assertEqual(result["status"], result["report"]["status"])
        for artifact in artifacts:
            made = [one for one in result["artifacts"] if one["artifact"] == artifact]
            written = sorted(folder.glob(f"*.{artifact}"))
            self.assertGreaterEqual(len(written), 1)
            self.assertEqual(len(made), len(written), (path, artifact))
            for one, file in zip(made, written):
                self.assertEqual(bytes_of(one), file.read_bytes(), file)
                self.assertEqual("base64" in one, artifact == "pdf")

    def test_they_are_those_of_the_command_line_for_all_examples(self):
        server = self.server()
        self.check_like_cli(server, "unfold", EXAMPLES / "bracket.step", ["dxf", "svg", "pdf"], "-o")
        for maker, folder in MAKERS.items():
            for path in sorted((EXAMPLES / folder).glob("*.json")):
                self.check_like_cli(server, maker, path, ["dxf", "svg"], "--flat")
        self.check_end(server)

    def test_bend_and_info_too(self):
        server, part = self.server(), EXAMPLES / "bracket.step"
        self.check_like_cli(server, "bend", part, ["svg", "pdf"], "-o")
        plates = EXAMPLES / "connect" / "a_folded.json"
        said = self.refused("bend", plates, "--clearance", "100", "-q", "-o", "cli.svg", status=4)
        result = server.ask("bend", {"input": str(plates), "artifacts": ["svg"], "options": {"clearance": 100}})
        self.assertEqual((result["status"], result["report"]["reason"]["code"]), ("refused", "cannot_bend"))
        reason = result["report"]["reason"]["message"].rstrip(".")
        self.assertIn(reason[0].lower() + reason[1:], said)
        self.assertIn("<svg", result["artifacts"][0]["text"])
        self.run_cli("info", part, "--sheets", "--json", "cli.json")
        self.assertEqual(server.ask("info", {"input": str(part), "sheets": True})["report"], self.json("cli.json"))
        inside = {"name": "bracket.step", "content": part.read_text()}
        self.assertEqual(server.ask("info", {"input": inside, "sheets": True})["report"]["bodies"], self.json("cli.json")["bodies"])
        self.run_cli("bend", part, "--opening", "20", "--as-made", "made.dxf", "-q")
        made = server.ask("bend", {"input": str(part), "artifacts": ["dxf"], "options": {"opening": 20}})["artifacts"][0]
        self.assertEqual((made["name"], made["text"]), ("bracket_as_made.dxf", (self.dir / "made.dxf").read_text()))
        options = {"metal": "stainless", "springback": 2, "fix": "B2"}
        self.run_cli("bend", part, "--material", "stainless", "--springback", "2", "--fix", "B2", "--json", "cli.json", "-q")
        result = server.ask("bend", {"input": str(part), "options": options})
        self.assertEqual(without_times(result["report"]), without_times(self.json("cli.json")))

    def test_schemas_and_formats_are_the_programs(self):
        server = self.server()
        names = self.run_cli("schema")[0].split()
        self.assertEqual(server.ask("schema"), {"names": names})
        for name in names:
            self.assertEqual(server.ask("schema", {"name": name}), json.loads(self.run_cli("schema", name)[0]))
        error = server.fails("schema", {"name": "none"})
        self.assertEqual((error["code"], error["data"]["code"]), (-32602, "bad_option"))
        self.assertIn("Name one of these: plates, ", error["message"])
        formats = server.ask("formats")
        text = self.run_cli("--formats")[0]
        for row in formats["makers"] + formats["artifacts"]:
            self.assertIn(row["name"], text)
            self.assertIn(row["description"], text)
        self.check_end(server)

    def test_a_refusal_is_a_result(self):
        self.write("block.step", step_files.block())
        server = self.server()
        result = server.ask("unfold", {"input": "block.step", "artifacts": ["dxf"]})
        self.assertEqual((result["status"], result["artifacts"]), ("refused", []))
        self.assertEqual(result["report"]["reason"]["code"], "not_a_sheet")

    def test_two_hundred_through_one_process(self):
        server = self.server("--jobs", 2)
        self.angle()
        first = bytes_of(server.ask("unfold", {"input": "part.step", "artifacts": ["dxf"]})["artifacts"][0])
        numbers = [server.begin("unfold", {"input": "part.step", "artifacts": ["dxf"]}) for _ in range(200)]
        workers = set()
        for number in numbers:
            result = server.answer(number)["result"]
            self.assertEqual(bytes_of(result["artifacts"][0]), first)
            workers |= set(children_of(server.program.pid))
        self.assertLessEqual(len(workers), 2)
        self.check_end(server)
        self.assertTrue(until(lambda: not any(map(is_alive, workers))))


class Files(ServeTest):
    def test_artifacts_are_written(self):
        self.angle()
        self.run_cli("unfold", "part.step", "-o", "cli.dxf", "-q")
        server = self.server()
        result = server.ask("unfold", {"input": "part.step", "artifacts": ["svg"], "write": {"dxf": "a.dxf", "pdf": "b.pdf"}})
        rows = {one["artifact"]: one for one in result["artifacts"]}
        self.assertEqual(rows["dxf"]["path"], "a.dxf")
        self.assertNotIn("text", rows["dxf"])
        self.assertEqual(rows["dxf"]["size"], (self.dir / "a.dxf").stat().st_size)
        self.assertEqual((self.dir / "a.dxf").read_bytes(), (self.dir / "cli.dxf").read_bytes())
        self.assertTrue((self.dir / "b.pdf").read_bytes().startswith(b"%PDF"))
        self.assertIn("text", rows["svg"])
        self.check_end(server)
        self.assertEqual(self.names(), ["a.dxf", "b.pdf", "cli.dxf", "part.step"])

    def test_pieces_are_numbered(self):
        spec = json.loads((EXAMPLES / "transition" / "a_square_to_round.json").read_text())
        result = self.server().ask("transition", {"input": {"content": {**spec, "pieces": 2}}, "write": {"dxf": "net.dxf"}})
        self.assertEqual([one["path"] for one in result["artifacts"]], ["net-1.dxf", "net-2.dxf"])
        self.assertEqual(self.names(), ["net-1.dxf", "net-2.dxf"])

    def test_what_cannot_be_written_is_said_before_the_work_and_nothing_is(self):
        self.angle()
        before = (self.dir / "part.step").read_bytes()
        (self.dir / "folder").mkdir()
        server = self.server()
        for write, code, where in (
                ({"dxf": "part.step"}, "bad_option", "/write/dxf"), ({"dxf": "none/a.dxf"}, "cannot_write", "/write/dxf"),
                ({"svg": "b.svg", "dxf": "folder"}, "cannot_write", "/write/dxf"), ({"dxf": "a", "svg": "./a"}, "bad_option", "/write/svg"),
                ({"dxf": 1}, "invalid_input", "/write/dxf"), ({"dxf": ""}, "invalid_input", "/write/dxf"),
                ({"dxf": "-"}, "invalid_input", "/write/dxf"), ("a.dxf", "invalid_input", "/write"),
                ({"step.flat": "a"}, "invalid_input", "/write/step.flat")):
            error = server.fails("unfold", {"input": "part.step", "artifacts": ["dxf"], "write": write})
            self.assertEqual((error["data"]["code"], error["data"]["where"]), (code, where), error)
            self.assertEqual(error["code"], -32000 if code == "cannot_write" else -32602)
            self.assertNotIn("/artifacts", error["message"])
        self.assertEqual((self.dir / "part.step").read_bytes(), before)
        self.assertEqual(self.names(), ["part.step"])

    def test_a_refused_part_writes_none_but_its_report(self):
        self.write("block.step", step_files.block())
        result = self.server().ask("unfold", {"input": "block.step", "write": {"dxf": "a.dxf", "json": "a.json"}})
        self.assertEqual(result["status"], "refused")
        self.assertEqual(self.names(), ["a.json", "block.step"])
        self.assertEqual(self.json("a.json")["reason"]["code"], "not_a_sheet")


class Requests(ServeTest):
    def error(self, answer):
        self.assertNotIn("result", answer)
        return answer["id"], answer["error"]["code"]

    def test_what_is_no_json(self):
        server = self.server()
        for line in (b"{", b"{]", b"nonsense", b"\xff\xfe\x00\x01", bytes(range(1, 10)) + bytes(range(11, 256)), b"\x00" * 1000,
                     b'{"jsonrpc": "2.0", "id": 1, "method": "ping"', b"[" * 100000, b'{"a":' * 5000, b'"' + b"x" * 5000000):
            self.assertEqual(self.error(server.line(line)), (None, -32700), line[:40])
        self.assertEqual(server.ask("ping"), {})
        self.check_end(server)

    def test_what_is_no_request(self):
        server = self.server()
        for message in (1, "text", None, {}, {"jsonrpc": "2.0"}, {"jsonrpc": "1.0", "id": 1, "method": "ping"},
                        {"jsonrpc": "2.0", "id": 1, "method": 7}, {"jsonrpc": "2.0", "id": {}, "method": "ping"},
                        {"jsonrpc": "2.0", "id": True, "method": "ping"}, {"id": 1, "method": "ping"}, []):
            self.assertEqual(self.error(server.line(json.dumps(message).encode())), (None, -32600), message)
        self.assertEqual(server.ask("ping"), {})

    def test_parameters_that_are_wrong_say_where(self):
        self.angle()
        server = self.server()
        for params, code, where in (
                ({}, "invalid_input", "/input"), ({"input": 7}, "invalid_input", "/input"),
                ({"input": "part.step", "option": {}}, "invalid_input", "/option"),
                ({"input": "part.step", "options": {"k": 2}}, "invalid_input", "/options/k"),
                ({"input": "part.step", "options": {"strips": 2}}, "invalid_input", "/options/strips"),
                ({"input": "part.step", "options": {"lateral": "arc"}}, "bad_option", "/options/lateral"),
                ({"input": "part.step", "options": {"bend_k": {"B99": 0.4}}}, "bad_option", "/options/bend_k/B99"),
                ({"input": "part.step", "options": {"k_table": "-"}}, "bad_option", "/options/k_table"),
                ({"input": "-"}, "bad_option", "/input"), ({"input": "part.step", "artifacts": ["step2"]}, "invalid_input", "/artifacts/0"),
                ({"input": "part.step", "artifacts": ["mould.stl"]}, "bad_option", "/artifacts/0"),
                ({"input": "part.step", "sheets": True}, "bad_option", "/sheets"),
                ({"input": "part.step", "maker": "slit"}, "invalid_input", "/maker")):
            error = server.fails("unfold", params)
            self.assertEqual((error["code"], error["data"]["code"], error["data"]["where"]), (-32602, code, where), error)
            self.assertIn({"kind": "pointer", "id": where}, error["data"]["places"])
        for params in ([], ["part.step"], "part.step", 5):
            self.assertEqual(server.fails("unfold", params)["code"], -32602)
        error = server.fails("unfold", {"input": "none.step"})
        self.assertEqual((error["code"], error["data"]),
                         (-32000, {"code": "cannot_read", "where": "none.step", "places": [], "numbers": {}}))
        # What is wrong in a file is no fault of the request, wherever the file lies.
        spec = self.write("wrong.json", '{"format": "planish/plates", "version": 1, "thickness": -1, "plates": []}')
        error = server.fails("connect", {"input": str(spec)})
        self.assertEqual((error["code"], error["data"]["where"]), (-32000, f"{spec}/thickness"))
        self.assertEqual(error["data"]["places"], [{"kind": "pointer", "id": "/thickness"}])
        error = server.fails("unfold", {"input": str(self.dir / "none.step")})
        self.assertEqual((error["code"], error["data"]["places"]), (-32000, []))
        error = server.fails("info", {"input": "part.step", "artifacts": ["json"]})
        self.assertEqual((error["code"], error["data"]["where"]), (-32602, "/artifacts/0"))
        self.assertEqual(server.fails("info", {"input": "part.step", "write": {"json": "a"}})["data"]["where"], "/write")
        self.assertEqual(server.fails("bend", {"input": "part.step", "artifacts": ["step"]})["data"]["where"], "/artifacts/0")

    def test_methods_that_there_are_not(self):
        server = self.server()
        for method in ("fold", "", "textDocument/didOpen", "$/none", "x" * 10000):
            self.assertEqual(server.fails(method, {})["code"], -32601)

    def test_notifications_have_no_answer(self):
        self.angle()
        server = self.server("--jobs", 1)
        for method in ("unfold", "ping", "none", "tools/call", "schema", "initialize", "$/cancelRequest", "notifications/cancelled"):
            server.notify(method)
            server.notify(method, {"input": "part.step", "id": 99, "requestId": [1]})
            server.notify(method, [1])
        server.notify("unfold", {"input": "part.step", "write": {"dxf": "a.dxf"}})
        server.send({"jsonrpc": "2.0", "id": 5, "result": {}})
        server.ask("unfold", {"input": "part.step"})
        self.assertIn("a.dxf", self.names())
        self.assertEqual([one["method"] for one in server.told if one["params"]["id"] != 1], [])
        self.check_end(server)

    def test_an_id_is_that_of_one_request_at_a_time(self):
        self.write("long.json", long_work())
        server = self.server()
        first = {"jsonrpc": "2.0", "id": "one", "method": "slit", "params": {"input": "long.json"}}
        server.send(first)
        server.send(first)
        while "method" in (refused := server.hear()):
            pass
        self.assertEqual(self.error(refused), (None, -32600))
        self.assertIn('"one"', refused["error"]["message"])
        server.notify("$/cancelRequest", {"id": "one"})
        self.assertEqual(server.answer("one")["error"]["code"], -32800)
        server.send({**first, "method": "ping"})
        self.assertEqual(server.answer("one")["result"], {})

    def test_ids_come_back_as_they_are(self):
        server = self.server()
        for number in (0, -7, 1.5, "", "täglich", 2**53, None):
            server.send({"jsonrpc": "2.0", "id": number, "method": "ping"})
            self.assertEqual(server.hear()["id"], number)

    def test_a_list_of_requests_is_answered_by_a_list(self):
        self.angle()
        server = self.server()
        server.send([{"jsonrpc": "2.0", "id": 1, "method": "ping"}, {"jsonrpc": "2.0", "method": "ping"}, 7,
                     {"jsonrpc": "2.0", "id": 2, "method": "unfold", "params": {"input": "part.step"}},
                     {"jsonrpc": "2.0", "id": 3, "method": "none"}])
        while isinstance(answers := server.hear(), dict):
            pass
        self.assertEqual(sorted((one["id"] or 0, one.get("error", {}).get("code")) for one in answers),
                         [(0, -32600), (1, None), (2, None), (3, -32601)])
        server.send([{"jsonrpc": "2.0", "method": "ping"}])
        self.check_end(server)

    def test_blank_lines_and_a_last_line_without_an_end(self):
        server = self.server()
        server.send_bytes(b"\n \r\n\t\n" + b'{"jsonrpc": "2.0", "id": 1, "method": "ping"}\r\n' + b'{"jsonrpc": "2.0", "id": 2, "method": "ping"}')
        self.assertEqual(server.hear()["id"], 1)
        status, rest, said = server.end()
        self.assertEqual((status, rest, said), (0, [{"jsonrpc": "2.0", "id": 2, "result": {}}], ""))

    def test_a_line_that_is_too_long_is_left_out(self):
        server = self.server()
        piece = b"x" * (1 << 20)
        for _ in range(300):
            server.send_bytes(piece)
        answer = server.line(b"")
        self.assertEqual(self.error(answer), (None, -32700))
        self.assertIn("256 MiB", answer["error"]["message"])
        self.assertEqual(server.ask("ping"), {})

    def test_a_large_input_is_not(self):
        server = self.server()
        text = (EXAMPLES / "connect" / "a_folded.json").read_text() + " " * 30_000_000
        result = server.ask("connect", {"input": {"name": "a.json", "content": text}})
        self.assertEqual(result["report"]["input"], "a.json")

    def test_headers_are_answered_by_headers(self):
        self.angle()
        server = self.server(headers=True)
        self.assertEqual(server.ask("ping"), {})
        self.assertEqual(server.ask("unfold", {"input": "part.step"})["status"], "ok")
        server.send_bytes(b"Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length:2\r\n\r\n{]")
        self.assertEqual(self.error(server.hear()), (None, -32700))
        server.send_bytes(b"Content-Length: 300000000\r\n\r\n")
        for _ in range(300):
            server.send_bytes(b"y" * 1_000_000)
        self.assertEqual(self.error(server.hear()), (None, -32700))
        self.assertEqual(server.ask("ping"), {})
        server.send_bytes(b"Content-Type: x\r\n\r\n")
        self.assertEqual(self.error(server.hear()), (None, -32700))
        self.check_end(server)


class AtWork(ServeTest):
    def begun(self, server, **params):
        """A long request that has told a stage."""
        self.write("long.json", long_work())
        number = server.begin("slit", {"input": "long.json", **params})
        while "method" not in server.hear():
            pass
        return number

    def test_progress_is_told_with_the_id(self):
        server = self.server()
        number = self.begun(server)
        short = server.begin("unfold", {"input": str(EXAMPLES / "bracket.step")})
        server.notify("$/cancelRequest", {"id": number})
        self.assertEqual(server.answer(number)["error"]["data"]["code"], "cancelled")
        self.assertEqual(server.answer(short)["result"]["status"], "ok")
        self.assertEqual({one["method"] for one in server.told}, {"$/progress"})
        self.assertIn((short, "finding the sheet"), {(one["params"]["id"], one["params"]["stage"]) for one in server.told})
        for one in server.told:
            self.assertTrue(0.0 <= one["params"]["done"] <= 1.0)

    def test_a_cancelled_request_writes_nothing_and_frees_its_process(self):
        server = self.server("--jobs", 1)
        number = self.begun(server, write={"dxf": "a.dxf"})
        behind = server.begin("slit", {"input": "long.json", "write": {"dxf": "b.dxf"}})
        after = server.begin("unfold", {"input": str(EXAMPLES / "bracket.step")})
        for one in (number, behind):
            server.notify("$/cancelRequest", {"id": one})
        for one in (number, behind):
            self.assertEqual(server.answer(one)["error"]["code"], -32800)
        self.assertEqual(server.answer(after)["result"]["status"], "ok")
        self.assertEqual(self.names(), ["long.json"])
        server.notify("$/cancelRequest", {"id": number})
        self.check_end(server)

    def test_a_crash_costs_its_request_alone(self):
        for how, code in ((signal.SIGSEGV, "crashed"), (signal.SIGABRT, "crashed"), (signal.SIGKILL, "out_of_memory")):
            server = self.server("--jobs", 1)
            number = self.begun(server, write={"dxf": "a.dxf"})
            (worker,) = children_of(server.program.pid)
            os.kill(worker, how)
            error = server.answer(number)["error"]
            self.assertEqual((error["code"], error["data"]["code"], error["data"]["where"]), (-32000, code, "long.json"))
            self.assertIn("long.json", error["message"])
            self.assertEqual(server.ask("unfold", {"input": str(EXAMPLES / "bracket.step")})["status"], "ok")
            self.assertEqual(self.names(), ["long.json"])

    def test_each_file_of_the_corpus_is_answered(self):
        server = self.server("--time-limit", 20)
        numbers = {file: server.begin("unfold" if file.suffix == ".step" else file.name.split("-")[0], {"input": str(file)})
                   for file in CORPUS if file.suffix in (".step", ".json")}
        for file, number in numbers.items():
            answer = server.answer(number)
            if "error" in answer:
                self.assertIn(answer["error"]["code"], (-32000, -32602), file)
                self.assertTrue(answer["error"]["data"]["code"], file)
            else:
                self.assertIn(answer["result"]["status"], ("ok", "warning", "refused"), file)
        self.check_end(server)

    def test_limits_are_kept(self):
        self.write("long.json", long_work())
        server = self.server("--time-limit", 0.5)
        error = server.fails("slit", {"input": "long.json"})
        self.assertEqual(error["data"]["code"], "out_of_time")
        self.assertIn("after 0.5 s", error["message"])

    def test_several_are_worked_on_at_once_and_answered_as_they_finish(self):
        server = self.server("--jobs", 2)
        number = self.begun(server)
        for _ in range(3):
            self.assertEqual(server.ask("unfold", {"input": str(EXAMPLES / "bracket.step")})["status"], "ok")
        self.assertEqual(len(children_of(server.program.pid)), 2)
        self.assertNotIn(number, server.answers)
        server.notify("$/cancelRequest", {"id": number})
        self.assertEqual(server.answer(number)["error"]["code"], -32800)


class Ends(ServeTest):
    def begun(self, *arguments):
        self.write("long.json", long_work())
        server = self.server(*arguments)
        server.begin("slit", {"input": "long.json", "write": {"dxf": "a.dxf"}})
        while "method" not in server.hear():
            pass
        return server, children_of(server.program.pid)

    def check_gone(self, children):
        self.assertTrue(children)
        self.assertTrue(until(lambda: not any(map(is_alive, children))))
        self.assertEqual(self.names(), ["long.json"])

    def test_shutdown_and_exit(self):
        server = self.server()
        self.assertIsNone(server.ask("shutdown"))
        self.assertEqual(server.fails("ping")["code"], -32600)
        server.notify("exit")
        self.assertEqual(server.program.wait(timeout=SECONDS), 0)
        server = self.server()
        server.notify("exit")
        self.assertEqual(server.program.wait(timeout=SECONDS), 1)

    def test_exit_ends_work(self):
        server, children = self.begun()
        server.ask("shutdown")
        server.notify("exit")
        self.assertEqual(server.program.wait(timeout=SECONDS), 0)
        self.check_gone(children)

    def test_the_end_of_input_waits_for_answers(self):
        self.angle()
        line = '{"jsonrpc": "2.0", "id": 1, "method": "unfold", "params": {"input": "part.step"}}'
        done = subprocess.run([CLI, "serve", "--stdio"], cwd=self.dir, input=line.encode(), capture_output=True, timeout=SECONDS)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertEqual(json.loads(done.stdout.splitlines()[-1])["result"]["status"], "ok")

    def test_but_not_when_nobody_waits_for_them(self):
        self.write("long.json", long_work())
        server = subprocess.Popen([CLI, "serve", "--stdio"], cwd=self.dir, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(server.kill)
        server.stdin.write(b'{"jsonrpc": "2.0", "id": 1, "method": "slit", "params": {"input": "long.json", "write": {"dxf": "a.dxf"}}}\n')
        server.stdin.close()
        self.assertIn(b"$/progress", server.stdout.readline())
        children = children_of(server.pid)
        server.stdout.close()
        server.wait(timeout=SECONDS)
        self.check_gone(children)

    def test_nor_at_a_signal(self):
        for how in (signal.SIGTERM, signal.SIGINT):
            server, children = self.begun()
            server.program.stdin.close()
            server.program.send_signal(how)
            self.assertEqual(server.program.wait(timeout=SECONDS), 1)
            self.check_gone(children)

    def test_a_killed_server_leaves_no_process(self):
        server, children = self.begun()
        server.program.kill()
        server.program.wait(timeout=SECONDS)
        self.check_gone(children)

    def test_a_client_that_vanishes_ends_it(self):
        """A client that is killed closes both ends at once."""
        self.write("long.json", long_work())
        script = ("import subprocess, sys, time\n"
                  "p = subprocess.Popen([sys.argv[1], 'serve', '--stdio'], stdin=subprocess.PIPE, stdout=subprocess.PIPE)\n"
                  "p.stdin.write(b'{\"jsonrpc\": \"2.0\", \"id\": 1, \"method\": \"slit\", \"params\": {\"input\": \"long.json\"}}\\n')\n"
                  "p.stdin.flush()\np.stdout.readline()\nprint(p.pid, flush=True)\ntime.sleep(1000)\n")
        client = subprocess.Popen([sys.executable, "-c", script, CLI], cwd=self.dir, stdout=subprocess.PIPE)
        server = int(client.stdout.readline())
        children = children_of(server)
        client.kill()
        client.communicate()
        self.assertTrue(until(lambda: not is_alive(server)))
        self.check_gone(children)


class CommandLine(ServeTest):
    def test_it_says_over_what(self):
        self.assertIn("--stdio", self.refused("serve", status=2))
        self.refused("serve", "--stdio", "--jobs", "0", status=2)

    def test_the_parameters_of_each_method_have_a_schema(self):
        """What the schema of a tool refuses, the method refuses, with the same place."""
        self.angle()
        server = self.server()
        tools = {tool["name"]: tool["inputSchema"] for tool in server.ask("tools/list")["tools"]}
        validator = jsonschema.Draft202012Validator(tools["unfold"])
        for params in ({"input": "part.step", "options": {"k": 0.4, "root": 1, "units": "inch"}, "artifacts": ["dxf"]},
                       {"input": "part.step", "options": {"lateral": "cut"}}, {"input": "part.step", "artifacts": ["mould.stl"]},
                       {"options": {}}, {"input": ""}, {"input": "part.step", "write": {"png": "a.png"}},
                       {"input": "part.step", "write": {"svg": "a.svg"}}):
            answer = server.answer(server.begin("unfold", params))
            self.assertEqual(validator.is_valid(params), "result" in answer, (params, answer))


if __name__ == "__main__":
    main()
