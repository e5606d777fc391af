"""Exercises: a tape is replayed on the learner's answer, and typical mistakes are recognised by what they compute."""

from __future__ import annotations

import copy
import dis
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.verdict import Verdict

ROUNDED = 2e-3  # how far a number given as an answer may be off
SHOWN = 6  # rows of a comparison; more would hide the first


@dataclass(frozen=True)
class Mistake:
    """A typical wrong answer, as a program of its own, and the hint for whoever gives it."""

    hint: str
    answer: Any


@dataclass(frozen=True)
class Exercise:
    """An exercise whose answer is a function.

    task: what is to be written, for the message of a check that still waits: "write …"
    right: the function as it should be; learners' parameters come in the same order
    tape: the steps, each a mapping from the names of the arguments to their values
    mistakes: the wrong answers that are recognised
    memory: arguments that last from step to step, as Q does; the function may change arrays among them in place
    returns: what the returned value is called; if it is a name in `memory`, that takes the value. Empty for a function
        that only changes its arguments: then whatever it returns is ignored
    """

    task: str
    right: Callable
    tape: Sequence[Mapping[str, Any]]
    mistakes: Sequence[Mistake]
    memory: Mapping[str, Any] = field(default_factory=dict)
    returns: str = ""

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the arguments, in their order."""
        code = self.right.__code__
        return code.co_varnames[: code.co_argcount]

    def __call__(self, answer: Any) -> Verdict:
        """Judge `answer`; never raises."""
        if answer is ... or answer is None:
            return self._waits()
        if not callable(answer):
            return Verdict("wrong", f"This should be a function of ({', '.join(self.parameters)}), not {answer!r}.")
        expected, _ = self._replay(self.right)
        got, error = self._replay(answer)
        first = next((i for i, both in enumerate(zip(got, expected, strict=False)) if not same(*both)), len(got))
        if first == len(expected):
            return Verdict("right", f"Right in all {len(expected)} steps of the tape." if first > 1 else "Right.")
        if is_unfinished(answer):
            return self._waits()
        where = f"Step {first + 1} of {len(expected)} is the first that differs."
        if first == len(got):
            where = f"In step {first + 1} of {len(expected)} your function stops with {error}."
            return Verdict("wrong", where, self._called(expected, first), hint=error_hint(error, self.parameters))
        rows = differences(expected[first], got[first])
        return Verdict("wrong", where, self._called(expected, first), rows, self._hint(got, first))

    def _waits(self) -> Verdict:
        return Verdict("waiting", f"This check waits for your answer: {self.task}.")

    def _replay(self, answer: Callable) -> tuple[list[dict], str]:
        """What `answer` makes of every step up to the one that it cannot do, and the error it made there."""
        memory, outcomes = copy.deepcopy(dict(self.memory)), []
        for step in self.tape:
            arguments = {**memory, **copy.deepcopy(dict(step))}
            try:
                value = answer(*[arguments[name] for name in self.parameters])
            except Exception as error:
                return outcomes, f"{type(error).__name__}: {error}"
            if self.returns in memory:
                memory[self.returns] = value
            outcomes.append(copy.deepcopy(memory | ({self.returns: value} if self.returns else {})))
        return outcomes, ""

    def _called(self, expected: list[dict], i: int) -> str:
        """The arguments of step `i` in words, but for functions and large arrays."""
        before = expected[i - 1] if i else self.memory
        known = {**before, **self.tape[i]}
        # a repr with an address says nothing to a learner
        told = [n for n in self.parameters if np.size(known[n]) <= 12 and " at 0x" not in repr(known[n])]
        return ", ".join(f"{n} = {show(known[n])}" for n in told)

    def _hint(self, got: list[dict], first: int) -> str:
        """The hint for the mistake that computes what the learner got, for as many steps as possible."""
        best, hint = first, ""
        if self.returns and got[first][self.returns] is None:
            hint = "your function returns nothing here. Does every way through it end with return?"
        for mistake in self.mistakes:
            theirs, _ = self._replay(mistake.answer)
            alike = next((i for i, (a, b) in enumerate(zip(theirs, got, strict=False)) if not same(a, b)), len(theirs))
            if alike > best:
                best, hint = alike, mistake.hint
        return hint


@dataclass(frozen=True)
class Question:
    """An exercise whose answer is a value: a number, a name, a tuple or an array.

    task: what is asked, for the message of a check that still waits; right: the value; mistakes: typical wrong ones
    because: why it is right, told to those who found it
    Numbers may be rounded: they count as equal when they differ by less than 0.2 %.
    """

    task: str
    right: Any
    mistakes: Sequence[Mistake]
    because: str = ""

    def __call__(self, answer: Any) -> Verdict:
        """Judge `answer`; never raises."""
        if answer is ... or answer is None:
            return Verdict("waiting", f"This check waits for your answer: {self.task}.")
        if same(answer, self.right, ROUNDED):
            return Verdict("right", f"Right. {self.because}".strip())
        hint = next((mistake.hint for mistake in self.mistakes if same(answer, mistake.answer, ROUNDED)), "")
        return Verdict("wrong", f"{show(answer)} is not it.", hint=hint)


def same(a: Any, b: Any, relative: float = 1e-9) -> bool:
    """Whether two values are equal, numbers up to a relative difference."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key], relative) for key in a)
    if isinstance(a, str) or isinstance(b, str) or a is None or b is None:
        return a is b or (isinstance(a, str) and isinstance(b, str) and a.strip().lower() == b.strip().lower())
    try:
        x, y = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    except (TypeError, ValueError):
        return bool(type(a) is type(b) and a == b)
    return x.shape == y.shape and np.allclose(x, y, rtol=relative, atol=1e-12, equal_nan=True)


def differences(expected: Mapping[str, Any], got: Mapping[str, Any]) -> tuple[tuple[str, str, str], ...]:
    """Name, expected and got of what differs; of arrays of the same shape, the entries that differ."""
    rows = []
    for name, right in expected.items():
        mine = got.get(name)
        if same(mine, right):
            continue
        if isinstance(right, np.ndarray) and isinstance(mine, np.ndarray) and right.shape == mine.shape:
            for index in np.argwhere(~np.isclose(right, mine, rtol=1e-9, atol=1e-12)):
                i = tuple(int(k) for k in index)
                rows.append((f"{name}[{', '.join(map(str, i))}]", show(right[i]), show(mine[i])))
        else:
            rows.append((name, show(right), show(mine)))
    more = ((f"and {len(rows) - SHOWN} more", "", ""),) if len(rows) > SHOWN else ()
    return tuple(rows[:SHOWN]) + more


def show(value: Any) -> str:
    """A value as a learner would write it, numbers with few digits; of a large array its shape."""
    if isinstance(value, np.ndarray) and value.size > 12:
        return f"array of shape {value.shape}"
    if isinstance(value, np.ndarray | list | tuple):
        return "[" + ", ".join(show(x) for x in value) + "]"
    if isinstance(value, bool | np.bool_ | int | np.integer | str) or value is None:
        return str(value)
    if isinstance(value, float | np.floating):
        return f"{value:.5g}"
    return repr(value)


def is_unfinished(answer: Callable) -> bool:
    """Whether a function still has the dots that an exercise begins with, or nothing at all in it."""
    code = getattr(answer, "__code__", None)
    if code is None:
        return False
    steps = {instruction.opname for instruction in dis.get_instructions(code)}
    does_nothing = steps <= {"RESUME", "LOAD_CONST", "RETURN_VALUE", "RETURN_CONST"}
    return ... in code.co_consts or (does_nothing and set(code.co_consts) <= {None, answer.__doc__})


def error_hint(error: str, parameters: Sequence[str]) -> str:
    """What may lie behind an exception."""
    if "positional argument" in error:
        return f"the function takes ({', '.join(parameters)}), in this order."
    if error.startswith("NameError"):
        return "this name is not known inside your function. Is it spelled as in the first line of the function?"
    if error.startswith("IndexError"):
        return "an index is too large: have the state and the action changed places? It is q[s, a]."
    return ""
