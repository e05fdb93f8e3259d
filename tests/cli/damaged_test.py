#!/usr/bin/python3
"""Whatever a file holds: one sentence, exit status 3 or 4, in time, and nothing half written."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent / "../support"))
import step_files  # noqa: E402
from planish_cli import CLI, SECONDS, SOURCE, CliTest, main  # noqa: E402
from processes import children_of, is_alive, until  # noqa: E402

CORPUS = sorted((SOURCE / "tests" / "fuzz" / "corpus").iterdir())
CHAIR = SOURCE / "examples" / "slit" / "chair.json"


def long_work():
    """A slit file whose result takes long: many strips, finely divided."""
    spec = json.loads(CHAIR.read_text())
    strips = 60
    width = spec["sheet"]["strip_width"] * strips
    spec["sheet"]["strips"] = strips
    return json.dumps(dict(
        spec, ridges=20, subdivisions=6, leg_curve={"bezier": [[360, 0], [360, width]]},
        seat_curve={"bezier": [[330, 0], [300, width / 3], [310, 2 * width / 3], [640, width]]}))


class DamagedFiles(CliTest):
    def answered(self, *arguments):
        """A run on whatever it may be."""
        done = subprocess.run([CLI, *map(str, arguments)], cwd=self.dir, capture_output=True,
                              timeout=SECONDS, check=False)
        said = done.stderr.decode()
        self.assertIn(done.returncode, (0, 3, 4), f"{arguments}\n{said}")
        self.assertEqual(done.stdout, b"")
        if done.returncode:
            self.assertRegex(said, r"^planish: [^\n]+\[\w+\][^\n]*\n$")
        else:
            self.assertEqual(said, "")
        return done.returncode

    def test_each_file_of_the_corpus_is_answered(self):
        commands = {".step": "unfold", ".json": None}
        for file in CORPUS:
            if file.suffix not in commands:
                continue
            with self.subTest(file.name):
                command = commands[file.suffix] or file.name.split("-")[0]
                status = self.answered(command, file, "-q", "--time-limit", "20", "--json", "r.json",
                                       *(["-o", "out.dxf"] if command == "unfold" else
                                         ["--flat", "out.dxf"]))
                report = self.json("r.json")
                self.assertEqual(report["status"] == "refused", status != 0)
                self.assertEqual("out.dxf" in self.names(), status == 0)
                for name in self.names():
                    (self.dir / name).unlink()

    def test_huge_coordinates_are_refused(self):
        for number in ("1e11", "-4E+150", "1e999"):
            text = step_files.angle().replace("50.000000000000", number, 1)
            self.write("far.step", text)
            sentence = self.refused("unfold", "far.step", "-o", "out.dxf", status=3)
            self.assertIn("[too_far_away]", sentence)
            self.assertEqual(self.names(), ["far.step"])

    def test_a_large_but_sound_part_is_not(self):
        self.angle(leg=5e6, thickness=2000.0, radius=2000.0, depth=6e6)
        self.run_cli("unfold", "part.step", "-q", "--check", "--no-rules")


class Limits(CliTest):
    def test_what_takes_longer_is_given_up(self):
        self.write("long.json", long_work())
        begun = time.monotonic()
        sentence = self.refused("slit", "long.json", "-o", "out.stl", "--json", "r.json",
                                "--time-limit", "0.5", status=4)
        self.assertLess(time.monotonic() - begun, 10.0)
        self.assertIn("given up after 0.5 s", sentence)
        self.assertIn("[out_of_time]", sentence)
        self.assertEqual(self.json("r.json")["reason"]["code"], "out_of_time")
        self.assertEqual(self.names(), ["long.json", "r.json"])

    def test_what_needs_more_memory_is_given_up(self):
        spec = json.loads(CHAIR.read_text())
        spec.update(ridges=1000, subdivisions=3, leg_curve={"bezier": [[360, 0], [360, 10000]]},
                    seat_curve={"bezier": [[330, 0], [310, 10000]]})
        spec["sheet"].update(strips=10000, strip_width=1)
        self.write("huge.json", json.dumps(spec))
        done = subprocess.run([CLI, "slit", "huge.json", "-o", "out.stl", "--memory-limit", "200"],
                              cwd=self.dir, capture_output=True, timeout=SECONDS, check=False)
        if b"Sanitizer" in done.stderr:
            self.skipTest("built with sanitizers, which need any amount of memory")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn(b"needs more memory than the 200 MiB allowed", done.stderr)
        self.assertEqual(self.names(), ["huge.json"])

    def test_limits_are_checked(self):
        self.angle()
        for option, value in (("--time-limit", "0"), ("--time-limit", "soon"),
                              ("--memory-limit", "1"), ("--memory-limit", "-5")):
            self.refused("unfold", "part.step", option, value, status=2)

    def test_info_has_them(self):
        self.angle()
        self.assertIn("angle", self.run_cli("info", "part.step", "--time-limit", "60",
                                            "--memory-limit", "4000")[0])
        sentence = self.refused("info", "part.step", "--time-limit", "0.001", status=4)
        self.assertIn("[out_of_time]", sentence)


class BothProcesses(CliTest):
    def begun(self):
        self.write("long.json", long_work())
        program = subprocess.Popen([CLI, "slit", "long.json", "-o", "out.stl"], cwd=self.dir,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   start_new_session=True)
        self.addCleanup(program.kill)
        self.assertTrue(until(lambda: children_of(program.pid)))
        return program, children_of(program.pid)[0]

    def check_end(self, program, child):
        out, said = program.communicate(timeout=SECONDS)
        self.assertTrue(until(lambda: not is_alive(child)))
        self.assertEqual(out, b"")
        self.assertEqual(self.names(), ["long.json"])
        return said

    def test_ctrl_c_ends_them(self):
        program, child = self.begun()
        begun = time.monotonic()
        os.killpg(program.pid, signal.SIGINT)
        self.assertEqual(self.check_end(program, child), b"planish: cancelled\n")
        self.assertEqual(program.returncode, 1)
        self.assertLess(time.monotonic() - begun, 5.0)

    def test_so_does_sigterm_for_the_program_alone(self):
        program, child = self.begun()
        program.terminate()
        self.assertEqual(self.check_end(program, child), b"planish: cancelled\n")
        self.assertEqual(program.returncode, 1)

    def test_a_killed_program_leaves_no_process(self):
        program, child = self.begun()
        program.kill()
        self.check_end(program, child)

    def test_a_killed_child_is_answered(self):
        for how, code, status in ((signal.SIGSEGV, b"crashed", 3),
                                  (signal.SIGKILL, b"out_of_memory", 4)):
            program, child = self.begun()
            os.kill(child, how)
            said = self.check_end(program, child)
            self.assertEqual(program.returncode, status, said)
            self.assertIn(b"[" + code + b"]", said)
            self.assertEqual(said.count(b"\n"), 1, said)

    def test_closed_standard_streams_confuse_nobody(self):
        self.angle()
        for closed in ("<&-", ">&-", "2>&-", "<&- >&- 2>&-"):
            done = subprocess.run(["sh", "-c", f'"$0" unfold part.step -q -o out.dxf {closed}', CLI],
                                  cwd=self.dir, capture_output=True, timeout=SECONDS, check=False)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"", b""), closed)
            self.assertTrue((self.dir / "out.dxf").read_text().endswith("EOF\n"))
            (self.dir / "out.dxf").unlink()


if __name__ == "__main__":
    main()
