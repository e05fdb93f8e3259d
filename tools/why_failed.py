#!/usr/bin/python3
"""The last lines of ./test: which tests failed and why, or what stopped a build; which tests were left out.

    tools/why_failed.py tests LOG      LOG: what ctest said, with the output of tests that failed
    tools/why_failed.py step LOG       LOG: what CMake, Ninja or apt said
    tools/why_failed.py skipped LOG    LOG: ctest's LastTest.log, which has the output of all tests

At most 60 lines."""

import re
import sys

LINES, WIDTH, NAMED = 55, 200, 16
RESULT = re.compile(r"^ *\d+/\d+ +Test +#\d+: (.+?) \.*(?: *(\w[\w ]*?))? *(?:Passed|\*{3}(.+?)) +[\d.]+ sec")
START = re.compile(r"^ +Start +\d+: (.*)$")
UNITTEST = re.compile(r"^(?:FAIL|ERROR): (\w+)")
COMPILER = re.compile(r"\b(?:error|Error|undefined reference|Killed|multiple definition|No space left)\b")


def read(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return [line.rstrip() for line in file]


def failures(lines):
    """(name, how, output) of each test that failed; the names of those that had begun and had no result."""
    failed, running, output = [], {}, None
    for line in lines:
        if found := START.match(line):
            running[found[1]] = True
            output = None
        elif found := RESULT.match(line):
            running.pop(found[1], None)
            output = []
            if found[3] and not found[3].startswith("Skipped"):
                failed.append((found[1], " ".join(filter(None, (found[2], found[3]))).removesuffix(" Exception:"), output))
        elif re.match(r"^\d+% tests passed", line):
            output = None
        elif output is not None:
            output.append(line)
    return failed, list(running)


def block(lines, begin, most):
    """Lines from `begin` on that are not empty, until the next failure or the end of the test."""
    end = begin + 1
    while end < len(lines) and end - begin < most and not re.match(r"^(\[ |=====|-----+$|.+: Failure$)", lines[end]):
        end += 1
    return [line for line in lines[begin:end] if line.strip()]


def of_googletest(output):
    return [block(output, i, 24) for i, line in enumerate(output) if re.match(r"^(\S+:\d+|unknown file): Failure$", line)]


def of_unittest(output):
    """Of each test its name with what was raised, where, and more of what was raised."""
    found = []
    for i, line in enumerate(output):
        if not UNITTEST.match(line) or not output[i - 1].startswith("====="):
            continue
        rest = output[i + 1:]
        ends = [k for k, other in enumerate(rest) if re.match(r"^(=====|Ran \d+ test)", other)]
        rest = rest[:ends[0]] if ends else rest
        raised = [k for k, other in enumerate(rest) if re.match(r"^[A-Za-z_][\w.]*(Error|Exception|Interrupt|Expired|Exit)\b", other)]
        said = block(rest, raised[0], 24) if raised else rest[-4:]
        places = [k for k in range(raised[0] if raised else len(rest)) if re.match(r'^  File ".*_test\.py"', rest[k])]
        where = [rest[places[-1]].strip()] if places else []
        # What was raised may quote the results of another runner.
        inner = [other for other in rest if re.match(r"^(not ok\b|  error: |Error: )", other)]
        name = re.sub(r" \(__main__\.[\w.]+\)", "", line)
        found.append([name, *said[:1], *inner[:12], *where, *[other for other in said[1:] if other not in inner]])
    return found


def reasons(output):
    """What is known of a failure, a list for each of its parts, what matters most first."""
    found = of_googletest(output) or of_unittest(output)
    if found:
        return found
    noise = re.compile(r"^(\[(==|--|  FAILED|  PASSED| RUN)|Running main\(\)|Note: Google Test filter| ?\d+ FAILED TEST|$)")
    told = [line for line in output if not noise.match(line.strip())]
    errors = [i for i, line in enumerate(told) if re.match(r"^(CMake Error|\S*error:|terminate called)", line)]
    return [told[errors[0]:errors[0] + 12] if errors else told[-12:]]


def shortened(parts, most):
    """At most so many lines: of each part as many as of the others."""
    if most < 3 or len(parts) == 1:
        return parts[0][:most]
    if len(parts) > most // 2:
        kept = (most - 1) // 2
        return [*shortened(parts[:kept], 2 * kept), f"... and {len(parts) - kept} more"]
    counts = shares([len(part) for part in parts], most)
    return [line for part, count in zip(parts, counts) for line in part[:count]]


def shares(wanted, most):
    """`most` among those who want so much each: as much for all, and what some do not need for the others."""
    given = [0] * len(wanted)
    while sum(given) < most and given != wanted:
        for i, one in enumerate(wanted):
            if given[i] < one and sum(given) < most:
                given[i] += 1
    return given


def tests(path):
    lines = read(path)
    failed, running = failures(lines)
    said = []
    if not any(re.match(r"^\d+% tests passed", line) for line in lines):
        done = sum(1 for line in lines if RESULT.match(line))
        said.append(f"ctest did not come to its end; it had done {done} tests.")
        said += [f"  was running: {name}" for name in running[:6]] if running else [f"  | {line}" for line in lines[-8:]]
    if failed:
        said.append(f"{len(failed)} {'test' if len(failed) == 1 else 'tests'} failed:")
    shown = failed[:NAMED]
    parts = [reasons(output) for _, _, output in shown]
    room = shares([min(24, sum(map(len, one))) for one in parts], LINES - len(said) - len(shown))
    for (name, how, _), why, most in zip(shown, parts, room):
        said.append(f"{name}  ({how})")
        said += [f"  | {line[:WIDTH]}" for line in shortened(why, most)]
    if len(failed) > NAMED:
        said.append(f"... and {len(failed) - NAMED} more, the last {failed[-1][0]}")
    if failed or running:
        name = re.escape(failed[0][0] if failed else running[0])
        said.append(f"One again, with all it prints: ./test -R '^{name}$' -V")
    return [*said, f"The whole log: {path}"]


def step(path):
    lines = read(path)
    said = []
    for i, line in enumerate(lines):
        if not line.startswith("FAILED: "):
            continue
        ends = [k for k in range(i + 1, len(lines)) if re.match(r"^(\[\d+/\d+\]|ninja: |FAILED: )", lines[k])]
        part = lines[i + 2:ends[0] if ends else len(lines)]  # after the command
        errors = [k for k, other in enumerate(part) if COMPILER.search(other)]
        shown = [other for k in errors[:4] for other in part[k:k + 3]] or part[-8:]
        said += [line, *(f"  | {other[:WIDTH]}" for other in shown)]
    if not said:
        begin = [i for i, line in enumerate(lines) if line.startswith(("CMake Error", "E: "))]
        said = [f"  | {line[:WIDTH]}" for line in (lines[begin[0]:begin[0] + 20] if begin else lines[-20:])]
    return [*said[:LINES], f"The whole log: {path}"]


def skipped(path):
    """Tests that were left out, with what they say: "name: reason"."""
    said, name, before = [], "", ""
    for line in read(path):
        if found := re.match(r"^\d+/\d+ Test(?:ing)?: (.*)$", line):
            name = found[1]
        elif found := re.match(r"^(.*) \.\.\. skipped ['\"](.*)['\"]$", line):
            # The name stands a line above where the test has a description.
            case = re.match(r"^ *(\w+) \(", found[1]) or re.match(r"^ *(\w+) \(", before)
            said.append(f"{name}{', ' + case[1] if case and case[1] != 'setUpClass' else ''}: {found[2]}")
        elif line.startswith("[  SKIPPED ]") and line.endswith(" ms)"):
            said.append(f"{name}: {before}")
        before = line
    if not said:
        return []
    more = [f"  ... and {len(said) - 20} more: {path}"] if len(said) > 20 else []
    return [f"Left out ({len(said)}):", *(f"  {line[:WIDTH]}" for line in said[:20]), *more]


if __name__ == "__main__":
    for text in {"tests": tests, "step": step, "skipped": skipped}[sys.argv[1]](*sys.argv[2:]):
        print(text)
