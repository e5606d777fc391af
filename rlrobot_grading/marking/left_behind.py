"""What a notebook leaves behind is cleared away for the next one: processes, and what its user has left elsewhere."""

from __future__ import annotations

import ctypes
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Collection, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

ENDING = 20.0  # of processes, at most [s]
ROUND = 0.5  # in which what was killed is waited for, before one looks again [s]
ADOPT = 36  # PR_SET_CHILD_SUBREAPER of Linux: what outlives its parent, even with setsid, becomes the grader's child
SHARED = (
    Path(tempfile.gettempdir()),
    Path("/var/tmp"),
    Path("/dev/shm"),
    Path("/dev/mqueue"),
    Path("/run/lock"),
)  # folders where everybody may leave something
IPC = Path("/proc/sysvipc")  # the tables of System V on Linux
IPC_KINDS = ("shm", "sem", "msg")  # shared memory, semaphores, queues of messages
IPC_REMOVE = 0  # IPC_RMID


def processes() -> list[Any]:
    """The processes that this one has started, and those that these have left behind: on Linux they become its own.

    The dead are among them, until somebody waits for them.
    """
    import psutil

    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(ADOPT, 1)
    try:
        return list(psutil.Process(os.getpid()).children(recursive=True))
    except psutil.Error:
        return []


def end_all_but(others: Collection[Any]) -> None:
    """End the processes that this one has started, except some, and wait for them.

    The dead whom nobody has waited for count among the processes of their user, who may have only so many.
    """
    import psutil

    end = time.monotonic() + ENDING
    while time.monotonic() < end:  # some may start others meanwhile
        left = [one for one in processes() if one not in others]
        if not left:
            break
        for one in left:
            with suppress(psutil.Error):  # it is gone already
                one.kill()
        psutil.wait_procs(left, timeout=ROUND)


@contextmanager
def removed_in_the_end(uid: int) -> Iterator[None]:
    """Remove in the end what belongs to a user and was not there in the beginning."""
    files = _files_of(uid)
    objects = _objects_of(uid)
    try:
        yield
    finally:
        for path in _files_of(uid) - files:
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path, ignore_errors=True)
            else:
                path.unlink(missing_ok=True)
        for kind, number in _objects_of(uid) - objects:
            _remove(kind, number)


def _files_of(uid: int) -> set[Path]:
    files = set()
    for folder in SHARED:
        paths = folder.iterdir() if folder.is_dir() else ()
        for path in paths:
            with suppress(OSError):  # it is gone already
                if path.lstat().st_uid == uid:
                    files.add(path)
    return files


def _objects_of(uid: int) -> set[tuple[str, int]]:
    """System V's objects of a user, as ("shm", 3)."""
    objects = set()
    for kind in IPC_KINDS:
        with suppress(OSError):  # this kernel has no such table
            names, *lines = (IPC / kind).read_text().splitlines()
            for line in lines:
                row = dict(zip(names.split(), line.split(), strict=True))
                if int(row["cuid"]) == uid:
                    # in the second column, as shmid, semid, msqid
                    objects.add((kind, int(line.split()[1])))
    return objects


def _remove(kind: str, number: int) -> None:
    system = ctypes.CDLL(None)
    if kind == "shm":
        system.shmctl(number, IPC_REMOVE, None)
    elif kind == "sem":
        system.semctl(number, 0, IPC_REMOVE)
    else:
        system.msgctl(number, IPC_REMOVE, None)
