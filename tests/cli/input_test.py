#!/usr/bin/python3
"""Inputs that cannot be read: exit status 3, the reason in one sentence and in the JSON report."""

import gzip
import json
import os
import pathlib
import signal
import subprocess
import sys
import unittest
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import step_files  # noqa: E402
from planish_cli import CLI, SECONDS, CliTest, main  # noqa: E402


class UnreadableInput(CliTest):
    def unreadable(self, code, *arguments, status=3, stdin=b""):
        sentence = self.refused("unfold", *arguments, "-o", "out.dxf", "--json", "report.json",
                                status=status, stdin=stdin)
        self.assertIn(f"[{code}]", sentence)
        report = self.json("report.json")
        self.assertEqual(report["status"], "refused")
        self.assertEqual(report["reason"]["code"], code)
        self.assertTrue(report["reason"]["message"])
        self.assertEqual(report["input"], arguments[0])
        self.assertNotIn("out.dxf", self.names())
        (self.dir / "report.json").unlink()

    def test_missing_file(self):
        self.unreadable("cannot_read", "missing.step")
        self.refused("info", "missing.step", "--json", "info.json", status=3)
        self.assertEqual(self.json("info.json")["reason"]["code"], "cannot_read")

    def test_folder(self):
        (self.dir / "folder").mkdir()
        self.unreadable("cannot_read", "folder")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_forbidden_file(self):
        self.angle().chmod(0)
        self.unreadable("cannot_read", "part.step")

    def test_empty_file(self):
        self.write("empty.step", "")
        self.unreadable("empty_file", "empty.step")
        self.unreadable("empty_file", "-")

    def test_what_is_not_step(self):
        for content in (b"hello\n", b"solid cube\nendsolid\n"):
            self.write("other.step", content)
            self.unreadable("not_step", "other.step")
        self.unreadable("not_step", "-", stdin=b"hello\n")
        self.write("cut.step", b"PK\x03\x04" + bytes(range(256)))
        self.unreadable("truncated_file", "cut.step")

    def test_truncated_file(self):
        whole = step_files.angle()
        for share in (0.3, 0.5, 0.9):
            self.write("half.step", whole[:int(share * len(whole))])
            self.unreadable("truncated_file", "half.step")

    def test_surfaces_only(self):
        self.write("skin.step", step_files.surface_only())
        self.unreadable("shell_not_solid", "skin.step")

    def test_bend_table_that_is_missing_or_wrong(self):
        self.angle()
        self.unreadable("cannot_read", "part.step", "--k-table", "missing.csv")
        self.write("table.csv", "radius,angle\n1,90\n")
        self.unreadable("invalid_input", "part.step", "--k-table", "table.csv")

    def test_rules_file_that_is_missing_or_wrong(self):
        self.angle()
        self.unreadable("cannot_read", "part.step", "--rules", "missing.json")
        self.write("rules.json", '{"flange_heigth_t": 2}')
        self.unreadable("invalid_input", "part.step", "--rules", "rules.json")
        self.assertIn("/flange_heigth_t",
                      self.refused("unfold", "part.step", "--rules", "rules.json", status=3))

    def test_solid_that_is_no_sheet(self):
        self.write("block.step", step_files.block())
        self.unreadable("not_a_sheet", "block.step", status=4)

    def test_body_that_is_not_there(self):
        self.angle()
        self.unreadable("no_such_body", "part.step", "--body", "7", status=2)
        self.unreadable("no_such_body", "part.step", "--body", "door", status=2)

    def test_face_that_is_not_there(self):
        self.angle()
        self.unreadable("no_such_face", "part.step", "--root", "999", status=2)
        self.unreadable("no_such_face", "part.step", "--up", "999", status=2)


class OtherForms(CliTest):
    """What a mailbox does to a STEP file."""

    def pattern(self, name):
        self.run_cli("unfold", name, "-q", "-o", "out.dxf")
        return (self.dir / "out.dxf").read_bytes()

    def test_packed_files_and_byte_order_marks_are_read(self):
        text = step_files.angle().encode()
        self.write("part.step", text)
        expected = self.pattern("part.step")
        self.write("part.step.gz", gzip.compress(text))
        self.write("part.stpz", gzip.compress(text))
        self.write("mark.step", b"\xef\xbb\xbf" + text)
        with zipfile.ZipFile(self.dir / "part.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("sent/readme.txt", "Please cut.")
            archive.writestr("sent/part.stp", text)
        for name in ("part.step.gz", "part.stpz", "mark.step", "part.zip"):
            with self.subTest(name):
                self.assertEqual(self.pattern(name), expected)
                self.assertIn("1 body", self.run_cli("info", name)[0])
        self.run_cli("unfold", "-", "-q", "-o", "out.dxf", stdin=gzip.compress(text))
        for name in ("part.step", "out.dxf"):
            (self.dir / name).unlink()
        self.run_cli("unfold", "part.step.gz", "-q")
        self.assertIn("part.dxf", self.names())

    def test_an_archive_that_is_no_part_says_why(self):
        text = step_files.angle().encode()
        with zipfile.ZipFile(self.dir / "two.zip", "w") as archive:
            archive.writestr("a.step", text)
            archive.writestr("b.step", text)
        said = self.refused("unfold", "two.zip", "-o", "out.dxf", status=3)
        self.assertIn("an archive of 2 STEP files", said)
        self.assertIn("two.zip/a.step", said)
        self.run_cli("unfold", "two.zip/a.step", "-q", "-o", "a.dxf")
        self.assertIn("no file c.step", self.refused("unfold", "two.zip/c.step", "-o", "c.dxf", status=3))
        with zipfile.ZipFile(self.dir / "none.zip", "w") as archive:
            archive.writestr("offer.txt", "Please cut.")
        self.assertIn("an archive without a STEP file (.step, .stp, .p21): it holds 1 other file",
                      self.refused("unfold", "none.zip", "-o", "out.dxf", status=3))
        self.write("short.step.gz", gzip.compress(text)[:-100])
        self.assertIn("[truncated_file]", self.refused("unfold", "short.step.gz", "-o", "out.dxf", status=3))

    def test_a_size_that_no_shop_has_is_asked_about(self):
        self.write("metres.step", step_files.angle().replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)"))
        out, _ = self.run_cli("unfold", "metres.step", "-o", "out.dxf", "--json", "r.json")
        self.assertIn("the sheet is 2000 mm thick", out)
        report = self.json("r.json")
        self.assertEqual(report["status"], "warning")
        self.assertEqual(report["checks"][0]["code"], "unlikely_size")
        self.assertAlmostEqual(report["checks"][0]["numbers"]["thickness"]["value"], 2000, places=6)

    def test_a_surface_beside_a_solid_is_mentioned(self):
        self.write("part.step", step_files.angle_beside_a_skin())
        out, _ = self.run_cli("unfold", "part.step", "--json", "r.json")
        said = "The file also holds 1 surface body, not part of a solid: left out."
        self.assertIn(f"note: {said}", out)
        self.assertEqual(self.json("r.json")["notes"], [said])
        out, _ = self.run_cli("unfold", "part.step", "--all", "-o", "flat/", "--json", "s.json")
        self.assertIn(f"note: {said}", out)
        self.assertEqual(self.json("s.json")["surface_bodies"], 1)


class UnwritableOutput(CliTest):
    def test_folder_that_is_not_there(self):
        self.angle()
        sentence = self.refused("unfold", "part.step", "-o", "missing/a.dxf", status=3)
        self.assertIn("[cannot_write]", sentence)
        self.refused("unfold", "part.step", "--json", "missing/a.json", status=3)
        self.assertEqual(self.names(), ["part.step"])

    def test_folder_where_a_file_should_be(self):
        self.angle()
        (self.dir / "old").mkdir()
        for options in (["--json", "."], ["--json", "old"], ["-o", "a.dxf", "--json", "old"]):
            sentence = self.refused("unfold", "part.step", *options, status=3)
            self.assertIn("Is a directory [cannot_write]", sentence)
        self.refused("unfold", "part.step", "--all", "-o", "flat/", "--json", ".", status=3)
        self.refused("info", "part.step", "--json", "old", status=3)
        self.assertEqual(self.names(), ["part.step"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_all_files_are_written_or_none(self):
        self.angle()
        self.refused("unfold", "part.step", "--json", "/dev/full", status=3)
        self.refused("unfold", "part.step", "--all", "-o", "flat/", "--json", "/dev/full", status=3)
        self.assertEqual(self.names(), ["part.step"])

    def test_file_where_a_folder_should_be(self):
        self.angle()
        self.write("flat.txt", "")
        sentence = self.refused("unfold", "part.step", "-o", "flat.txt/", "--json", "r.json", status=3)
        self.assertIn("[cannot_write]", sentence)
        self.assertEqual(self.json("r.json")["reason"]["code"], "cannot_write")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_folder_that_may_not_be_written(self):
        self.angle()
        locked = self.dir / "locked"
        locked.mkdir(mode=0o555)
        self.refused("unfold", "part.step", "-o", "locked/", status=3)
        self.assertEqual(self.names(), ["part.step"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_standard_output_that_is_full(self):
        self.angle()
        with open("/dev/full", "wb") as full:
            done = subprocess.run([CLI, "info", "part.step"], cwd=self.dir, stdout=full,
                                  stderr=subprocess.PIPE, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 3, done.stderr)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_no_file_is_left_where_the_report_cannot_be_printed(self):
        self.angle()
        plates = {"format": "planish/plates", "version": 1, "units": "mm", "thickness": 1, "plates": [
            {"id": "A", "outline": [[0, 0, 0], [9, 0, 0], [9, 9, 0]]}]}
        self.write("plates.json", json.dumps(plates))
        for words in (["unfold", "part.step"], ["unfold", "part.step", "--json", "-"],
                      ["unfold", "part.step", "--all", "-o", "flat/", "--json", "-"],
                      ["unfold", "part.step", "-o", "a.svg", "--json", "r.json"],
                      ["connect", "plates.json", "-o", "a.step", "--flat", "a.dxf"], ["plates", "part.step", "-o", "-"],
                      ["schema", "report"]):
            with self.subTest(words=words), open("/dev/full", "wb") as full:
                done = subprocess.run([CLI, *words], cwd=self.dir, stdout=full, stderr=subprocess.PIPE,
                                      timeout=SECONDS, check=False)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertEqual(done.stderr, b"planish: cannot write to standard output [cannot_write]\n")
                files = [path for path in self.dir.rglob("*") if path.is_file()]
                self.assertEqual(sorted(path.name for path in files), ["part.step", "plates.json"])

    def test_files_appear_though_nobody_reads_the_report(self):
        self.angle()
        read, write = os.pipe()
        os.close(read)
        with os.fdopen(write, "wb") as nobody:
            subprocess.run([CLI, "unfold", "part.step", "--json", "-"], cwd=self.dir, stdout=nobody,
                           stderr=subprocess.PIPE, timeout=SECONDS, check=False)
        self.assertEqual(self.names(), ["part.dxf", "part.step"])


class Interrupted(CliTest):
    def test_ctrl_c_stops_with_a_word(self):
        arguments = [CLI, "unfold", "-", "-o", "a.dxf", "--json", "r.json"]
        with subprocess.Popen(arguments, cwd=self.dir, stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
            # More than a pipe holds: once it is written, the program is up and reading.
            running.stdin.write(step_files.angle().encode() + b" " * 300_000)
            running.stdin.flush()
            running.send_signal(signal.SIGINT)
            out, err = running.communicate(timeout=SECONDS)
        self.assertEqual((running.returncode, out, err), (1, b"", b"planish: cancelled\n"))
        self.assertEqual(self.names(), [])


if __name__ == "__main__":
    main()
