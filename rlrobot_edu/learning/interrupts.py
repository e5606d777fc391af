"""Ctrl-C that waits until a step is whole, so that learning can go on after it."""

import signal
from types import FrameType, TracebackType
from typing import Any


class DelayedInterrupt:
    """Within it Ctrl-C waits, until `raise_if_pressed` or the end; pressed a second time, it is heard at once.

    So it is where Python's own handler is in force, which raises KeyboardInterrupt; elsewhere nothing changes, nor in
    threads, which hear no signals.

    waits: whether it does anything at all
    """

    def __init__(self, waits: bool = True) -> None:
        self._waits = waits
        self._pressed = False

    def __enter__(self) -> "DelayedInterrupt":
        if self._waits and _handler() is signal.default_int_handler:
            try:
                signal.signal(signal.SIGINT, self._note)
            except ValueError:
                pass  # not the main thread of the main interpreter
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._restore()
        if error is None:
            self.raise_if_pressed()

    def raise_if_pressed(self) -> None:
        """Raise KeyboardInterrupt if Ctrl-C was pressed meanwhile."""
        if self._pressed:
            self._pressed = False
            raise KeyboardInterrupt

    def _note(self, number: int, frame: FrameType | None) -> None:
        if self._pressed:
            self._restore()  # here, for __exit__ is not called if this comes within __enter__
            raise KeyboardInterrupt
        self._pressed = True

    def _restore(self) -> None:
        if _handler() == self._note:  # not one that a step has set
            signal.signal(signal.SIGINT, signal.default_int_handler)


def _handler() -> Any:
    return signal.getsignal(signal.SIGINT)
