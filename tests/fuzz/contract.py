"""What any public call may do with any input, said once; and `attempt`, which finds out whether a call did."""

from __future__ import annotations

import linecache
import os
import re
import resource
import signal
import sys
import traceback
import warnings
from collections.abc import Callable
from pathlib import Path

import gymnasium

import rlrobot_edu

PACKAGE = Path(rlrobot_edu.__file__).parent
OURS = {PACKAGE, PACKAGE.parent / "rlrobot_course"}

# It returns, or it raises one of these, with one sentence that a person can read.
# TypeError is for what Python itself refuses: a wrong number or name of arguments, a value of a wrong type.
DOCUMENTED = (
    ValueError,
    TypeError,
    FileNotFoundError,
    ImportError,
    gymnasium.error.Error,
)
LETTERS = 2000
SECONDS = 20  # of computing; numba compiles a new method in five
WAITING = 60  # seconds for something that never comes, the computer being busy with other things
MEGABYTES = 500  # that one call may need more than all calls before it
ADDRESS_SPACE = 6 << 30  # of the worker, so that a claim of hugeness hurts nobody else
NUMERIC = re.compile(
    "invalid value|overflow|divide by zero"
)  # of our own code's warnings, which are faults


class Fault(Exception):
    """The contract was broken. ``signature`` is the same for the same fault."""

    def __init__(self, what: str, signature: str) -> None:
        super().__init__(what)
        self.signature = signature


class Insane(AssertionError):
    """What a call returned is of no use."""


class Own(Exception):
    """What a caller's own object raises when it is touched; it may come back to the caller."""


def attempt(call: Callable[[], object], given: bool = False) -> str:
    """Make a call: ``accepted``, ``refused``, or ``borrowed`` where it was refused in another library's words.

    given: the call only prepares the next one; whatever it raises counts as refused
    Raises Fault. What crashes or hangs the process is seen by whoever started it.
    """
    peak = _peak()
    _alarms(SECONDS)
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        try:
            call()
            answer = "accepted"
        except BaseException as error:  # SystemExit and the like most of all
            if isinstance(error, KeyboardInterrupt):
                raise  # whoever watches this wants to stop
            answer = "refused" if given else _judge(error)
        finally:
            _alarms(0)
    if _peak() - peak > MEGABYTES:
        raise Fault(f"needs {_peak() - peak:.0f} MB", "more memory than allowed")
    for warning in warned:
        text = str(warning.message)
        if (
            issubclass(warning.category, RuntimeWarning)
            and NUMERIC.search(text)
            and OURS.intersection(_parents(warning))
        ):
            raise Fault(
                f"{text} ({_short(warning.filename)}:{warning.lineno})",
                f"{text} {warning.filename}",
            )
    return answer


def _judge(error: BaseException) -> str:
    """Whether this error is documented, and in whose words. Raises Fault if it is not."""
    frames = traceback.extract_tb(error.__traceback__)
    ours = [
        frame for frame in frames if OURS.intersection(Path(frame.filename).parents)
    ]
    frame = ours[-1] if ours else frames[-1]
    place = f"{_short(frame.filename)}, {frame.name}"
    kind, text = type(error).__name__, str(error)
    signature = f"{kind}: {text}" if isinstance(error, Insane) else f"{kind} in {place}"
    if isinstance(error, Own):
        return "refused"
    if (
        isinstance(error, SystemExit)
        and error.code in (0, 2)
        and "__main__" in frame.filename
    ):
        return "refused"  # the command line's way
    if isinstance(error, OSError) and error.filename:
        return "borrowed"  # the system's own word about a file that it names
    if isinstance(error, ArithmeticError) and any(
        "gymnasium" in Path(frame.filename).parts for frame in frames
    ):
        return "borrowed"  # a wrapper's word about the rewards of the world in it
    if not isinstance(error, DOCUMENTED):
        raise Fault(
            f"{kind}: {text[:300]} ({place}:{frame.lineno})", signature
        ) from error
    if not text.strip() or "\n" in text.strip() or len(text) > LETTERS:
        wrong = (
            "too many words"
            if len(text) > LETTERS
            else "several lines"
            if text.strip()
            else "no words"
        )
        raise Fault(
            f"{kind} of {wrong}: {text[:200]!r} ({place}:{frame.lineno})",
            f"{signature}: {wrong}",
        ) from error
    said_here = frame is frames[-1] and "raise" in linecache.getline(
        frame.filename, frame.lineno or 0
    )
    return "refused" if said_here else "borrowed"


def _short(filename: str) -> str:
    return (
        os.path.relpath(filename, PACKAGE.parent)
        if PACKAGE.parent in Path(filename).parents
        else filename[-40:]
    )


def _parents(warning: warnings.WarningMessage) -> list[Path]:
    return list(Path(warning.filename).parents)


def _peak() -> float:
    """The most memory that this process ever had [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (
        1 << 20 if sys.platform == "darwin" else 1 << 10
    )


def _alarms(seconds: float) -> None:
    """Let the system end this process after so many seconds of computing, or after `WAITING`; 0: never.

    Python's own handlers would not be heard inside compiled code.
    """
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, WAITING if seconds else 0)


def limit_memory() -> None:
    """From now on a claim of hugeness is a MemoryError in this process."""
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
