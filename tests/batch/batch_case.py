"""Batches as a user runs them."""

import json
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
sys.path.insert(0, str(pathlib.Path(__file__).parent / "../support"))
import planish_cli  # noqa: E402
import step_files  # noqa: E402
from planish_cli import CLI, SECONDS, SOURCE, main  # noqa: E402,F401

PARTS = pathlib.Path(os.environ.get("PLANISH_PARTS", SOURCE / "../shared/parts"))


class BatchTest(planish_cli.CliTest):
    def angles(self, count, folder="in"):
        """Parts in closed form, each of its own size."""
        (self.dir / folder).mkdir(exist_ok=True)
        for i in range(count):
            self.angle(f"{folder}/angle-{i:03}.step", leg=40.0 + 0.25 * i)

    def batch(self, *arguments, status=0, seconds=SECONDS, **process):
        done = subprocess.run([CLI, "batch", *map(str, arguments)], cwd=self.dir,
                              capture_output=True, text=True, timeout=seconds, check=False, **process)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def sentence(self, *arguments, status):
        """The one sentence of a run that failed."""
        done = self.batch(*arguments, status=status)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"^planish: [^\n]+\n$")
        return done.stderr

    def reports(self, out="out"):
        lines = (self.dir / out / "parts.jsonl").read_text().splitlines()
        return [json.loads(line) for line in lines]

    def result(self, out="out"):
        """All that a batch writes for people: names and bytes."""
        root = self.dir / out
        files = (path for path in root.rglob("*") if path.is_file())
        return {name: path.read_bytes() for path in files
                if not (name := str(path.relative_to(root))).startswith((".", "shard-"))}

    def assert_same_result(self, one, other):
        first, second = self.result(one), self.result(other)
        self.assertEqual(sorted(set(first) ^ set(second)), [])
        different = [name for name in first if first[name] != second[name]]
        self.assertEqual(different, [])
