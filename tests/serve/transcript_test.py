#!/usr/bin/python3
"""The conversations in docs/serve.md, held again: what is sent is sent, what comes is compared."""

import json
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_serve import SOURCE, ServeTest  # noqa: E402
from planish_cli import main  # noqa: E402

PAGE = (SOURCE / "docs" / "serve.md").read_text()
TRANSCRIPTS = [re.findall(r"^([→←]) (.*)$", block, re.M) for block in re.findall(r"```console\n(.*?)```", PAGE, re.S)]


class Transcripts(ServeTest):
    def matches(self, shown, said):
        """Whether a message is what the page shows, where "…" stands for anything."""
        pattern = ".*".join(re.escape(part) for part in shown.split("…"))
        return re.fullmatch(pattern, said) is not None

    def hold(self, transcript):
        server = self.server("--jobs", 1)
        shutil.copytree(SOURCE / "examples", self.dir / "examples")
        for way, shown in transcript:
            if way == "→":
                json.loads(shown)
                server.send_bytes(shown.encode() + b"\n")
                continue
            while True:
                said = json.dumps(server.hear(), separators=(",", ":"), ensure_ascii=False)
                if self.matches(shown, said):
                    break
                # Of the progress a part is shown.
                self.assertIn("progress", json.loads(said).get("method", ""), f"{said[:2000]}\nfor\n{shown}")
        status, rest, errors = server.end()
        self.assertEqual((status, [one for one in rest if "method" not in one], errors), (0, [], ""))
        shutil.rmtree(self.dir / "examples")

    def test_they_are_as_they_are_shown(self):
        self.assertEqual(len(TRANSCRIPTS), 2)
        for transcript in TRANSCRIPTS:
            self.assertGreater(len(transcript), 4)
            self.hold(transcript)


if __name__ == "__main__":
    main()
