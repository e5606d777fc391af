"""An error in a kernel of the user's own: one sentence with its line, and the agent is as it was before the step."""

import re
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from rlrobot_edu.checks import describe_error
from rlrobot_edu.jit.fingerprint import INSTALLED
from rlrobot_edu.learning.memory import Memory, copies, copy_into
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.planning.experience import Experience
from rlrobot_edu.learning.step import StepKernels, make_step, own_parts, plain_step

T = TypeVar("T")


class Before:
    """A copy of what an agent remembers, taken before a step; the next one goes into the same arrays.

    Arrays of some megabytes are so copied in a fifth of the time: new ones come from the system page by page.
    """

    def __init__(self) -> None:
        self._now: tuple[Any, Any] = ((), ())
        self._saved: tuple[Any, ...] = ()

    def take(
        self, memory: Memory, experience: Experience | None, rng: np.random.Generator
    ) -> None:
        """Copy what an agent remembers."""
        now = (memory, experience or ())
        if now[0] is self._now[0] and now[1] is self._now[1]:
            copy_into(self._saved, now)
        else:
            self._now = now
            self._saved = copies(now)
        self._rng = rng
        self._state = rng.bit_generator.state

    def put_back(self) -> None:
        """Restore everything as it was."""
        copy_into(self._now, self._saved)
        self._rng.bit_generator.state = self._state


def guarded(
    method: Method,
    memory: Memory,
    experience: Experience | None,
    rng: np.random.Generator,
    before: Before,
    one_step: Callable[[StepKernels], T],
) -> T:
    """The result of `one_step` of an agent with the kernels of its method.

    memory, experience, rng, before: the agent's

    Raises ValueError in one sentence if a part that is not the toolkit's fails; then they are as they were before.
    """
    if not own_parts(method):
        return one_step(make_step(method))
    before.take(memory, experience, rng)
    try:
        return one_step(make_step(method))
    except Exception as error:
        before.put_back()
        fault = error
    try:
        with np.errstate(divide="raise", invalid="raise"):
            one_step(plain_step(method))  # Python knows the line
    except Exception as error:
        what, line = _failed(method, error)
        raise ValueError(f"{line}: {what} failed: {describe_error(error)}") from error
    finally:
        before.put_back()
    what, line = _refused(method, str(fault))
    if not type(fault).__module__.startswith("numba"):
        raise ValueError(f"{line}: {what} failed: {describe_error(fault)}") from fault
    raise ValueError(
        f"{line}: numba cannot compile {what}: {_reason(str(fault))}. Write it with numbers, arrays and loops; with "
        "NUMBA_DISABLE_JIT=1 it runs as plain Python"
    )


def _failed(method: Method, error: Exception) -> tuple[str, str]:
    """What failed, and in which line, as an error of plain Python tells."""
    frames = traceback.extract_tb(error.__traceback__)
    parts = own_parts(method)
    for what, function in parts.items():
        code = function.__code__
        its_place = code.co_filename, code.co_name
        if its_place in [(frame.filename, frame.name) for frame in frames]:
            last = [frame for frame in frames if _is_theirs(frame.filename)][-1]
            return what, f"{last.filename}, line {last.lineno}"
    # it has returned: what it left is wrong
    is_selection = frames[-1].name == "checked_probabilities"
    kind = "the selection" if is_selection else "the update"
    suspects = [what for what in parts if what.startswith(kind)] or list(parts)
    return suspects[0], _first_line(parts[suspects[0]])


def _is_theirs(file: str) -> bool:
    is_ours = file.startswith((str(Path(__file__).parents[1]), "<rlrobot_edu"))
    return not is_ours and not any(place in file for place in INSTALLED)


def _first_line(function: Any) -> str:
    code = function.__code__
    return f"{code.co_filename}, line {code.co_firstlineno}"


def _refused(method: Method, message: str) -> tuple[str, str]:
    """What numba does not understand, and in which line, as its message tells."""
    parts = own_parts(method)
    for what, function in parts.items():
        file = function.__code__.co_filename
        lines = re.findall(
            rf'File "[^"]*{re.escape(Path(file).name)}", line (\d+)', message
        )
        if lines:
            return what, f"{file}, line {lines[-1]}"
    what, function = next(iter(parts.items()))
    return what, _first_line(function)


def _reason(message: str) -> str:
    """The line of numba's long message that says why."""
    lines = [line.strip() for line in message.splitlines()]
    said = [line for line in lines if line and not line.startswith("Failed in ")]
    return said[0].rstrip(".:") if said else "it says no more"
