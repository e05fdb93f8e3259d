#!/usr/bin/env python3
"""Brings the real parts that the tests unfold: STEP files from public repositories, each at a fixed
commit and checked by its SHA-256. tests/corpus/parts.jsonl lists them with their licences, which are
those of their authors; they are for testing and no part of Planish. Needs nothing but Python.

  tools/fetch_parts.py                 into PLANISH_PARTS, or ../shared/parts beside the repository
  tools/fetch_parts.py --to FOLDER     somewhere else; tests then want PLANISH_PARTS=FOLDER
  tools/fetch_parts.py --check         without the network: is everything there, and the right thing?
  tools/fetch_parts.py --only ID       one part (may be given several times)
  tools/fetch_parts.py --list          what is on the list, and from where

What is there already is not brought again, so that an interrupted run goes on where it stopped.
Some parts are one solid of a larger file: this file is kept in the folder `sources`, and the solid
taken out of it entity by entity. The list has the SHA-256 of the larger file, and of the solid what
tells it from the others: faces, vertices and extent. docs/checking.md says more.

Exit status: 0 all is there, 1 something is not, 2 wrong usage."""

import argparse
import hashlib
import http.client
import io
import json
import os
import pathlib
import sys
import tempfile
import time
import urllib.error
import urllib.parse
import urllib.request
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import step_solids  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parents[1]
LIST = SOURCE / "tests" / "corpus" / "parts.jsonl"
RAW = "https://raw.githubusercontent.com"
LARGE = "https://media.githubusercontent.com/media"  # files that git keeps elsewhere (LFS)
SECONDS, TRIES = 60, 3


class Failed(Exception):
    """One sentence."""


def read_list(path):
    with open(path, encoding="utf-8") as stream:
        return [json.loads(line) for line in stream if line.strip()]


def url_of(part, server=RAW):
    quoted = urllib.parse.quote(f"{part['repository']}/{part['commit']}/{part['path']}")
    return f"{server}/{quoted}"


# ---- bytes

def download(url):
    """The whole file; servers that are busy are asked again."""
    for attempt in range(1, TRIES + 1):
        try:
            with urllib.request.urlopen(url, timeout=SECONDS) as reply:
                data = reply.read()
                length = reply.headers.get("Content-Length")
            if length is not None and len(data) != int(length):
                raise http.client.IncompleteRead(data)
            return data
        except urllib.error.HTTPError as error:
            if error.code < 500 and error.code != 429 or attempt == TRIES:
                raise Failed(f"the server answers {error.code} ({error.reason}) for {url}") from None
        except http.client.IncompleteRead as error:
            if attempt == TRIES:
                raise Failed(f"only {len(error.partial)} bytes of {url} arrived") from None
        except (OSError, http.client.HTTPException) as error:
            if attempt == TRIES:
                reason = getattr(error, "reason", None) or error
                raise Failed(f"{url} cannot be reached: {reason}") from None
        time.sleep(attempt)
    raise AssertionError("unreachable")


def fetch_file(part, server):
    """The file in the repository, unpacked where it lies in an archive."""
    url = url_of(part, server)
    data = download(url)
    if data.startswith(b"version https://git-lfs."):
        data = download(url_of(part, LARGE if server == RAW else server + "/media"))
    if "member" not in part:
        return data, url
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return archive.read(part["member"]), f"{url} ({part['member']})"
    except (zipfile.BadZipFile, KeyError) as error:
        raise Failed(f"{url} is not the archive that was expected: {error}") from None


def checked(data, expected, url):
    found = hashlib.sha256(data).hexdigest()
    if found != expected:
        raise Failed(f"{url} is another file than listed: its SHA-256 is {found[:12]}…, listed is "
                     f"{expected[:12]}…")
    return data


def write_whole(path, data):
    """Under another name first, so that a part is there whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=f".{path.name[:40]}.", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        pathlib.Path(name).unlink(missing_ok=True)
        raise


# ---- parts

def state(part, folder):
    """Empty if the part is there, else one sentence that says what is wrong."""
    path = folder / f"{part['id']}.step"
    if not path.is_file():
        return "it is not there"
    data = path.read_bytes()
    if hashlib.sha256(data).hexdigest() == part["sha256"]:
        return ""
    if "solid" not in part:
        return "the file is another than listed (SHA-256)"
    try:
        file = step_solids.StepSolids(data)
        if len(file.solids) == 1 and step_solids.matches(file.facts(file.solids[0]), part["solid"]):
            return ""
    except (step_solids.NotStep, ValueError, LookupError):
        pass
    return "the file does not hold the solid that is listed"


def take_solid(part, data, url):
    try:
        file = step_solids.StepSolids(data)
        found = step_solids.matching(file, part["solid"])
    except (step_solids.NotStep, ValueError, LookupError) as error:
        raise Failed(f"{url} cannot be taken apart: {error}") from None
    if not found:
        raise Failed(f"none of the {len(file.solids)} solids in {url} is the one listed; it is the one "
                     f"with {part['solid']['faces']} faces, take it out with a CAD system")
    return file.text_of(found[0], part["id"])


def bring(part, folder, server):
    if "solid" not in part:
        data, url = fetch_file(part, server)
        write_whole(folder / f"{part['id']}.step", checked(data, part["sha256"], url))
        return
    source = folder / "sources" / f"{part['source_sha256']}.step"
    if source.is_file() and hashlib.sha256(source.read_bytes()).hexdigest() == part["source_sha256"]:
        data, url = source.read_bytes(), str(source)
    else:
        data, url = fetch_file(part, server)
        write_whole(source, checked(data, part["source_sha256"], url))
    write_whole(folder / f"{part['id']}.step", take_solid(part, data, url))


def bring_all(parts, folder, server):
    failed = there = 0
    for number, part in enumerate(parts, 1):
        if not state(part, folder):
            there += 1
            continue
        print(f"[{number}/{len(parts)}] {part['id']}", file=sys.stderr, flush=True)
        try:
            bring(part, folder, server)
        except Failed as failure:
            failed += 1
            print(f"{part['id']}: {failure}.", flush=True)
    print(f"{len(parts) - failed} of {len(parts)} parts are in {folder}, {there} of them were there "
          f"before; {failed} failed.")
    return 1 if failed else 0


def check_all(parts, folder):
    wrong = 0
    for part in parts:
        sentence = state(part, folder)
        if sentence:
            wrong += 1
            print(f"{part['id']}: {sentence}.")
    print(f"{len(parts) - wrong} of {len(parts)} parts in {folder} are those listed.")
    return 1 if wrong else 0


def list_all(parts):
    for part in parts:
        member = f"  ({part['member']})" if "member" in part else ""
        solid = f"  (solid {part['solid']['index']})" if "solid" in part else ""
        print(f"{part['id']}  {part['class']}  {part['licence']}  {url_of(part)}{member}{solid}")
    return 0


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    default = os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts"
    parser.add_argument("--to", type=pathlib.Path, default=default, metavar="FOLDER",
                        help="default: PLANISH_PARTS, or ../shared/parts beside the repository")
    parser.add_argument("--only", action="append", metavar="ID", help="this part alone")
    parser.add_argument("--mirror", default=RAW, metavar="URL",
                        help=f"a server with the same paths as {RAW}, which is the default")
    parser.add_argument("--parts", type=pathlib.Path, default=LIST, metavar="FILE",
                        help="another list")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="check what is there, bring nothing")
    what.add_argument("--list", action="store_true", help="print the list, bring nothing")
    options = parser.parse_args()
    parts = read_list(options.parts)
    if options.only:
        unknown = set(options.only) - {part["id"] for part in parts}
        if unknown:
            parser.error(f"not on the list: {', '.join(sorted(unknown))}")
        parts = [part for part in parts if part["id"] in options.only]
    return options, parts


def main():
    options, parts = arguments()
    folder = pathlib.Path(options.to)
    try:
        if options.list:
            return list_all(parts)
        if options.check:
            return check_all(parts, folder)
        return bring_all(parts, folder, options.mirror.rstrip("/"))
    except BrokenPipeError:  # whoever read the output has enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        print(f"fetch_parts: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("fetch_parts: stopped; run it again to go on", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
