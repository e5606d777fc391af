"""What a notebook leaves behind is gone when the next one runs: processes, living and dead, files, shared memory."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

import psutil
import pytest

from rlrobot_course.homework import COURSE
from rlrobot_grading.marking import guard, left_behind
from rlrobot_grading.marking.guard import NO_GUARD, Guard
from rlrobot_grading.marking.kernel import Kernel

pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(sys.platform != "linux", reason="/proc is Linux's"),
]
needs_root = pytest.mark.skipif(
    os.name == "nt" or os.getuid() != 0 or None in map(shutil.which, guard.OTHER_USER),
    reason="needs root, setpriv and prlimit",
)
USER = 61_400  # whom no other test uses at the same time
LEAVES = {
    "a child": "subprocess.Popen(['sleep', '300'])",
    "one of another session": "subprocess.Popen(['sleep', '300'], start_new_session=True)",
    "one without a parent": "subprocess.run(['sh', '-c', 'sleep 300 & sleep 300 &'])",
    "dead ones whom nobody waits for": "[subprocess.Popen(['true']) for _ in range(20)]",
    "many": """
for _ in range(60):
    if os.fork() == 0:
        time.sleep(300)
        os._exit(0)""",
}
# each starts the next one and ends, so that it is gone when one looks for it
RABBIT = """
if os.fork() == 0:
    os.setsid()
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if os.fork():
            os._exit(0)
"""
UP_TO_THE_LIMIT = """
for _ in range(300):
    try:
        child = os.fork()
    except OSError:
        break
    if child == 0:
        time.sleep(300)
        os._exit(0)
else:
    raise AssertionError("there is no limit")
"""


def run(folder: Path, cell: str, behind: Guard = NO_GUARD) -> tuple[str, str]:
    """What comes of a cell in a kernel of its own, which ends after it."""
    names = ["target"]
    for name in ("work", "home"):
        (folder / name).mkdir(parents=True)
    with Kernel(
        folder / "work", folder / "home", COURSE, "03", names, 2048, behind
    ) as kernel:
        return kernel.run(f"import os, subprocess, time\n{cell}", 60)


def processes_of(uid: int) -> list[int]:
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has ended meanwhile
            if place.stat().st_uid == uid:
                found.append(int(place.name))
    return found


@pytest.mark.parametrize("name", LEAVES)
def test_no_process_of_a_notebook_is_left_neither_living_nor_dead(tmp_path, name):
    before = psutil.Process().children(recursive=True)
    assert run(tmp_path, LEAVES[name]) == ("", "")
    assert psutil.Process().children(recursive=True) == before


@needs_root
@pytest.mark.parametrize("cell", [UP_TO_THE_LIMIT, RABBIT], ids=["limit", "rabbit"])
def test_after_a_notebook_that_uses_all_its_processes_the_next_one_has_as_many(
    monkeypatch, cell
):
    monkeypatch.setattr(guard, "PROCESSES", 100)
    with tempfile.TemporaryDirectory() as temporary:
        Path(temporary).chmod(0o755)  # pytest's own folders are root's alone
        for i in range(3):
            with Guard(user=str(USER)).of_one_job() as one:
                assert run(Path(temporary, str(i)), cell, one) == ("", "")
                assert processes_of(one.uid) == []


@needs_root
def test_an_accounts_other_processes_are_not_ended(tmp_path, monkeypatch):
    """Only a number of nobody has no process but the notebook's."""
    monkeypatch.setattr(guard, "_is_somebody", lambda uid: uid == USER)
    other = subprocess.Popen(["sleep", "60"], user=USER)
    try:
        Guard(user=str(USER)).end(tmp_path)
        time.sleep(0.2)
        assert other.poll() is None
        monkeypatch.setattr(guard, "_is_somebody", lambda uid: False)
        Guard(user=str(USER)).end(tmp_path)
        assert other.wait(10) < 0
    finally:
        other.kill()
        other.wait()


@needs_root
def test_processes_of_a_grading_that_was_killed_are_ended_before_the_next_begins():
    left = subprocess.Popen(["sleep", "60"], user=USER)
    try:
        with Guard(user=str(USER)).of_one_job():
            assert left.wait(10) < 0
    finally:
        left.kill()
        left.wait()


@needs_root
def test_a_grading_that_begins_is_not_disturbed_by_the_end_of_another(monkeypatch):
    used = []
    check_rights = Guard._check_rights
    monkeypatch.setattr(
        Guard,
        "_check_rights",
        lambda self, *more: used.append(self.uid) or check_rights(self, *more),
    )
    with Guard(user=str(USER)).of_one_job() as one:
        Guard(user=str(USER)).check(COURSE, [])
    assert used and one.uid not in used


MAKES = {
    "shm": "system.shmget(0, 4096, 0o1666)",
    "sem": "system.semget(0, 1, 0o1666)",
    "msg": "system.msgget(0, 0o1666)",
}


@needs_root
@pytest.mark.parametrize("kind", left_behind.IPC_KINDS)
def test_what_a_user_leaves_in_the_memory_of_the_system_is_removed(kind):
    if not (left_behind.IPC / kind).exists():
        pytest.skip("this kernel has no IPC of System V")
    makes = f"import ctypes; system = ctypes.CDLL(None); assert {MAKES[kind]} >= 0"
    own = eval(MAKES[kind], {"system": ctypes.CDLL(None)})  # root's, which stays
    before = left_behind._objects_of(USER)
    try:
        with left_behind.removed_in_the_end(USER):
            Guard(user=str(USER))._output([sys.executable, "-c", makes], "")
            assert left_behind._objects_of(USER) > before
        assert left_behind._objects_of(USER) == before
        assert (kind, own) in left_behind._objects_of(0)
    finally:
        left_behind._remove(kind, own)
