#!/usr/bin/python3
"""How a batch grows: python3 bench/batch.py PLANISH FOLDER WHAT…

  throughput   1,000 small STEP parts: parts a second of a batch against one process for each file,
               one after the other and as many at a time as the batch has workers
  many         20,000 parts by `connect` with random numbers: time, rate, memory of the workers
  memory       one worker over 5,000 parts: its resident memory after each thousand
  merge        the merge of 1,000 shards with a million reports, made of those of `many`
  corpus       ../shared/parts: processor time and memory for a part of that mix

Parts of `many`: a base plate of 80 to 400 by 60 to 300 mm with one to four flanges, one at each side, 20 to 120 mm
high, bent by 30 to 120 degrees, 3 to 15 mm apart from it, of 0.8 to 4 mm, up or down, each 60 to 100 % as long
as its side; the seed is the number of the part. Ratios are of one run; times are of the machine that it ran on.
"""

import concurrent.futures
import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE / "../tests/cli"))
sys.path.insert(0, str(HERE / "../tests/support"))
import step_files  # noqa: E402
from processes import children_of  # noqa: E402

PLANISH, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
WORKERS = os.cpu_count() or 1


def plates(seed):
    """A random base with flanges, as a plates file."""
    rng = random.Random(seed)
    length, width = rng.uniform(80, 400), rng.uniform(60, 300)
    base = [[0, 0, 0], [length, 0, 0], [length, width, 0], [0, width, 0]]
    spec = {"format": "planish/plates", "version": 1, "thickness": rng.choice([0.8, 1, 1.5, 2, 3, 4]),
            "plates": [{"id": "base", "outline": base}]}
    up = rng.choice([1, -1])
    for side in rng.sample(range(4), rng.randint(1, 4)):
        a, b = base[side], base[(side + 1) % 4]
        along = [(q - p) / math.dist(a, b) for p, q in zip(a, b)]
        out = [along[1], -along[0], 0.0]
        angle, gap, height = math.radians(rng.uniform(30, 120)), rng.uniform(3, 15), rng.uniform(20, 120)
        span = math.dist(a, b) * rng.uniform(0.6, 1.0)
        begin = rng.uniform(0, math.dist(a, b) - span)

        def at(s, h):
            rise = gap + h
            across = gap + rise * math.cos(angle)
            return [a[i] + along[i] * s + out[i] * across + (up * rise * math.sin(angle) if i == 2 else 0.0)
                    for i in range(3)]
        spec["plates"].append({"id": f"side-{side}", "outline": [
            at(begin, 0), at(begin + span, 0), at(begin + span, height), at(begin, height)]})
    return json.dumps(spec)


def batch(*arguments, **process):
    begun = time.monotonic()
    subprocess.run([PLANISH, "batch", *map(str, arguments), "-q"], check=True, **process)
    return time.monotonic() - begun


def fresh(name):
    folder = FOLDER / name
    shutil.rmtree(folder, ignore_errors=True)
    return folder


def resident(process):
    """Mebibytes."""
    try:
        words = pathlib.Path(f"/proc/{process}/statm").read_text().split()
    except OSError:
        return 0.0
    return int(words[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def small_parts(count):
    folder = FOLDER / f"small-{count}"
    folder.mkdir(parents=True, exist_ok=True)
    for i in range(count):
        (folder / f"{i:05}.step").write_text(step_files.angle(leg=30 + 0.01 * i))
    return folder


def throughput():
    folder, count, alone = small_parts(1000), 1000, 200
    files = sorted(folder.iterdir())[:alone]

    def one(file):
        subprocess.run([PLANISH, "unfold", file, "-q", "-o", FOLDER / f"{file.stem}.dxf"], check=True)
    rates = {}
    for workers in (1, WORKERS):
        begun = time.monotonic()
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            list(pool.map(one, files))
        rates[workers] = alone / (time.monotonic() - begun)
    together = count / batch(folder, "-o", fresh("out-small"), "--jobs", WORKERS)
    for workers, rate in rates.items():
        print(f"one process a file, {workers} at a time: {rate:.0f} a second")
    print(f"batch, {WORKERS} workers: {together:.0f} a second: {together / rates[1]:.1f} and "
          f"{together / rates[WORKERS]:.1f} times as many")


def many():
    folder, count = FOLDER / "many", 20000
    folder.mkdir(parents=True, exist_ok=True)
    for i in range(count):
        (folder / f"{i:05}.json").write_text(plates(i))
    out = fresh("out-many")
    program = subprocess.Popen([PLANISH, "batch", folder, "-o", out, "--jobs", str(WORKERS)])
    begun, most = time.monotonic(), 0.0
    while program.poll() is None:
        most = max([most, *map(resident, children_of(program.pid))])
        parent = resident(program.pid)
        time.sleep(0.2)
    taken = time.monotonic() - begun
    print(f"{count} parts by connect: {taken:.0f} s, {count / taken:.0f} a second; a worker up to {most:.0f} MiB, "
          f"the program {parent:.0f} MiB at the end")


def memory():
    folder = small_parts(5000)
    out = fresh("out-memory")
    program = subprocess.Popen([PLANISH, "batch", folder, "-o", out, "--jobs", "1", "-q", "--progress", "json"],
                               stderr=subprocess.PIPE, text=True)
    for line in program.stderr:
        done = json.loads(line)["done"]
        if done in (100, 1000, 2000, 3000, 4000, 4990):
            print(f"after {done}: {', '.join(f'{resident(one):.1f}' for one in children_of(program.pid))} MiB")
    program.wait()


def merge():
    """Shards as `planish batch` leaves them, with the reports and files of `many` under other names."""
    source = FOLDER / "out-many"
    lines = (source / ".planish-batch" / "journal.jsonl").read_text().splitlines()
    shards, each = 1000, 1000
    root = fresh("out-merge")
    bytes_of_all = 0
    for number in range(1, shards + 1):
        folder = root / f"shard-{number}-of-{shards}"
        (folder / ".planish-batch").mkdir(parents=True)
        names, texts = [], []
        for i in range(each):
            at = (number - 1) * each + i
            name, line = f"{at:07}.json", lines[at % len(lines)]
            old = json.loads(line.split("\t")[0])["name"]
            texts.append(line.replace(json.dumps(old), json.dumps(name)).replace(f"{old}/", f"{name}/"))
            names.append(name)
            (folder / "parts" / name).mkdir(parents=True)
            for file in (source / "parts" / old).glob("*"):
                os.link(file, folder / "parts" / name / file.name)
        text = "\n".join(texts) + "\n"
        bytes_of_all += len(text)
        (folder / ".planish-batch" / "journal.jsonl").write_text(text)
        (folder / ".planish-batch" / "run.json").write_text(json.dumps(
            {"shard": [number, shards], "inputs": shards * each, "work": "bench", "finished": True, "names": names}))
    print(f"{shards} shards of {each} parts: {bytes_of_all / 2**30:.1f} GiB of reports and shapes", flush=True)
    program = subprocess.Popen([PLANISH, "batch", "--merge", root, "-o", root, "-q"])
    begun, most = time.monotonic(), 0.0
    while program.poll() is None:
        most = max(most, resident(program.pid))
        time.sleep(0.2)
    summary = json.loads((root / "summary.json").read_text())
    print(f"merged in {time.monotonic() - begun:.0f} s with {most:.0f} MiB: {summary['parts']} parts, "
          f"{summary['distinct']} distinct")


def corpus():
    parts = HERE / "../../shared/parts"
    out = fresh("out-corpus")
    most = [0.0]
    program = subprocess.Popen([PLANISH, "batch", parts, "-o", out, "--jobs", "1", "-q"])

    def watch():
        while program.poll() is None:
            most[0] = max([most[0], *map(resident, children_of(program.pid))])
            time.sleep(0.02)
    watching = threading.Thread(target=watch)
    watching.start()
    _, _, usage = os.wait4(program.pid, 0)
    program.returncode = 0
    watching.join()
    count = sum(1 for _ in parts.glob("*.st*p"))
    used = usage.ru_utime + usage.ru_stime
    print(f"{count} files of the corpus: {used:.1f} s of one core, {used / count * 1000:.0f} ms a file, "
          f"a worker up to {most[0]:.0f} MiB")


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    for wanted in sys.argv[3:]:
        {"throughput": throughput, "many": many, "memory": memory, "merge": merge, "corpus": corpus}[wanted]()
