#!/usr/bin/python3
"""Workers that end, are ended, or work beside each other; and what is left when the studio ends: nothing."""

import os
import pathlib
import signal
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
from planish_studio import EXAMPLES, Studio, StudioTest, main, until  # noqa: E402
import step_files  # noqa: E402


def long_work(spec):
    """A slit spec whose result takes seconds: many strips, finely divided."""
    strips = 60
    width = spec["sheet"]["strip_width"] * strips
    return dict(spec, sheet=dict(spec["sheet"], strips=strips), ridges=20, subdivisions=4,
                leg_curve={"bezier": [[360, 0], [360, width]]}, seat_curve={"bezier": [[330, 0], [300, width / 3], [310, 2 * width / 3], [640, width]]})


def large_part():
    """A STEP file that takes a second or more to read: many angles, each a little longer than the one before."""
    file = step_files.StepFile()
    for i in range(200):
        file.product(f"angle {i}", file.prism(*step_files.angle_profile(50.0, 2.0, 2.0), 60.0 + 0.1 * i, at=(100.0 * i, 0.0, 0.0)))
    return file.text()


class InBackground:
    """A request on a thread of its own."""

    def __init__(self, work):
        self.answer = None
        self.thread = threading.Thread(target=self.run, args=(work,), daemon=True)
        self.thread.start()

    def run(self, work):
        self.answer = work()

    def wait(self):
        self.thread.join(timeout=100)
        assert not self.thread.is_alive(), "no answer"
        return self.answer

    def is_over(self):
        return not self.thread.is_alive()


class Workers(StudioTest):
    def begin_long(self):
        document, spec = self.studio.open_example("slit/chair.json")
        long = InBackground(lambda: self.studio.post(document, "result", long_work(spec)))
        self.assertTrue(until(lambda: self.progress(document) is not None))
        self.assertFalse(long.is_over())
        return document, spec, long

    def progress(self, document):
        return self.studio.get(f"/api/documents/{document}/progress").json()

    @staticmethod
    def memory_of(process):
        """What it has written to and shares with nobody, in kB."""
        text = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text()
        return int(next(line for line in text.splitlines() if line.startswith("Private_Dirty")).split()[1])

    def test_what_was_read_of_a_large_file_is_freed_at_rest(self):
        opened = self.studio.open("large.step", large_part()).json()
        (worker,) = self.studio.workers()
        if "unlimited" in next(line for line in pathlib.Path(f"/proc/{worker}/limits").read_text().splitlines() if "address space" in line):
            self.skipTest("under sanitizers nothing is given back")
        before = self.memory_of(worker)
        shape = self.studio.shape(opened["id"], "result")
        self.assertTrue(until(lambda: self.memory_of(worker) < before / 2), (before, self.memory_of(worker)))
        for body in (1, 2, 200):
            self.assertTrue(self.studio.post(opened["id"], "result", body=body).is_good)
        self.assertEqual(self.studio.shape(opened["id"], "result", body=1).report["flat"], shape.report["flat"])
        self.assertEqual(self.studio.workers(), [worker])

    def test_a_worker_killed_in_the_middle_is_replaced(self):
        document, spec, long = self.begin_long()
        (worker,) = self.studio.workers()
        os.kill(worker, signal.SIGKILL)
        self.assert_error(long.wait(), 409, "worker_ended")
        self.assertEqual(self.studio.shape(document, "result", spec).report["status"], "ok")
        self.assertNotIn(worker, self.studio.workers())

    def test_a_worker_killed_at_rest_is_replaced(self):
        document, spec = self.studio.open_example("slit/chair.json")
        (worker,) = self.studio.workers()
        for how in (signal.SIGKILL, signal.SIGSEGV):
            os.kill(worker, how)
            self.assertTrue(until(lambda gone=worker: gone not in self.studio.workers()))
            self.assertNotEqual(self.studio.shape(document, "draft", spec).report["status"], "refused")
            (worker,) = self.studio.workers()

    def test_a_worker_outlives_the_connection_that_started_it(self):
        document, spec = self.studio.open_example("connect/a_folded.json")
        (first,) = self.studio.workers()
        os.kill(first, signal.SIGKILL)
        self.assertTrue(until(lambda: first not in self.studio.workers()))
        self.assertNotEqual(self.studio.shape(document, "draft", spec).report["status"], "refused")
        (worker,) = self.studio.workers()  # each request has a connection of its own, which is closed now
        time.sleep(0.5)
        self.assertEqual(self.studio.workers(), [worker])

    def test_what_waits_for_a_document_that_is_closed_ends_with_it(self):
        document, spec, long = self.begin_long()
        others = [InBackground(lambda: self.studio.post(document, "result", long_work(spec))) for _ in range(2)]
        time.sleep(0.5)
        self.assertEqual(self.studio.ask("DELETE", f"/api/documents/{document}").status, 204)
        begun = time.monotonic()
        for request in (long, *others):
            self.assert_error(request.wait(), 409, "cancelled")
        self.assertLess(time.monotonic() - begun, 5.0)

    def test_what_is_computed_can_be_given_up(self):
        document, spec, long = self.begin_long()
        begun = time.monotonic()
        self.assertEqual(self.studio.ask("POST", f"/api/documents/{document}/cancel").status, 204)
        self.assert_error(long.wait(), 409, "cancelled")
        self.assertLess(time.monotonic() - begun, 2.0)
        self.assertIsNone(self.progress(document))
        self.assertTrue(self.studio.post(document, "draft", spec).is_good)

    def test_opening_shows_how_far_it_is_and_can_be_given_up(self):
        document = self.studio.take("comb.step", large_part()).json()["id"]
        opening = InBackground(lambda: self.studio.open_taken(document))
        self.assertTrue(until(lambda: (self.progress(document) or {}).get("stage")))
        begun = time.monotonic()
        self.assertEqual(self.studio.ask("POST", f"/api/documents/{document}/cancel").status, 204)
        self.assert_error(opening.wait(), 409, "cancelled")
        self.assertLess(time.monotonic() - begun, 2.0)
        self.assertEqual(self.studio.get("/api/documents").json(), [])
        (folder,) = pathlib.Path(self.studio.folder).iterdir()
        self.assertTrue(folder.name.startswith("planish-studio-"))
        again = InBackground(lambda: self.studio.open_taken(document))
        stages = set()
        while not again.is_over():
            stages.add((self.progress(document) or {}).get("stage"))
            time.sleep(0.01)
        self.assertGreaterEqual(stages, {"reading", "translating"})
        self.assertEqual(len(again.wait().json()["info"]["bodies"]), 200)

    def test_nothing_to_give_up_is_no_error(self):
        document, spec = self.studio.open_example("slit/chair.json")
        self.assertIsNone(self.progress(document))
        self.assertEqual(self.studio.ask("POST", f"/api/documents/{document}/cancel").status, 204)
        self.assertTrue(self.studio.post(document, "draft", spec).is_good)

    def test_progress_has_a_stage_and_a_share(self):
        document, _, long = self.begin_long()
        self.assertTrue(until(lambda: (self.progress(document) or {}).get("stage")))
        told = self.progress(document)
        self.assertTrue(0.0 <= told["share"] <= 1.0, told)
        self.studio.ask("DELETE", f"/api/documents/{document}")
        self.assert_error(long.wait(), 409)

    def test_two_documents_compute_at_once(self):
        document, _, long = self.begin_long()
        other, spec = self.studio.open_example("transition/a_square_to_round.json")
        self.assertEqual(self.studio.shape(other, "result", spec).report["status"], "ok")
        self.assertFalse(long.is_over())
        self.studio.ask("POST", f"/api/documents/{document}/cancel")
        long.wait()

    def test_the_third_waits_for_one_of_two(self):
        first, second = self.begin_long(), None
        document, spec = self.studio.open_example("slit/chair.json")
        second = InBackground(lambda: self.studio.post(document, "result", long_work(spec)))
        time.sleep(0.3)
        waiting = InBackground(lambda: self.studio.open("a.json", (EXAMPLES / "transition/a_square_to_round.json").read_bytes()))
        time.sleep(0.5)
        self.assertFalse(waiting.is_over() and not second.is_over() and not first[2].is_over())
        for given_up in (first[0], document):
            self.studio.ask("POST", f"/api/documents/{given_up}/cancel")
        self.assertTrue(waiting.wait().is_good)

    def test_many_drafts_at_once_are_answered_one_after_the_other(self):
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        drafts = [InBackground(lambda: self.studio.post(document, "draft", spec).is_good) for _ in range(12)]
        self.assertEqual([draft.wait() for draft in drafts], [True] * 12)
        self.assertEqual(len(self.studio.workers()), 1)

    def test_workers_are_limited(self):
        self.studio.open_example("bracket.step")
        (worker,) = self.studio.workers()
        limits = pathlib.Path(f"/proc/{worker}/limits").read_text()
        self.assertRegex(limits, r"Max core file size +0 +0 ")
        self.assertRegex(limits, r"Max address space +(4294967296 +4294967296|unlimited)")
        self.assertEqual(pathlib.Path(f"/proc/{worker}/cwd").resolve().parents[1].parent, pathlib.Path(self.studio.folder).resolve())
        descriptors = [os.readlink(f"/proc/{worker}/fd/{fd}") for fd in os.listdir(f"/proc/{worker}/fd")]
        self.assertEqual(len([d for d in descriptors if d.startswith("socket:")]), 1, descriptors)

    def test_too_much_memory_is_an_answer(self):
        document, spec = self.studio.open_example("slit/chair.json")
        limits = pathlib.Path(f"/proc/{self.studio.workers()[0]}/limits").read_text()
        if "4294967296" not in limits:
            self.skipTest("built with sanitizers, whose workers have no limit of memory")
        huge = dict(spec, sheet=dict(spec["sheet"], strips=10000, strip_width=1), ridges=100000, leg_curve={"bezier": [[360, 0], [360, 10000]]},
                    seat_curve={"bezier": [[330, 0], [310, 10000]]})
        answer = self.studio.post(document, "draft", huge)
        self.assertTrue(answer.is_problem or answer.status == 409, answer.body[:400])
        self.assertTrue(self.studio.post(document, "draft", spec).is_good)

    def test_a_closed_document_leaves_no_worker_and_no_file(self):
        document, _ = self.studio.open_example("slit/scanned_chair.json")
        (folder,) = pathlib.Path(self.studio.folder).glob("planish-studio-*")
        self.assertEqual(folder.stat().st_mode & 0o777, 0o700)
        self.assertTrue((folder / document).exists())
        self.studio.ask("DELETE", f"/api/documents/{document}")
        self.assertTrue(until(lambda: not self.studio.workers()))
        self.assertEqual([entry.name for entry in folder.iterdir()], ["lock"])


class TimeLimit(StudioTest):
    arguments = ("--time-limit", 3)  # a machine that has much else to do takes a second for a draft

    def test_what_takes_longer_is_given_up_and_the_document_goes_on(self):
        document, spec = self.studio.open_example("transition/a_square_to_round.json")
        slit, chair = self.studio.open_example("slit/chair.json")
        begun = time.monotonic()
        error = self.assert_error(self.studio.post(slit, "result", dict(long_work(chair), subdivisions=6)), 409, "worker_timeout")
        self.assertIn("longer than 3 s", error["message"])
        self.assertLess(time.monotonic() - begun, 10.0)
        self.studio.shape(slit, "draft", chair)
        self.studio.shape(document, "draft", spec)


class Ends(StudioTest):
    @classmethod
    def setUpClass(cls):
        pass

    def tearDown(self):
        pass

    def check_end(self, how, work):
        with tempfile.TemporaryDirectory(prefix="planish-test-") as folder:
            studio = Studio(folder=folder)
            document, spec = studio.open_example("slit/chair.json")
            workers = studio.workers()
            self.assertEqual(len(workers), 1)
            if work:
                asked = InBackground(lambda: self.ended(studio, document, spec))
                self.assertTrue(until(lambda: studio.get(f"/api/documents/{document}/progress").json() is not None))
            begun = time.monotonic()
            status = studio.stop(how)
            self.assertLess(time.monotonic() - begun, 5.0)
            self.assertTrue(until(lambda: not any(pathlib.Path(f"/proc/{w}").exists() for w in workers)))
            if work:
                asked.wait()
            if how != signal.SIGKILL:
                self.assertEqual(status, 0)
                self.assertEqual(os.listdir(folder), [])

    @staticmethod
    def ended(studio, document, spec):
        try:
            studio.post(document, "result", long_work(spec))
        except OSError:
            pass

    def test_ctrl_c_leaves_no_process_and_no_file(self):
        for work in (False, True):
            self.check_end(signal.SIGINT, work)

    def test_so_does_the_end_of_the_session(self):
        for how in (signal.SIGTERM, signal.SIGHUP):
            self.check_end(how, False)

    def test_a_killed_studio_leaves_no_process(self):
        for work in (False, True):
            self.check_end(signal.SIGKILL, work)

    def test_the_next_studio_removes_what_a_killed_one_left(self):
        with tempfile.TemporaryDirectory(prefix="planish-test-") as folder:
            place = pathlib.Path(folder)
            killed = Studio(folder=folder)
            killed.open_example("slit/chair.json")
            (left,) = place.iterdir()
            killed.stop(signal.SIGKILL)
            with Studio(folder=folder) as living:
                self.assertFalse(left.exists())
                (used,) = place.iterdir()
                (place / "planish-studio-mine12").mkdir()
                (place / "elsewhere").mkdir()
                (place / "elsewhere/lock").touch()
                (place / "planish-studio-link12").symlink_to(place / "elsewhere")
                others = place / "planish-studio-other1"
                others.mkdir()
                (others / "lock").touch()
                if os.geteuid() == 0:
                    os.chown(others / "lock", 65534, 65534)
                Studio(folder=folder).stop()
                self.assertTrue((place / "elsewhere/lock").exists() and (place / "planish-studio-link12").is_symlink())
                self.assertTrue((place / "planish-studio-mine12").exists())
                self.assertEqual(others.exists(), os.geteuid() == 0)
                self.assertTrue(used.exists())
                document, spec = living.open_example("transition/a_square_to_round.json")
                self.assertTrue(living.post(document, "draft", spec).is_good)

    def test_two_studios_know_nothing_of_each_other(self):
        with Studio() as one, Studio() as other:
            document, spec = one.open_example("transition/a_square_to_round.json")
            self.assertEqual(other.get("/api/documents").json(), [])
            self.assertEqual(other.post(document, "draft", spec).status, 404)


if __name__ == "__main__":
    main()
