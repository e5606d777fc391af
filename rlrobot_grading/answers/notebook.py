"""The notebook in which a check runs, if there is one."""

from __future__ import annotations

import os
import sys
import threading
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

AT_ONCE = 2.0  # what takes longer says that it works [s]


def shell() -> Any:
    """IPython's shell; None where there is none."""
    if "IPython" not in sys.modules:
        return None
    return sys.modules["IPython"].get_ipython()


def is_notebook() -> bool:
    """Whether this runs in the kernel of a notebook, where there is a learner."""
    return getattr(shell(), "kernel", None) is not None


@contextmanager
def told_if_slow(text: str) -> Iterator[None]:
    """Show `text` in the notebook while something takes more than AT_ONCE; not in one that is run to be saved."""
    is_saved = os.environ.get("RLROBOT_EDU_PROGRESS") == "0"
    has_threads = sys.platform != "emscripten"
    if not is_notebook() or is_saved or not has_threads:
        yield
        return
    place = {"display_id": uuid.uuid4().hex}
    publish = shell().display_pub.publish
    is_told = threading.Event()

    def tell() -> None:
        publish({"text/plain": text}, transient=place)
        is_told.set()

    timer = threading.Timer(AT_ONCE, tell)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        if is_told.is_set():
            publish({"text/plain": ""}, transient=place, update=True)
