"""A learner's function is run: it may raise, print, call exit() or never end, and the notebook goes on."""

from __future__ import annotations

import contextlib
import dis
import functools
import io
import signal
import sys
import threading
import time
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import BuiltinFunctionType, CodeType, FrameType
from typing import Any

import numpy as np

from rlrobot_grading.answers.compiling import told_of_compiling, uncompiled
from rlrobot_grading.answers.frames import told_by
from rlrobot_grading.answers.notebook import shell
from rlrobot_grading.answers.values import Function, one_line, safely

SECONDS = 3.0  # of computing that an answer may take; right ones take a hundredth of it
PATIENCE = 30.0  # of waiting, as in time.sleep [s]
COMPUTES = "has not ended after {:.0f} seconds of computing"
WAITS = "has waited for {:.0f} seconds"
SNOOZE = 1.0  # until an alarm that was swallowed comes again [s]
SOON = 0.05  # the same, of an alarm for an answer that computes [s]
EVENTS = 200  # lines and calls between two looks at the clock


@dataclass(frozen=True)
class Failure:
    """An exception of a learner's function.

    kind: name of its class; text: the whole of it in words; line: the learner's line, empty where it cannot be had
    inside: whether it came up inside the function; otherwise the call itself failed, with a wrong number of arguments
    told: what its frames tell, in words for the learner: the call that went wrong, the index that is beyond the end
    """

    kind: str
    text: str
    line: str = ""
    inside: bool = True
    told: str = ""

    @property
    def ends(self) -> str:
        """How the function ends, as the end of a sentence about it."""
        text = self.text
        if self.kind != TooLong.__name__:
            text = f"stops with {text}"
        if self.line:
            text = f"{text}, in the line “{self.line}”"
        return text


class TooLong(BaseException):
    """An answer does not end; it says how. No Exception: ``except Exception`` in the answer must not hold it up."""


@dataclass(frozen=True)
class Elsewhere:
    """A learner's function that runs in another process, as when a notebook is graded.

    ask: call it there; changes the arguments as it has changed them, and returns what `attempt` does
    is_unfinished: whether there are still dots in it, or nothing at all
    """

    ask: Callable[..., tuple[Any, Failure | None, str]]
    is_unfinished: bool = False

    def __call__(self, *arguments: Any) -> Any:
        """What the function returns. Raises RuntimeError where it fails."""
        value, failure, _ = self.ask(*arguments)
        if failure:
            raise RuntimeError(failure.text)
        return value


def attempt(
    answer: Function,
    *arguments: Any,
    endless: bool = False,
    seconds: float | None = None,
    patience: float | None = None,
) -> tuple[Any, Failure | None, str]:
    """What a learner's function returns, what it raises, and what it prints.

    endless: whether it may take as long as it likes, as the library's functions may, which are compiled first
    seconds, patience: otherwise, how long it may compute, and wait; without them SECONDS and PATIENCE
    SystemExit counts as well, for ``exit()`` must not end the notebook. KeyboardInterrupt is the reader's and passes.
    """
    # isinstance would ask the answer, which may be anything
    if issubclass(type(answer), Elsewhere):
        return answer.ask(*arguments)
    printed, answer = io.StringIO(), safely(answer, uncompiled, answer)
    try:
        with quietly(printed), exits_raised():
            if endless:
                value = answer(*arguments)
            else:
                value = ended_in_time(
                    answer,
                    *arguments,
                    seconds=SECONDS if seconds is None else seconds,
                    patience=PATIENCE if patience is None else patience,
                )
            return value, None, printed.getvalue()
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        unknown = Failure("error", "an error that cannot be shown")
        return (
            None,
            safely(unknown, _failure, error, answer) or unknown,
            printed.getvalue(),
        )


def ended_in_time(
    answer: Function, *arguments: Any, seconds: float, patience: float
) -> Any:
    """What `answer` returns. Raises TooLong in it when it has computed, or waited, for longer than that.

    Python itself calls `look` at every line, so this works where there are neither signals nor threads; where it would
    tell of no line, since a loop stays on one, `look` asks for each step of the machine. After it has raised, Python
    looks no more. Should a bare ``except:`` in a loop swallow TooLong, `again` has the next call looked at, and then
    each step of the machine, one step later every time: one of them lies outside the ``try``. In a loop without calls
    an alarm does so in its place, where there are alarms.
    What never ends within one call of something written in C, as ``max(itertools.count())``, is not ended.
    A profiler or a tracer that was set before is set again. A debugger wants to look at each line itself, and its user
    may take as long as they like: then there is no limit.
    """
    if _is_debugged():
        return answer(*arguments)
    before, before_profile, own = sys.gettrace(), sys.getprofile(), globals()
    computed, waited, countdown, swallowed = (
        time.process_time(),
        time.perf_counter(),
        EVENTS,
        0,
    )

    def look(frame: FrameType, event: str, argument: Any) -> Any:
        nonlocal countdown
        if event == "call" and frame.f_globals is own:
            return None  # an alarm has come
        countdown -= 1
        # at other events the learner's line would get lost
        if countdown <= 0 and event in ("line", "opcode"):
            has_computed = time.process_time() - computed > seconds
            if has_computed or time.perf_counter() - waited > patience:
                sys.setprofile(again)
                told = COMPUTES.format(seconds)
                if not has_computed:
                    told = WAITS.format(patience)
                alarm.come_soon(told)
                raise TooLong(told)
            countdown = EVENTS
        if event == "call" and _loops_within_a_line(frame.f_code):
            frame.f_trace_opcodes = True
        return look

    def again(frame: FrameType, *_: Any) -> None:
        nonlocal countdown, swallowed
        if frame.f_globals is not own and sys.gettrace() is None:
            swallowed += 1
            countdown = swallowed
            sys.settrace(look)
            frame.f_trace, frame.f_trace_opcodes = look, True

    def begin_to_compile() -> None:
        nonlocal computed, waited
        computed, waited = computed - time.process_time(), waited - time.perf_counter()
        sys.settrace(None)

    def end_compiling() -> None:
        nonlocal computed, waited
        computed, waited = computed + time.process_time(), waited + time.perf_counter()
        sys.settrace(look)

    # nothing is looked at in what stands around the answer
    with (
        told_of_compiling(begin_to_compile, end_compiling),
        _woken(patience, again) as alarm,
    ):
        sys.settrace(look)
        try:
            return answer(*arguments)
        finally:
            # first of all: an alarm in what follows would leave the learner's process looked at for ever
            alarm.is_over = True
            is_as_before = sys.getprofile() is before_profile
            # until both are off a call of a Python function would be looked at
            if not is_as_before:
                sys.setprofile(None)
            sys.settrace(None)
            if not is_as_before:
                _set_again(sys.setprofile, before_profile)
            _set_again(sys.settrace, before)


def _is_debugged() -> bool:
    """Whether a debugger such as JupyterLab's is attached: it puts a function of its own in the place of settrace."""
    return not isinstance(sys.settrace, BuiltinFunctionType)


def _set_again(set_it: Callable[[Any], None], before: Any) -> None:
    """Set the profiler or tracer again that was set before. One written in C, as %prun's, is no function."""
    if before is None or callable(before):
        set_it(before)
    else:
        before.enable()


@dataclass
class Alarm:
    """What wakes an answer that waits, or that computes and has swallowed TooLong.

    told: what it says; is_there: whether there are alarms here; is_early: whether it comes for an answer that computes
    is_over: whether the answer has ended, so that nothing is left to be woken
    """

    told: str
    is_there: bool = False
    is_early: bool = False
    is_over: bool = False

    def come_soon(self, told: str) -> None:
        """Come for an answer that computes, again and again until it ends."""
        self.told, self.is_early = told, True
        if self.is_there and not self.is_over:
            signal.setitimer(signal.ITIMER_REAL, SOON, SOON)


@contextmanager
def _woken(patience: float, again: Callable[[FrameType], None]) -> Iterator[Alarm]:
    """Have what waits within one call, as time.sleep does, end when that is over, where the system has alarms.

    An alarm that something swallows, as ``except:`` or a ``__del__`` does, comes again. again: what has each step of
    the machine looked at in an answer that computes
    """
    alarm = Alarm(WAITS.format(patience))
    if threading.current_thread() is not threading.main_thread() or not hasattr(
        signal, "setitimer"
    ):
        yield alarm
        return

    def wake(_: int, frame: FrameType | None) -> None:
        if alarm.is_over:
            return
        if frame is not None and alarm.is_early:
            again(frame)  # what swallows it is looked at
        raise TooLong(alarm.told)

    alarm.is_there = True
    before = signal.signal(signal.SIGALRM, wake)
    signal.setitimer(signal.ITIMER_REAL, patience, SNOOZE)
    try:
        yield alarm
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@functools.cache
def _loops_within_a_line(code: CodeType) -> bool:
    """Whether a function has a ``while True: pass`` of one line: until Python 3.12 its rounds are no new lines."""
    if sys.version_info >= (3, 12):
        return False
    steps = {step.offset: step for step in dis.get_instructions(code)}
    line_of = {
        at: line for begin, end, line in code.co_lines() for at in range(begin, end)
    }
    # a loop over something ends by itself
    return any(
        "JUMP_BACKWARD" in step.opname
        and line_of[at] == line_of[step.argval]
        and steps[step.argval].opname != "FOR_ITER"
        for at, step in steps.items()
    )


@contextmanager
def quietly(printed: io.StringIO) -> Iterator[None]:
    """Keeps what is printed, and numpy's warnings, out of the notebook: the verdict says it all."""
    with (
        contextlib.redirect_stdout(printed),
        warnings.catch_warnings(),
        np.errstate(all="ignore"),
    ):
        warnings.simplefilter("ignore")
        yield


@contextmanager
def exits_raised() -> Iterator[None]:
    """In a notebook exit() raises nothing, but has the kernel end a little later. Here it raises, as in a program."""
    here = shell()
    if here is None:
        yield
        return
    here.ask_exit = sys.exit  # hides the method of this name
    try:
        yield
    finally:
        del here.ask_exit


def _failure(error: BaseException, answer: Function) -> Failure:
    file = getattr(getattr(answer, "__code__", None), "co_filename", None)
    frames = [frame for frame, _ in traceback.walk_tb(error.__traceback__)]
    last = max(
        (i for i, frame in enumerate(frames) if frame.f_code.co_filename == file),
        default=None,
    )
    kind = type(error).__name__
    text = (
        str(error)
        if isinstance(error, TooLong)
        else one_line(f"{kind}: {error}".removesuffix(": ")) or kind
    )
    if last is None:
        return Failure(kind, text, inside=file is None and len(frames) > 1)
    line = one_line(
        (traceback.extract_tb(error.__traceback__)[last].line or "").strip()
    )
    return Failure(
        kind,
        text,
        line,
        told=one_line(safely("", told_by, error, frames[last:], line), 400),
    )
