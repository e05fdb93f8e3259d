"""Processes that a test watches: children, whether they are alive, what must come about."""

import contextlib
import pathlib
import time


def state_of(process):
    """State and parent of a process, None when it is gone."""
    with contextlib.suppress(OSError):
        state, parent = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[:2]
        return state, int(parent)
    return None


def is_alive(process):
    known = state_of(process)
    return known is not None and known[0] != "Z"


def children_of(parent):
    """Processes that a process has started and that are alive."""
    processes = [int(entry.name) for entry in pathlib.Path("/proc").iterdir() if entry.name.isdigit()]
    return [one for one in processes if (known := state_of(one)) and known[0] != "Z" and known[1] == parent]


def until(condition, seconds=20.0):
    """Waits for what must come about."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.02)
    return False
