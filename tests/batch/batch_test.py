#!/usr/bin/python3
"""Batches: each part as `planish unfold` makes it, the same bytes however the work is shared, and
nothing lost when workers or the batch itself are ended."""

import csv
import gzip
import json
import math
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from batch_case import CLI, PARTS, SECONDS, SOURCE, BatchTest, main, step_files  # noqa: E402
from processes import children_of, is_alive, until  # noqa: E402

CORPUS = SOURCE / "tests" / "fuzz" / "corpus"
CHAIR = SOURCE / "examples" / "slit" / "chair.json"


def flat_length(leg, thickness=2.0, radius=2.0, k=0.44):
    return 2 * (leg - thickness - radius) + math.pi / 2 * (radius + k * thickness)


def long_work():
    """A slit file whose result takes minutes."""
    spec = json.loads(CHAIR.read_text())
    strips = 200
    width = spec["sheet"]["strip_width"] * strips
    spec["sheet"]["strips"] = strips
    return json.dumps(dict(
        spec, ridges=20, subdivisions=6, leg_curve={"bezier": [[360, 0], [360, width]]},
        seat_curve={"bezier": [[330, 0], [300, width / 3], [310, 2 * width / 3], [640, width]]}))


class Results(BatchTest):
    def test_each_part_is_laid_flat(self):
        self.angles(12)
        self.batch("in", "-o", "out", "--format", "dxf,svg,json,step")
        reports = self.reports()
        self.assertEqual([one["input"] for one in reports], [f"angle-{i:03}.step" for i in range(12)])
        for i, report in enumerate(reports):
            self.assertAlmostEqual(report["flat"]["size"][0], flat_length(40.0 + 0.25 * i), 6)
            folder = self.dir / "out" / "parts" / report["input"]
            self.assertEqual(sorted(path.suffix for path in folder.iterdir()),
                             [".dxf", ".json", ".step", ".svg", ".svg"])
            self.assertEqual(json.loads((folder / "report.json").read_text()), report)
            for file in report["files"]:
                self.assertTrue((self.dir / "out" / "parts" / file).is_file(), file)

    def test_reports_and_drawings_are_those_of_the_makers(self):
        (self.dir / "in").mkdir()
        for file in (SOURCE / "examples").rglob("*.json"):
            if "planish/" in file.read_text() and file.parent.name in ("connect", "transition"):
                shutil.copy(file, self.dir / "in")
        shutil.copy(SOURCE / "examples" / "bracket.step", self.dir / "in")
        real = sorted(PARTS.glob("sm*.step"))[:25] if PARTS.is_dir() else []
        for file in real:
            shutil.copy(file, self.dir / "in")
        self.batch("in", "-o", "out", "--k", "0.4")
        reports = {one["input"]: one for one in self.reports()}
        single = {name: one for name, one in reports.items()
                  if one["command"] != "unfold" or one.get("quantity") == 1}
        self.assertGreater(len(single), 3)
        for name, report in single.items():
            if report.get("body") and list(reports).count(name) > 1:
                continue
            with self.subTest(name):
                out = ["-o" if report["command"] == "unfold" else "--flat", "flat.dxf"]
                done = subprocess.run([CLI, report["command"], f"in/{name}", "--k", "0.4", "-q",
                                       "--json", "one.json", *out], cwd=self.dir,
                                      capture_output=True, timeout=SECONDS, check=False)
                self.assertIn(done.returncode, (0, 4))
                alone = self.json("one.json")
                for key in ("status", "reason", "sheet", "flat", "verification", "checks", "notes"):
                    self.assertEqual(alone[key], report[key], key)
                drawings = [self.dir / "out" / "parts" / file for file in report["files"]]
                if len(drawings) == 1:
                    self.assertEqual((self.dir / "flat.dxf").read_bytes(), drawings[0].read_bytes())
        if not real:
            self.skipTest(f"only examples: there are no real parts in {PARTS}")

    def test_the_table_agrees_with_the_reports(self):
        self.angles(3)
        self.write("in/block.step", step_files.block())
        self.batch("in", "-o", "out")
        rows = list(csv.DictReader((self.dir / "out" / "summary.csv").open()))
        for row, report in zip(rows, self.reports(), strict=True):
            self.assertEqual((row["input"], row["status"]), (report["input"], report["status"]))
            if report["flat"]:
                for cell, value in ((row["area"], report["flat"]["area"]), (row["thickness"], report["sheet"]["thickness"])):
                    self.assertAlmostEqual(float(cell), value, delta=6e-6 * value)
                    self.assertLessEqual(len(cell.replace(".", "").lstrip("0")), 6)
        summary = self.json("out/summary.json")
        self.assertEqual((summary["parts"], summary["ok"], summary["refused"]), (4, 3, 1))
        self.assertEqual(sum(summary["reasons"].values()), 1)

    def test_what_would_help_at_the_press_brake_is_told(self):
        (self.dir / "in").mkdir()
        self.write("in/deep.json", json.dumps(step_files.deep_channel()))
        self.batch("in", "-o", "out", "--check-bending")
        (report,) = self.reports()
        (check,) = [check for check in report["checks"] if check["code"] == "cannot_bend"]
        changes = [one["change"] for one in check.get("remedies", [check["remedy"]])]
        self.assertTrue(all(change.startswith("Bend it ") for change in changes), changes)
        (row,) = csv.DictReader((self.dir / "out" / "summary.csv").open())
        self.assertEqual(row["remedies"], "; ".join(changes))
        page = (self.dir / "out" / "index.html").read_text()
        for change in changes:
            self.assertIn(change.removeprefix("Bend it "), page)

    def test_results_come_first_and_reasons_in_words(self):
        self.angles(2)
        for name in ("in/a.step", "in/b.step"):
            self.write(name, step_files.block())
        self.write("in/drawing.pdf", "%PDF")
        said = self.batch("in", "-o", "out").stdout.splitlines()
        self.assertEqual(said[0], "4 parts of 4 inputs: 2 ok, 0 with warnings, 2 refused")
        at = said.index("refused:")
        self.assertGreater(at, said.index("wrote out/index.html"))
        reason = next(report["reason"]["message"] for report in self.reports() if report["reason"])
        self.assertEqual(said[at + 1], f"  a.step and 1 more: {reason}", "one line for one reason")
        self.assertEqual(said[at + 2:], ["passed over (1):", "  drawing.pdf: no file that planish reads"])
        self.assertEqual(self.json("out/summary.json")["passed_over"],
                         {"count": 1, "files": [{"file": "drawing.pdf", "reason": "no_input",
                                                 "why": "no file that planish reads"}]})

    def test_identical_parts_are_found(self):
        (self.dir / "in").mkdir()
        self.angle("in/a.step")
        self.write("in/b.step", step_files.angle(name="another name"))
        self.angle("in/c.step", leg=50.01)
        self.batch("in", "-o", "out")
        rows = list(csv.DictReader((self.dir / "out" / "summary.csv").open()))
        self.assertEqual([row["same_as"] for row in rows], ["", "a.step", ""])
        self.assertEqual(self.json("out/summary.json")["distinct"], 2)

    def test_files_folders_and_lists(self):
        (self.dir / "in" / "deep").mkdir(parents=True)
        (self.dir / "in" / ".hidden").mkdir()
        for name in ("in/deep/a.STP", "in/b.Step", "in/.hidden/c.step", "d.step"):
            self.angle(name)
        self.write("in/notes.json", "{}")
        self.write("in/readme.txt", "text")
        self.write("list.txt", "# parts\nin\n\nd.step\nin/b.Step\n")
        self.batch("@list.txt", "-o", "out")
        self.assertEqual([one["input"] for one in self.reports()],
                         ["b.Step", "d.step", "deep/a.STP"])
        self.write("in/list.txt", "../d.step\nb.Step\ndeep/a.STP\n")
        self.batch("@in/list.txt", "-o", "other")
        self.assertEqual([one["input"] for one in self.reports("other")],
                         ["b.Step", "d.step", "deep/a.STP"])

    def test_an_archive_is_a_folder_of_parts(self):
        self.angles(3, "sent")
        texts = [(self.dir / "sent" / f"angle-{i:03}.step").read_bytes() for i in range(3)]
        (self.dir / "in").mkdir()
        with zipfile.ZipFile(self.dir / "in" / "two.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("sub/left.step", texts[0])
            archive.writestr("cut short.step", texts[1][:500])
        (self.dir / "in" / "one.gz").write_bytes(gzip.compress(texts[2]))
        (self.dir / "in" / "notes.gz").write_bytes(gzip.compress(b"Please cut."))
        with zipfile.ZipFile(self.dir / "in" / "none.zip", "w") as archive:
            archive.writestr("offer.pdf", "x")
        self.batch("in", "-o", "out", "--jobs", "2")
        self.assertEqual([(one["input"], one["status"]) for one in self.reports()],
                         [("one.gz", "ok"), ("two.zip/cut short.step", "refused"), ("two.zip/sub/left.step", "ok")])
        self.assertTrue((self.dir / "out/parts/two.zip/sub/left.step/left.dxf").is_file())
        self.assertEqual({one["file"] for one in self.json("out/summary.json")["passed_over"]["files"]},
                         {"none.zip", "notes.gz"})
        self.batch("in/two.zip", "-o", "alone")
        self.assertEqual(len(self.reports("alone")), 2)
        for share in "12":
            self.batch("in", "-o", "shared", "--shard", f"{share}/2")
        self.batch("--merge", "shared", "-o", "shared")
        self.assert_same_result("out", "shared")

    def test_bodies_of_an_assembly_have_folders_of_their_own(self):
        file = step_files.StepFile()
        for i, leg in enumerate((40.0, 45.0, 50.0)):
            file.product(f"leg/{leg:.0f}",
                         file.prism(*step_files.angle_profile(leg, 2.0, 2.0), 30.0, at=(100.0 * i, 0.0, 0.0)))
        self.write("three.step", file.text())
        self.batch("three.step", "-o", "out")
        folders = [pathlib.Path(one["files"][0]).parent for one in self.reports()]
        self.assertEqual(len(set(folders)), 3)
        for folder, leg in zip(folders, (40.0, 45.0, 50.0)):
            self.assertEqual(folder.parent.name, "three.step")
            self.assertTrue((self.dir / "out" / "parts" / folder / "sketch.svg").is_file())

    def test_an_assembly_is_shared_among_the_workers(self):
        file = step_files.StepFile()
        for i in range(9):
            shell = file.prism(*step_files.angle_profile(40.0 + i, 2.0, 2.0), 30.0, at=(100.0 * i, 0.0, 0.0))
            file.product(f"leg {i}", shell)
        self.write("nine.step", file.text())
        self.write("broken.step", file.text()[:3000])
        for jobs in (1, 4, 7):
            self.batch("nine.step", "broken.step", "-o", f"out-{jobs}", "--jobs", jobs)
        self.assertEqual([one.get("body_number") for one in self.reports("out-4")][1:], list(range(1, 10)))
        self.assert_same_result("out-1", "out-4")
        self.assert_same_result("out-1", "out-7")

    def test_progress_as_json(self):
        self.angles(4)
        said = self.batch("in", "-o", "out", "--progress", "json").stderr.splitlines()
        last = json.loads(said[-1])
        self.assertEqual(len(said), 4)
        self.assertEqual((last["done"], last["all"], last["resumed"]), (4, 4, 0))
        said = self.batch("in", "-o", "out", "--progress", "json").stderr.splitlines()
        self.assertEqual(json.loads(said[-1])["resumed"], 4)


class SharedWork(BatchTest):
    def setUp(self):
        super().setUp()
        self.angles(20)
        for file in sorted(CORPUS.glob("*.step"))[:20]:
            shutil.copy(file, self.dir / "in")

    def test_any_number_of_workers_gives_the_same_bytes(self):
        self.batch("in", "-o", "one", "--jobs", "1")
        self.batch("in", "-o", "four", "--jobs", "4")
        self.assert_same_result("one", "four")

    def test_shards_merged_are_the_same_bytes(self):
        self.batch("in", "-o", "whole")
        for i in (1, 2, 3):
            self.batch("in", "-o", "shared", "--shard", f"{i}/3", "--jobs", "1")
        shards = [self.reports(f"shared/shard-{i}-of-3") for i in (1, 2, 3)]
        self.assertEqual(sum(map(len, shards)), len(self.reports("whole")))
        self.batch("--merge", "shared", "-o", "shared")
        self.assert_same_result("whole", "shared")
        self.batch("--merge", *(f"shared/shard-{i}-of-3" for i in (3, 1, 2)), "-o", "merged")
        self.assert_same_result("whole", "merged")
        self.batch("--merge", "shared", "-o", "shared")
        self.assert_same_result("whole", "shared")

    def test_more_shards_than_parts(self):
        for i in range(1, 61):
            self.batch("in", "-o", "many", "--shard", f"{i}/60", "-q", "--jobs", "1")
        self.batch("--merge", "many", "-o", "merged")
        self.batch("in", "-o", "whole")
        self.assert_same_result("whole", "merged")

    def test_shards_that_do_not_belong_together(self):
        self.batch("in", "-o", "a", "--shard", "1/2")
        self.assertIn("shard 2/2 is missing", self.sentence("--merge", "a", "-o", "m", status=3))
        self.batch("in", "-o", "a", "--shard", "2/2", "--k", "0.3")
        self.assertIn("belong to different batches", self.sentence("--merge", "a", "-o", "m", status=3))
        self.assertIn("holds neither results", self.sentence("--merge", "in", "-o", "m", status=3))
        self.assertFalse((self.dir / "m" / "parts.jsonl").exists())


class Resumed(BatchTest):
    def resumed(self, *arguments):
        said = self.batch("in", "-o", "out", "--progress", "json", *arguments).stderr
        return json.loads(said.splitlines()[-1])["resumed"]

    def test_only_what_changed_is_done_again(self):
        self.angles(6)
        self.assertEqual(self.resumed(), 0)
        self.assertEqual(self.resumed(), 6)
        self.angle("in/angle-002.step", leg=90.0)
        self.assertEqual(self.resumed("--jobs", "1"), 5)
        self.assertAlmostEqual(self.reports()[2]["flat"]["size"][0], flat_length(90.0), 6)
        self.assertEqual(self.resumed("--k", "0.3"), 0)

    def test_a_file_that_an_option_names_counts_by_its_content(self):
        self.angles(3)
        self.write("k.csv", "r/t,k\n1,0.4\n")
        self.assertEqual(self.resumed("--k-table", "k.csv"), 0)
        self.assertEqual(self.resumed("--k-table", "k.csv"), 3)
        self.write("k.csv", "r/t,k\n1,0.3\n")
        self.assertEqual(self.resumed("--k-table", "k.csv"), 0)
        self.assertAlmostEqual(self.reports()[0]["flat"]["size"][0], flat_length(40.0, k=0.3), 6)

    def test_a_part_that_is_refused_now_leaves_no_drawing_of_before(self):
        self.angles(2)
        self.resumed("--format", "dxf,svg")
        self.write("in/angle-001.step", step_files.block())
        self.assertEqual(self.resumed("--format", "dxf,svg"), 1)
        self.assertEqual(list((self.dir / "out" / "parts").rglob("*.dxf")),
                         [self.dir / "out" / "parts" / "angle-000.step" / "angle-000.dxf"])
        self.assertFalse((self.dir / "out" / "parts" / "angle-001.step").exists())

    def test_interrupted_and_resumed_gives_the_same_bytes(self):
        self.angles(150)
        self.batch("in", "-o", "whole")
        program = subprocess.Popen([CLI, "batch", "in", "-o", "out", "--jobs", "2"], cwd=self.dir,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        parts = self.dir / "out" / "parts"
        self.assertTrue(until(lambda: parts.is_dir() and len(list(parts.iterdir())) > 10))
        workers = children_of(program.pid)
        program.send_signal(signal.SIGINT)
        out, said = program.communicate(timeout=SECONDS)
        self.assertEqual((program.returncode, out), (1, ""))
        self.assertRegex(said, r"^planish: interrupted[^\n]*\n$")
        self.assertTrue(until(lambda: not any(map(is_alive, workers))))
        self.assertFalse((self.dir / "out" / "parts.jsonl").exists())
        self.assertGreater(self.resumed(), 5)
        self.assert_same_result("whole", "out")

    def test_killed_and_resumed_gives_the_same_bytes(self):
        self.angles(150)
        self.batch("in", "-o", "whole")
        program = subprocess.Popen([CLI, "batch", "in", "-o", "out", "--jobs", "2"], cwd=self.dir)
        parts = self.dir / "out" / "parts"
        self.assertTrue(until(lambda: parts.is_dir() and len(list(parts.iterdir())) > 10))
        program.kill()
        program.wait()
        with (self.dir / "out" / ".planish-batch" / "journal.jsonl").open("a") as journal:
            journal.write('{"name":"angle-149.step","key":"')  # cut off in a line
        self.assertGreater(self.resumed(), 5)
        self.assertEqual(self.resumed(), 150)
        self.assert_same_result("whole", "out")


class LostWorkers(BatchTest):
    def begun(self, *arguments):
        program = subprocess.Popen([CLI, "batch", "in", "-o", "out", *arguments], cwd=self.dir,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(program.kill)
        self.assertTrue(until(lambda: children_of(program.pid)))
        return program

    def ended(self, program):
        said = program.communicate(timeout=SECONDS)[1]
        self.assertEqual(program.returncode, 0, said)

    def test_a_worker_killed_by_hand_costs_nothing(self):
        self.angles(150)
        self.batch("in", "-o", "whole")
        program = self.begun("--jobs", "2")
        for _ in range(4):
            time.sleep(0.1)
            for worker in children_of(program.pid)[:1]:
                os.kill(worker, signal.SIGKILL)
        self.ended(program)
        lost = [one for one in self.reports() if one["status"] == "refused"]
        self.assertEqual(lost, [])
        self.assert_same_result("whole", "out")

    def test_a_part_whose_worker_crashes_is_refused_and_tried_again(self):
        self.angles(5)
        self.write("in/angle-000x.json", long_work())
        program = self.begun("--jobs", "1")
        done = self.dir / "out" / "parts" / "angle-000.step"
        # The long one is asked for after the first part in the order of the names.
        self.assertTrue(until(done.exists))
        long = self.dir / "out" / "parts" / "angle-001.step"
        while not long.exists() and program.poll() is None:
            time.sleep(0.3)
            for worker in children_of(program.pid):
                os.kill(worker, signal.SIGSEGV)
        self.ended(program)
        codes = {one["input"]: one["reason"]["code"] for one in self.reports() if one["reason"]}
        self.assertEqual(codes["angle-000x.json"], "worker_died")
        self.assertEqual(len(self.reports()), 6)
        said = self.batch("in", "-o", "out", "--progress", "json", "--time-limit", "1").stderr
        first = json.loads(said.splitlines()[-1])
        self.assertEqual(first["resumed"], 6 - len(codes))
        reports = {one["input"]: one for one in self.reports()}
        self.assertEqual(reports["angle-000x.json"]["reason"]["code"], "time_limit")
        self.assertEqual(sum(one["status"] == "refused" for one in reports.values()), 1)

    def test_what_hangs_costs_its_time_alone(self):
        self.angles(5)
        self.write("in/angle-002-long.json", long_work())
        self.batch("in", "-o", "out", "--time-limit", "1", "--jobs", "1")
        refused = [one for one in self.reports() if one["status"] == "refused"]
        self.assertEqual([(one["input"], one["reason"]["code"]) for one in refused],
                         [("angle-002-long.json", "time_limit")])
        said = self.batch("in", "-o", "out", "--time-limit", "1", "--progress", "json").stderr
        self.assertEqual(json.loads(said.splitlines()[-1])["resumed"], 6)
        said = self.batch("in", "-o", "out", "--time-limit", "1.5", "--progress", "json").stderr
        self.assertEqual(json.loads(said.splitlines()[-1])["resumed"], 5)

    def test_no_worker_outlives_the_batch(self):
        self.angles(1)
        self.write("in/long.json", long_work())
        program = self.begun("--jobs", "2")
        workers = children_of(program.pid)
        program.kill()
        program.wait()
        self.assertTrue(until(lambda: not any(map(is_alive, workers))))


class DamagedFiles(BatchTest):
    def test_each_is_a_part_with_its_reason(self):
        shutil.copytree(CORPUS, self.dir / "in")
        self.angles(3)
        self.batch("in", "-o", "out", "--time-limit", "20", seconds=400)
        reports = self.reports()
        steps = {file.name for file in CORPUS.glob("*.step")}
        self.assertLessEqual(steps, {one["input"] for one in reports})
        for report in reports:
            self.assertEqual(report["status"] == "refused", bool(report["reason"]), report["input"])
            self.assertNotIn("\n", (report["reason"] or {"message": ""})["message"])


class BadInput(BatchTest):
    def test_nothing_to_work_on(self):
        (self.dir / "empty").mkdir()
        self.write("empty/notes.txt", "none")
        self.assertIn("[no_input]", self.sentence("empty", "-o", "out", status=3))
        self.assertFalse((self.dir / "out").exists())

    def test_words_that_are_nothing(self):
        self.assertIn("no file or folder", self.sentence("absent", "-o", "out", status=3))
        self.assertIn("absent.txt", self.sentence("@absent.txt", "-o", "out", status=3))
        self.write("list.txt", "in/absent.step\n")
        said = self.sentence("@list.txt", "-o", "out", status=3)
        self.assertIn("in/absent.step", said)
        self.assertIn("list.txt", said)
        self.write("itself.txt", "@itself.txt\n")
        self.assertIn("names itself", self.sentence("@itself.txt", "-o", "out", status=3))
        self.assertEqual(self.names(), ["itself.txt", "list.txt"])

    def test_results_within_the_input(self):
        self.angles(2)
        for out in ("in", "in/out", "in/../in/x"):
            self.assertIn("in the input folder", self.sentence("in", "-o", out, status=2))
        self.assertEqual(len(self.names()), 2)

    def test_two_inputs_of_one_name(self):
        self.angles(1, "a")
        self.angles(1, "b")
        said = self.sentence("a", "b", "-o", "out", status=2)
        self.assertIn("two inputs are called angle-000.step", said)
        self.batch("a", "a/angle-000.step", "-o", "out")
        self.assertEqual(len(self.reports()), 1)

    def test_words_of_the_options(self):
        self.angles(1)
        for arguments in (["--shard", "0/3"], ["--shard", "4/3"], ["--shard", "three"],
                          ["--format", "dwg"], ["--jobs", "0"], ["--progress", "xml"]):
            self.sentence("in", "-o", "out", *arguments, status=2)
        self.assertEqual(len(self.names()), 1)

    def test_a_full_disk_ends_it_and_leaves_nothing_half_written(self):
        self.angles(60)

        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (120_000, 120_000))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

        done = self.batch("in", "-o", "out", status=3, preexec_fn=small, restore_signals=False)
        self.assertRegex(done.stderr, r"^planish: [Cc]annot write [^\n]*\n$")
        self.assertFalse((self.dir / "out" / "parts.jsonl").exists())
        self.assertEqual([name for name in self.names() if name.endswith(".part")], [])
        self.batch("in", "-o", "out")
        self.batch("in", "-o", "whole")
        self.assert_same_result("whole", "out")

    def test_two_batches_in_one_folder(self):
        self.angles(1)
        self.write("in/long.json", long_work())
        first = subprocess.Popen([CLI, "batch", "in", "-o", "out", "-q"], cwd=self.dir,
                                 stderr=subprocess.DEVNULL)
        self.addCleanup(first.wait)
        self.addCleanup(first.kill)
        self.assertTrue(until(lambda: children_of(first.pid)))
        self.assertIn("another batch", self.sentence("in", "-o", "out", status=3))


if __name__ == "__main__":
    main()
