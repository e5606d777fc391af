"""Workers on all cores: joblib's, with streams where there is no console, that end with their parent."""

import multiprocessing
import os
import sys
import threading
from contextlib import suppress
from functools import cache
from multiprocessing.connection import Connection
from typing import Any

from joblib import Parallel


def workers(n_jobs: int = -1, **how: Any) -> Parallel:
    """joblib's way to work on several cores, with workers that end when this process does."""
    _open_streams()
    return Parallel(
        n_jobs, **how, initializer=_end_with_parent, initargs=_lifeline()[:1]
    )


def _open_streams() -> None:
    """Give a process that has no console the streams that joblib takes for granted; they lead nowhere."""
    for name in ("stdin", "stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "r+"))  # noqa: SIM115 - for as long as the process runs


@cache
def _lifeline() -> tuple[Connection, Connection]:
    """Both ends of a pipe. This process alone has the second, which closes however it ends."""
    return multiprocessing.Pipe(duplex=False)


def _end_with_parent(lifeline: Connection) -> None:
    """Let a new worker process end with its parent; joblib's own would wait for work for ever."""

    def hold() -> None:
        with suppress(EOFError, OSError):
            lifeline.recv_bytes()  # nothing is ever sent
        os._exit(1)

    threading.Thread(target=hold, daemon=True).start()
    _open_streams()
