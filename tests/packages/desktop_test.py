#!/usr/bin/python3
"""What a desktop is told of Planish: the entry of the studio, its icon, the types of its files; and the studio as such an
entry starts it, without a terminal."""

import http.client
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree

CLI = os.environ.get("PLANISH_CLI", "planish")
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
ICONS = SOURCE / "packaging" / "desktop"
DESKTOP = pathlib.Path(os.environ["PLANISH_PYTHON_FOLDER"]).parent / "desktop"
EXAMPLES = SOURCE / "examples"
SECONDS = 60
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False, **more)


class Test(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-desktop-")
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)


class Files(Test):
    def entry(self):
        lines = (DESKTOP / "planish-studio.desktop").read_text(encoding="utf-8").splitlines()
        return dict(line.split("=", 1) for line in lines if "=" in line)

    def types(self):
        root = ElementTree.parse(DESKTOP / "planish.xml").getroot()
        return [one.get("type") for one in root.iter(f"{MIME}mime-type")]

    def test_the_validators_have_nothing_to_say(self):
        done = run("desktop-file-validate", DESKTOP / "planish-studio.desktop")
        self.assertEqual((done.returncode, done.stdout + done.stderr), (0, ""))
        done = run("appstreamcli", "validate", "--no-net", DESKTOP / "org.planish.studio.metainfo.xml")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_the_entry_the_types_and_the_metainfo_name_the_same(self):
        entry, metainfo = self.entry(), ElementTree.parse(DESKTOP / "org.planish.studio.metainfo.xml").getroot()
        self.assertEqual([name for name in entry["MimeType"].split(";") if name], self.types())
        self.assertEqual([one.text for one in metainfo.iter("mediatype")], self.types())
        self.assertEqual(metainfo.find("launchable").text, "planish-studio.desktop")
        self.assertTrue((ICONS / f"{entry['Icon']}.svg").is_file())
        self.assertEqual(metainfo.find("project_license").text, "GPL-3.0-or-later")

    def test_the_command_of_the_entry_is_one_that_the_program_takes(self):
        words = self.entry()["Exec"].split()
        self.assertEqual((words[0], words[-1]), ("planish", "%f"))
        done = run(CLI, *words[1:-1], "--help")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_files_are_told_by_name_or_content(self):
        data = self.dir / "data"
        (data / "mime" / "packages").mkdir(parents=True)
        shutil.copy("/usr/share/mime/packages/freedesktop.org.xml", data / "mime" / "packages")
        shutil.copy(DESKTOP / "planish.xml", data / "mime" / "packages")
        done = run("update-mime-database", data / "mime")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("rror", done.stderr)
        environment = dict(os.environ, XDG_DATA_DIRS=str(data), XDG_DATA_HOME=str(self.dir / "home"))
        wanted = {"application/vnd.planish.plates+json": EXAMPLES / "connect",
                  "application/vnd.planish.transition+json": EXAMPLES / "transition",
                  "application/vnd.planish.slits+json": EXAMPLES / "slit"}
        (self.dir / "PART.STP").write_bytes((EXAMPLES / "bracket.step").read_bytes())
        (self.dir / "other.json").write_text('{"format": "other"}')
        cases = [(path, name) for name, folder in wanted.items() for path in sorted(folder.glob("*.json"))]
        self.assertGreater(len(cases), 15)
        cases += [(EXAMPLES / "bracket.step", "model/step"), (self.dir / "PART.STP", "model/step"),
                  (self.dir / "other.json", "application/json")]
        for path, name in cases:
            said = run("gio", "info", "--attributes=standard::content-type", path, env=environment).stdout
            self.assertEqual(re.search(r"standard::content-type: (\S+)", said)[1], name, path)

    def test_the_icon_can_be_told_at_16_pixels_and_is_sharp(self):
        """At 16 pixels, on whose grid it is drawn, all but its round corners and slanted edges has a colour of the drawing."""
        icon = ICONS / "planish-studio.svg"
        colours = {tuple(bytes.fromhex(text)) for text in re.findall(r'fill="#([0-9a-f]{6})"', icon.read_text())}
        self.assertGreaterEqual(len(colours), 4)
        for size in (16, 256):
            done = subprocess.run(["rsvg-convert", "-w", str(size), "-h", str(size), icon], capture_output=True, check=True)
            pixels = rgb_of_png(done.stdout, size)
            plain = sum(pixel in colours for pixel in pixels)
            self.assertGreater(plain / size ** 2, 0.9, size)
            self.assertEqual(colours - set(pixels), set(), size)


def rgb_of_png(png, size):
    """The pixels of an 8-bit RGBA image without interlacing."""
    import struct
    import zlib
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II5B", png[16:29]) == (size, size, 8, 6, 0, 0, 0)
    data, at = b"", 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        data += png[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    raw, stride, before, pixels = zlib.decompress(data), 4 * size, bytes(4 * size), []
    for row in range(size):
        kind, line = raw[row * (stride + 1)], bytearray(raw[row * (stride + 1) + 1:(row + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (line[i - 4] if i >= 4 else 0), before[i], (before[i - 4] if i >= 4 else 0)
            guess = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(guess - value))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        pixels += [tuple(line[i:i + 3]) for i in range(0, stride, 4)]
        before = line
    return pixels


class WithoutTerminal(Test):
    """The studio is started as by a desktop: no terminal, and an xdg-open that keeps what it is given."""

    def setUp(self):
        super().setUp()
        opener = self.dir / "xdg-open"
        opener.write_text(f"#!/bin/sh\ncp \"$1\" {self.dir}/opening && mv {self.dir}/opening {self.dir}/opened.html\n")
        opener.chmod(0o755)
        self.environment = dict(os.environ, PATH=f"{self.dir}:{os.environ['PATH']}", DISPLAY=":99", TMPDIR=str(self.dir))

    def start(self, *arguments):
        process = subprocess.Popen([CLI, "studio", *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, env=self.environment)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def opened(self):
        until = time.monotonic() + SECONDS
        while not (self.dir / "opened.html").exists():
            self.assertLess(time.monotonic(), until, "no browser was opened")
            time.sleep(0.05)
        return (self.dir / "opened.html").read_text()

    def connection(self, page):
        port, token = re.search(r"url=http://127\.0\.0\.1:(\d+)/#([0-9a-f]{32})", page).groups()
        return http.client.HTTPConnection("127.0.0.1", int(port), timeout=SECONDS), {"X-Planish-Token": token}

    def test_the_browser_is_opened_with_the_file(self):
        self.start("--end-after", "600", str(EXAMPLES / "bracket.step"))
        connection, headers = self.connection(self.opened())
        connection.request("GET", "/api/documents", headers=headers)
        self.assertIn(b'"bracket.step"', connection.getresponse().read())

    def test_it_ends_some_time_after_the_page_is_closed_and_not_before(self):
        process = self.start("--end-after", "3")
        connection, headers = self.connection(self.opened())
        connection.request("GET", "/api/presence", headers=headers)
        answer = connection.getresponse()
        self.assertEqual(answer.status, 200)
        for _ in range(6):  # a beat a second, for longer than it would stay without a page
            self.assertEqual(answer.read(1), b".")
        self.assertIsNone(process.poll())
        connection.close()
        answer.close()
        self.assertEqual(process.wait(timeout=SECONDS), 0)
        self.assertEqual(sorted(path.name for path in self.dir.iterdir()), ["opened.html", "xdg-open"])

    def test_it_ends_if_no_page_is_ever_opened(self):
        self.assertEqual(self.start("--end-after", "1").wait(timeout=SECONDS), 0)

    def test_only_those_with_the_token_are_present(self):
        self.start("--end-after", "600")
        connection, _ = self.connection(self.opened())
        connection.request("GET", "/api/presence")
        self.assertEqual(connection.getresponse().status, 403)

    def test_a_studio_that_stays_needs_nobody(self):
        self.start()
        connection, headers = self.connection(self.opened())
        connection.request("GET", "/api/presence", headers=headers)
        self.assertEqual(connection.getresponse().status, 204)

    def test_a_file_that_cannot_be_opened_is_said_in_the_browser(self):
        (self.dir / "bad<1>.step").write_text("no STEP file")
        process = self.start("--end-after", "600", str(self.dir / "bad<1>.step"))
        page = self.opened()
        _, sentence = process.communicate(timeout=SECONDS)
        self.assertEqual(process.returncode, 3)
        message = re.fullmatch(r"planish: (.*) \[\w+\].*\n", sentence)[1]
        self.assertIn(message.replace("<", "&lt;").replace(">", "&gt;"), page)


if __name__ == "__main__":
    missing = [name for name in ("desktop-file-validate", "appstreamcli", "update-mime-database", "gio", "rsvg-convert")
               if not shutil.which(name)]
    if missing:
        sys.exit(f"missing: {', '.join(missing)}: tools/install-packages.sh test")
    unittest.main(verbosity=2)
