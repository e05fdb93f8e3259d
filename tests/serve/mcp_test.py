#!/usr/bin/python3
"""`planish serve --stdio` as a server of Model Context Protocol: a conversation as an agent has it."""

import json
import pathlib
import re
import sys

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_serve import EXAMPLES, SOURCE, ServeTest  # noqa: E402
import step_files  # noqa: E402
from damaged_test import long_work  # noqa: E402
from planish_cli import main  # noqa: E402

VERSIONS = ("2024-11-05", "2025-03-26", "2025-06-18")
TOOLS = ["unfold", "connect", "transition", "slit", "bend", "info", "schema", "formats"]


class Mcp(ServeTest):
    def greeted(self, version=VERSIONS[-1], *arguments):
        server = self.server(*arguments)
        answer = server.ask("initialize", {"protocolVersion": version, "capabilities": {"roots": {"listChanged": True}},
                                           "clientInfo": {"name": "test", "version": "1"}})
        server.notify("notifications/initialized")
        return server, answer

    def called(self, server, name, /, **arguments):
        """The result of a tool, its form checked."""
        result = server.ask("tools/call", {"name": name, "arguments": arguments})
        self.assertLessEqual({"content", "isError"}, set(result))
        self.assertGreaterEqual(len(result["content"]), 1)
        for item in result["content"]:
            self.assertEqual((item["type"], set(item)), ("text", {"type", "text"}))
            self.assertTrue(item["text"])
        self.assertIsInstance(result["structuredContent"], dict)
        return result

    def test_they_greet_each_other(self):
        for version in VERSIONS:
            server, answer = self.greeted(version)
            self.assertEqual(answer["protocolVersion"], version)
            self.assertIn("tools", answer["capabilities"])
            self.assertEqual(answer["serverInfo"]["name"], "planish")
            self.assertEqual("planish " + answer["serverInfo"]["version"], self.run_cli("--version")[0].strip())
            self.assertEqual(server.ask("ping"), {})
            self.check_end(server)
        self.assertEqual(self.greeted("1999-01-01")[1]["protocolVersion"], VERSIONS[-1])

    def test_tools_have_schemas_and_descriptions(self):
        server, _ = self.greeted()
        tools = server.ask("tools/list", {})["tools"]
        self.assertEqual([tool["name"] for tool in tools], TOOLS)
        descriptions = self.run_cli("--formats")[0]
        for tool in tools:
            self.assertRegex(tool["name"], r"^[a-zA-Z0-9_-]{1,64}$")
            self.assertRegex(tool["description"], r"^[A-Z][^\n]+\.$")
            self.assertEqual(tool["inputSchema"]["type"], "object")
            jsonschema.Draft202012Validator.check_schema(tool["inputSchema"])
            self.assertFalse(jsonschema.Draft202012Validator(tool["inputSchema"]).is_valid({"none": 1}))
        for tool in tools[:4]:
            validator = jsonschema.Draft202012Validator(tool["inputSchema"])
            self.assertTrue(validator.is_valid({"input": "a", "artifacts": ["dxf"], "write": {"dxf": "a.dxf"}}))
            self.assertFalse(validator.is_valid({"artifacts": ["dxf"]}))
            self.assertIn(tool["description"].split(".")[0].lower(), descriptions.lower())
            own = re.search(rf"^  {tool['name']} .*\n +writes (.*)", descriptions, re.M)[1].split()
            self.assertEqual(tool["inputSchema"]["properties"]["artifacts"]["items"]["enum"], own)
            help_text = self.run_cli(tool["name"], "--help")[0]
            for option in tool["inputSchema"]["properties"]["options"]["properties"]:
                if option != "piece":
                    self.assertIn("--" + option.replace("_", "-"), help_text)

    def test_examples_by_tools(self):
        server, _ = self.greeted()
        parts = [("unfold", EXAMPLES / "bracket.step")]
        parts += [(maker, path) for maker in ("connect", "transition", "slit") for path in sorted((EXAMPLES / maker).glob("*.json"))[:2]]
        validator = jsonschema.Draft202012Validator(json.loads((SOURCE / "docs" / "schema" / "report.json").read_text()))
        for maker, path in parts:
            result = self.called(server, maker, input=str(path), write={"dxf": f"{maker}.dxf"})
            self.assertIs(result["isError"], False)
            self.assertEqual(len(result["content"]), 1)
            self.assertIn("blank", result["content"][0]["text"])
            self.assertTrue(validator.is_valid(result["structuredContent"]["report"]))
            self.assertEqual(result["structuredContent"]["artifacts"][0]["path"], f"{maker}.dxf")
            self.assertTrue((self.dir / f"{maker}.dxf").read_text().endswith("EOF\n"))
        self.assertIn("order", json.dumps(self.called(server, "bend", input=str(EXAMPLES / "bracket.step"))["structuredContent"]))
        self.assertIn("bracket", self.called(server, "info", input=str(EXAMPLES / "bracket.step"))["content"][0]["text"])
        self.assertEqual(self.called(server, "schema", name="plates")["structuredContent"]["title"], "planish/plates")
        self.assertEqual(json.loads(self.called(server, "formats")["content"][0]["text"])["makers"][0]["name"], "unfold")

    def test_older_clients_read_the_report_as_text(self):
        server, _ = self.greeted("2024-11-05")
        result = self.called(server, "unfold", input=str(EXAMPLES / "bracket.step"))
        self.assertEqual(json.loads(result["content"][1]["text"]), result["structuredContent"])

    def test_refusals_and_errors_are_for_the_model_to_read(self):
        self.write("block.step", step_files.block())
        server, _ = self.greeted()
        result = self.called(server, "unfold", input="block.step")
        self.assertIs(result["isError"], True)
        reason = result["structuredContent"]["report"]["reason"]
        self.assertEqual(reason["code"], "not_a_sheet")
        self.assertIn("not_a_sheet", result["content"][0]["text"])
        self.assertIn(reason["message"], result["content"][0]["text"])
        for arguments, code, where in (({"input": "none.step"}, "cannot_read", "none.step"), ({}, "invalid_input", "/input"),
                                       ({"input": "block.step", "options": {"k": 7}}, "invalid_input", "/options/k"),
                                       ({"input": "block.step", "write": {"dxf": "block.step"}}, "bad_option", "/write/dxf")):
            result = self.called(server, "unfold", **arguments)
            self.assertIs(result["isError"], True)
            self.assertEqual((result["structuredContent"]["code"], result["structuredContent"]["where"]), (code, where))
            self.assertTrue(result["content"][0]["text"].startswith(f"[{code}] "), result)
            self.assertIn(where, result["content"][0]["text"])
        self.assertIs(self.called(server, "schema", name="none")["isError"], True)

    def test_calls_that_are_none(self):
        server, _ = self.greeted()
        for params in ({}, {"name": "fold"}, {"name": 7}, {"name": "unfold", "arguments": []}, {"name": "tools/call", "arguments": {}}):
            self.assertEqual(server.fails("tools/call", params)["code"], -32602, params)
        for method in ("resources/list", "prompts/list", "sampling/createMessage"):
            self.assertEqual(server.fails(method, {})["code"], -32601)

    def test_progress_goes_by_its_token_and_grows(self):
        server, _ = self.greeted()
        for token in ("a", 7):
            server.told.clear()
            server.ask("tools/call", {"name": "unfold", "arguments": {"input": str(EXAMPLES / "bracket.step")},
                                      "_meta": {"progressToken": token}})
            self.assertGreater(len(server.told), 1)
            self.assertEqual({one["method"] for one in server.told}, {"notifications/progress"})
            shares = [one["params"]["progress"] for one in server.told]
            self.assertEqual(shares, sorted(set(shares)))
            for one in server.told:
                self.assertEqual(one["params"]["progressToken"], token)
                self.assertTrue(one["params"]["message"])
        server.told.clear()
        self.called(server, "unfold", input=str(EXAMPLES / "bracket.step"))
        self.assertEqual(server.told, [])

    def test_a_cancelled_call_has_no_answer(self):
        self.write("long.json", long_work())
        server, _ = self.greeted(VERSIONS[-1], "--jobs", 1)
        number = server.begin("tools/call", {"name": "slit", "arguments": {"input": "long.json"}, "_meta": {"progressToken": 1}})
        server.hear()
        server.notify("notifications/cancelled", {"requestId": number, "reason": "the user"})
        self.assertEqual(self.called(server, "info", input=str(EXAMPLES / "bracket.step"))["isError"], False)
        server.notify("notifications/cancelled", {"requestId": 12345})
        self.check_end(server)
        self.assertNotIn(number, server.answers)


if __name__ == "__main__":
    main()
