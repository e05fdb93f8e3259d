#!/usr/bin/python3
"""The C interface: what a program may rely on (abi.txt), and the same results as the command line's."""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

HERE = pathlib.Path(__file__).parent
sys.path[:0] = [str(HERE.parent / "cli"), str(HERE.parent / "support")]
import step_files  # noqa: E402
from damaged_test import long_work  # noqa: E402
from planish_cli import SOURCE, CliTest, main  # noqa: E402
from processes import children_of, is_alive, until  # noqa: E402

PROGRAM = os.environ["PLANISH_C_PROGRAM"]
LIBRARY = os.environ["PLANISH_C_LIBRARY"]
COMPILER = os.environ.get("PLANISH_C_COMPILER", "cc")
HEADER = SOURCE / "include" / "planish" / "planish.h"
EXAMPLES = SOURCE / "examples"
SECONDS = 300


def without_times(report):
    return {key: value for key, value in report.items() if key not in ("timing", "files")}


class Abi(unittest.TestCase):
    maxDiff = None

    def signatures(self):
        text = re.sub(r"/\*.*?\*/", "", HEADER.read_text(), flags=re.S)
        found = re.findall(r"PLANISH_API\s+([^;]*?\([^;]*?\))\s*;", text)
        return sorted(" ".join(one.split()).replace("( ", "(") for one in found)

    def test_it_is_the_one_that_is_written_down(self):
        layout = subprocess.run([PROGRAM, "abi"], capture_output=True, text=True, check=True).stdout.splitlines()
        self.assertEqual("\n".join(self.signatures() + layout) + "\n", (HERE / "abi.txt").read_text(),
                         "what was published stays: only additions, or another PLANISH_ABI")

    def test_the_library_exports_its_functions_and_nothing_else(self):
        listed = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], capture_output=True, text=True, check=True).stdout
        symbols = {line.split()[-1] for line in listed.splitlines() if line.split()[-2] != "A"}
        declared = {re.search(r"(planish_\w+)\(", one)[1] + "@@PLANISH_1" for one in self.signatures()}
        self.assertEqual(symbols, declared)

    def test_programs_find_it_by_its_abi(self):
        listed = subprocess.run(["readelf", "-d", LIBRARY], capture_output=True, text=True, check=True).stdout
        abi = re.search(r"#define PLANISH_ABI (\d+)", HEADER.read_text())[1]
        self.assertIn(f"soname: [libplanish.so.{abi}]", listed)
        self.assertRegex(listed, r"NODELETE")

    def test_the_header_is_c99_and_c_plus_plus(self):
        for language, standard in (("c", "c99"), ("c", "c17"), ("c++", "c++11"), ("c++", "c++20")):
            command = [COMPILER, "-x", language, f"-std={standard}", "-Wall", "-Wextra", "-pedantic", "-Werror", "-fsyntax-only",
                       "-I", str(HEADER.parents[1]), "-"]
            text = "#include <planish/planish.h>\nplanish_options o = PLANISH_OPTIONS_INIT;\n"
            done = subprocess.run(command, input=text, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""), standard)


class Runs(CliTest):
    def asked(self, where="apart", **request):
        """Status, exit status, code, place, sentence, files, report of a request."""
        self.write("request.json", json.dumps(request))
        folder = self.dir / "out"
        folder.mkdir(exist_ok=True)
        done = subprocess.run([PROGRAM, "run", "request.json", "out", where], cwd=self.dir, capture_output=True, timeout=SECONDS)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        status, end, code, place, sentence, *files = done.stdout.decode().splitlines()
        return int(status), int(end), code, place, sentence, [line.split() for line in files]

    def check_like_cli(self, maker, path, artifacts, options):
        """The files and the report of the command line are those of the library."""
        names = {artifact: f"cli{suffix}" for artifact, suffix in artifacts.items()}
        arguments = [word for artifact, name in names.items() for word in (options[artifact], name)]
        self.run_cli(maker, path, *arguments, "--json", "cli.json", "-q")
        for where in ("apart", "here"):
            *_, code, _, _, files = self.asked(where, maker=maker, input=str(path), artifacts=list(artifacts))
            self.assertEqual(code, "")
            self.assertEqual([one[0] for one in files], list(artifacts))
            for artifact, name, _ in files:
                self.assertEqual((self.dir / "out" / name).read_bytes(), (self.dir / names[artifact]).read_bytes(), (maker, artifact))
            self.assertEqual(without_times(self.json("out/report.json")), without_times(self.json("cli.json")))

    def test_they_make_what_the_command_line_makes(self):
        flat = {"dxf": "--flat", "svg": "--flat", "flat.step": "--flat", "step": "-o", "stl": "-o"}
        self.check_like_cli("unfold", EXAMPLES / "bracket.step", {"dxf": ".dxf", "svg": ".svg", "pdf": ".pdf"},
                            {"dxf": "-o", "svg": "-o", "pdf": "-o"})
        self.check_like_cli("connect", EXAMPLES / "connect" / "a_folded.json", {"dxf": ".dxf", "step": ".step", "stl": ".stl"}, flat)
        self.check_like_cli("transition", EXAMPLES / "transition" / "a_square_to_round.json", {"dxf": ".dxf", "stl": ".stl"}, flat)
        self.check_like_cli("slit", EXAMPLES / "slit" / "plume.json", {"dxf": ".dxf", "svg": ".svg"}, flat)

    def test_they_bend_and_inform(self):
        part = EXAMPLES / "bracket.step"
        self.run_cli("bend", part, "-o", "cli.svg", "-o", "cli.pdf", "--json", "cli.json", "-q")
        *_, files = self.asked(maker="bend", input=str(part), artifacts=["svg", "pdf"])
        self.assertEqual([one[0] for one in files], ["svg", "pdf"])
        for artifact, name, _ in files:
            self.assertEqual((self.dir / "out" / name).read_bytes(), (self.dir / f"cli.{artifact}").read_bytes())
        self.assertEqual(without_times(self.json("out/report.json")), without_times(self.json("cli.json")))
        self.run_cli("info", part, "--sheets", "--json", "cli.json")
        self.asked(maker="info", input=str(part), sheets=True)
        self.assertEqual(self.json("out/report.json"), self.json("cli.json"))

    def test_a_refusal_has_a_report_and_its_reason(self):
        self.write("block.step", step_files.block())
        status, end, code, _, sentence, files = self.asked(maker="unfold", input="block.step", artifacts=["dxf", "json"])
        self.assertEqual((status, end, code), (2, 4, "not_a_sheet"))
        self.assertEqual([one[0] for one in files], ["json"])
        report = self.json("out/report.json")
        self.assertEqual(report["status"], "refused")
        self.assertEqual(report["reason"]["message"], sentence)

    def test_what_crashes_is_told(self):
        self.write("long.json", long_work())
        self.write("request.json", json.dumps({"maker": "slit", "input": "long.json"}))
        (self.dir / "out").mkdir()
        program = subprocess.Popen([PROGRAM, "run", "request.json", "out", "apart"], cwd=self.dir, stdout=subprocess.PIPE)
        self.addCleanup(program.kill)
        self.assertTrue(until(lambda: children_of(program.pid)))
        time.sleep(0.3)  # until it is at work
        os.kill(children_of(program.pid)[0], signal.SIGSEGV)
        status, end, code, place, sentence = program.communicate(timeout=SECONDS)[0].decode().splitlines()
        self.assertEqual((status, end, code, place), ("3", "3", "crashed", "long.json"))
        self.assertIn("segmentation fault", sentence)

    def test_no_process_outlives_the_program(self):
        self.write("long.json", long_work())
        self.write("request.json", json.dumps({"maker": "slit", "input": "long.json"}))
        program = subprocess.Popen([PROGRAM, "run", "request.json", ".", "apart"], cwd=self.dir, stdout=subprocess.PIPE)
        self.assertTrue(until(lambda: children_of(program.pid)))
        child = children_of(program.pid)[0]
        program.kill()
        program.communicate(timeout=SECONDS)
        self.assertTrue(until(lambda: not is_alive(child)))

    def test_errors_progress_threads_and_schemas(self):
        self.write("bracket.json", json.dumps({"maker": "unfold", "input": str(EXAMPLES / "bracket.step"), "artifacts": ["dxf"]}))
        self.write("plates.json", json.dumps({"maker": "connect", "input": str(EXAMPLES / "connect" / "a_folded.json"),
                                              "artifacts": ["step"]}))
        self.write("long.json", long_work())
        self.write("slit.json", json.dumps({"maker": "slit", "input": str(self.dir / "long.json")}))
        done = subprocess.run([PROGRAM, "all", "bracket.json", "plates.json", "slit.json"], cwd=self.dir, capture_output=True,
                              timeout=SECONDS)
        self.assertEqual((done.returncode, done.stdout, done.stderr.decode()), (0, b"", ""))


if __name__ == "__main__":
    main()
