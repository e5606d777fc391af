"""A learner's function under numba's decorators is judged as the Python that it is, and compiling is not its time."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from rlrobot_grading.answers.values import Function


def uncompiled(answer: Function) -> Function:
    """The Python function that numba.njit was put on: of that, each line can be looked at."""
    is_numbas = type(answer).__module__.partition(".")[0] == "numba"
    return getattr(answer, "py_func", answer) if is_numbas else answer


@contextmanager
def told_of_compiling(
    begins: Callable[[], None], ends: Callable[[], None]
) -> Iterator[None]:
    """Call `begins` and `ends` around each time that numba compiles what is called."""
    event: Any = sys.modules.get("numba.core.event")
    if event is None:
        yield
        return

    class Listener(event.Listener):  # type: ignore[misc]
        depth = 0  # what is compiled has what it calls compiled

        def on_start(self, _: Any) -> None:
            self.depth += 1
            if self.depth == 1:
                begins()

        def on_end(self, _: Any) -> None:
            self.depth -= 1
            if self.depth == 0:
                ends()

    with event.install_listener("numba:compile", Listener()):
        yield
