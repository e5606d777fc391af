"""Faults on purpose: a process killed at a chosen moment, a full disk, a folder that this user may not write to."""

from __future__ import annotations

import functools
import os
import random
import signal
import subprocess
import sys
import time
import traceback
from contextlib import contextmanager
from pathlib import Path

import pytest

try:
    import resource
except ImportError:  # Windows
    resource = None

TESTS = Path(__file__).parent
NOBODY = 65534
WRITING = {"write_together"}  # of files.py, which writes for all
EFFECTS = {
    "open",
    "write",
    "flush",
    "fsync",
    "mkdir",
    "replace",
    "unlink",
}  # calls that change something

needs_fork = pytest.mark.skipif(
    not hasattr(os, "fork"), reason="needs a system on which a process can be copied"
)
needs_limits = pytest.mark.skipif(
    resource is None, reason="needs a system that can limit the size of files"
)


# tqdm shares a lock with forks, which one that is killed would keep for ever, and has a thread that watches its bars.
ONE_THREAD = "import threading, tqdm; tqdm.tqdm.monitor_interval = 0; tqdm.tqdm.set_lock(threading.RLock())"


def alone(test):
    """Let a test with the fixture `tmp_path` run in a process of its own: it has one thread, and so can fork."""

    @needs_fork
    @functools.wraps(test)
    def in_a_process_of_its_own(tmp_path):
        name = f"{test.__module__} as t; t.{test.__name__}.__wrapped__"
        its_folder = str(Path(test.__code__.co_filename).parent)
        code = f"{ONE_THREAD}; import pathlib, sys; sys.path.append({its_folder!r})\n"
        code += f"import {name}(pathlib.Path({str(tmp_path)!r}))"
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=TESTS, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr

    return in_a_process_of_its_own


def is_killed(do, arm=None, after=None) -> bool:
    """Whether a copy of this process is killed while it does something; once it has been armed, or `after` seconds."""
    if pid := os.fork():
        if after is not None:
            time.sleep(after)
            os.kill(pid, signal.SIGKILL)
        status = os.waitpid(pid, 0)[1]
        assert status == 0 or os.WIFSIGNALED(status), (
            "it failed before it was killed; see above"
        )
        return status != 0
    try:
        if arm is not None:
            arm()
        do()
        while after is not None:
            do()
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        os._exit(1)


def at_call(n, reached=None):
    """Arm this process: it kills itself before or after the call number n/2 that changes something on disk.

    reached: a list that takes the name of each call, where nobody is to be killed
    """
    depth = count = 0

    def watch(frame, event, called):
        nonlocal depth, count
        code = frame.f_code
        if event in ("call", "return"):
            if code.co_name in WRITING and code.co_filename.endswith(
                "rlrobot_edu/files.py"
            ):
                depth += 1 if event == "call" else -1
        elif depth and called.__name__ in EFFECTS:
            if reached is not None:
                reached.append(called.__name__)
            elif count == n:
                os.kill(os.getpid(), signal.SIGKILL)
            count += 1

    sys.setprofile(watch)


def at_size(n):
    """Arm this process: the system kills it in the middle of a write, as soon as a file would exceed n bytes."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (n, n))
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)


def kills(do, number, size, seconds, seed=0):
    """Kill `do` at so many moments, one after the other, and yield after each: before and after calls that write, in
    the middle of a write of at most `size` bytes, and, while it is done over and over, at any time below `seconds`.
    """
    rng, calls = random.Random(seed), []
    at_call(None, calls)
    try:
        do()
    finally:
        sys.setprofile(None)
    assert {"open", "write", "fsync", "replace"} <= set(calls)
    yield
    moments = rng.sample(range(len(calls)), min(len(calls), number * 6 // 10))
    for n in sorted(moments):
        assert is_killed(do, functools.partial(at_call, n))
        yield
    for _ in range(number // 5):
        assert is_killed(do, functools.partial(at_size, rng.randrange(size)))
        yield
    for _ in range(number - number // 5 - len(moments)):
        assert is_killed(do, after=rng.uniform(0, seconds))
        yield


@contextmanager
def full_disk(size):
    """No file can grow beyond `size` bytes: the system says so, as it says that a disk is full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@contextmanager
def as_nobody():
    """Without the rights of root, to whom no folder is read-only; whoever else runs the tests stays who they are."""
    is_root = hasattr(os, "geteuid") and os.geteuid() == 0
    "".encode(
        "cp437"
    )  # zip files are read with it, and nobody may not read it where Python is the user's own
    if is_root:
        os.seteuid(NOBODY)
    try:
        yield
    finally:
        if is_root:
            os.seteuid(0)


def parts(folder):
    """What writers have left behind."""
    return list(Path(folder).rglob(".*.part"))
