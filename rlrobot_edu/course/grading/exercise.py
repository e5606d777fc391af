"""Exercises: a tape is replayed on the learner's answer, and typical mistakes are recognised by what they compute."""

from __future__ import annotations

import copy
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.source import edited, is_unfinished, parameters
from rlrobot_edu.course.grading.values import differences, first_difference, kept, one_line, safely, same, show
from rlrobot_edu.course.grading.verdict import Verdict

ROUNDED = 2e-3  # how far a number given as an answer may be off


@dataclass(frozen=True)
class Mistake:
    """A typical wrong answer, and the hint for whoever gives it.

    wrong: of a `Question` the wrong value; of an `Exercise` what is written differently from the right function, as in
        ``{"max(q[s_next])": "q[s_next].mean()"}`` (see `edited`)
    """

    hint: str
    wrong: Any


@dataclass(frozen=True)
class Exercise:
    """An exercise whose answer is a function.

    task: what is to be written, for the message of a check that still waits: "write …"
    right: the function as a learner should write it; its arguments without a default come in the tape
    tape: the steps, each a mapping from the names of the arguments to their values
    mistakes: the wrong answers that are recognised, each an edit of `right`
    memory: arguments that last from step to step, as Q does; the function may change arrays among them in place
    returns: what the returned value is called; if it is a name in `memory`, that takes the value. Empty for a function
        that only changes its arguments: then whatever it returns is ignored
    library: the library's function that does the same, if there is one: then it says what is expected, not `right`
    """

    task: str
    right: Callable[..., Any]
    tape: Sequence[Mapping[str, Any]]
    mistakes: Sequence[Mistake]
    memory: Mapping[str, Any] = field(default_factory=dict)
    returns: str = ""
    library: Callable[..., Any] | None = None

    def __post_init__(self) -> None:
        _ = self.wrong_functions  # an edit that no longer fits its function is told here, not to a learner

    def __call__(self, answer: Any) -> Verdict:
        """Judge `answer`; never raises."""
        if answer is ... or answer is None:
            return self._waits()
        if not callable(answer):
            return Verdict("wrong", f"This should be a function of ({', '.join(self.parameters)}), not {show(answer)}.")
        expected = self._expected
        got, error = self._replay(answer)
        first = first_difference(got, expected)
        if first == len(self.tape):
            return Verdict("right", f"Right in all {len(expected)} steps of the tape." if first > 1 else "Right.")
        if safely(False, is_unfinished, answer):
            return self._waits()
        where = f"Step {first + 1} of {len(expected)} is the first that differs."
        if first == len(got):
            where = f"In step {first + 1} of {len(expected)} your function stops with {error}."
            return Verdict("wrong", where, self._called(expected, first), hint=error_hint(error, self.parameters))
        rows = differences(expected[first], got[first])
        return Verdict("wrong", where, self._called(expected, first), rows, self._hint(got, first))

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Names of the arguments, in their order."""
        return parameters(self.right)

    @cached_property
    def wrong_functions(self) -> tuple[Callable[..., Any], ...]:
        """The function of each mistake."""
        return tuple(edited(self.right, mistake.wrong) for mistake in self.mistakes)

    @cached_property
    def _expected(self) -> list[dict[str, Any]]:
        return self._replay(self.library or self.right)[0]

    @cached_property
    def _mistaken(self) -> list[list[dict[str, Any]]]:
        """What comes of each mistake."""
        with np.errstate(all="ignore"):  # some overflow
            return [self._replay(function)[0] for function in self.wrong_functions]

    def _waits(self) -> Verdict:
        return Verdict("waiting", f"This check waits for your answer: {self.task}.")

    def _replay(self, answer: Callable[..., Any]) -> tuple[list[dict[str, Any]], str]:
        """What `answer` makes of every step up to the one that it cannot do, and the error it made there."""
        memory = copy.deepcopy(dict(self.memory))
        outcomes: list[dict[str, Any]] = []
        for step in self.tape:
            arguments = {**memory, **copy.deepcopy(dict(step))}
            value, error = attempt(answer, *[arguments[name] for name in self.parameters])
            if error:
                return outcomes, error
            if self.returns in memory:
                memory[self.returns] = value
            outcome = memory | ({self.returns: value} if self.returns else {})
            outcomes.append({name: kept(thing) for name, thing in outcome.items()})
        return outcomes, ""

    def _called(self, expected: Sequence[Mapping[str, Any]], i: int) -> str:
        """The arguments of step `i` in words, but for functions and large arrays."""
        before = expected[i - 1] if i else self.memory
        known = {**before, **self.tape[i]}
        # a repr with an address says nothing to a learner
        told = [n for n in self.parameters if np.size(known[n]) <= 12 and " at 0x" not in repr(known[n])]
        return ", ".join(f"{n} = {show(known[n])}" for n in told)

    def _hint(self, got: Sequence[Mapping[str, Any]], first: int) -> str:
        """The hint for the mistake that computes what the learner got, for as many steps as possible."""
        longest, hint = first, ""
        if self.returns and got[first][self.returns] is None:
            hint = "your function returns nothing here. Does every way through it end with return?"
        for mistake, theirs in zip(self.mistakes, self._mistaken, strict=True):
            alike = first_difference(theirs, got)
            if alike > longest:
                longest, hint = alike, mistake.hint
        return hint


@dataclass(frozen=True)
class Question:
    """An exercise whose answer is a value: a number, a name, a tuple or an array.

    task: what is asked, for the message of a check that still waits; right: the value; mistakes: typical wrong ones
    because: why it is right, told to those who gave it
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
        hint = next((mistake.hint for mistake in self.mistakes if same(answer, mistake.wrong, ROUNDED)), "")
        return Verdict("wrong", f"{show(answer)} is not it.", hint=hint)


def attempt(answer: Callable[..., Any], *arguments: Any) -> tuple[Any, str]:
    """What a learner's function returns, and what it raises, in words; empty where it raises nothing.

    SystemExit is told as well, for ``exit()`` must not end the notebook. KeyboardInterrupt is the reader's and passes.
    """
    try:
        with exits_raised():
            return answer(*arguments), ""
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        return None, one_line(safely("", _told, error) or "an error that cannot be shown")


@contextmanager
def exits_raised() -> Iterator[None]:
    """In a notebook exit() raises nothing, but has the kernel end a little later. Here it raises, as in a program."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    if shell is None:
        yield
        return
    shell.ask_exit = sys.exit  # hides the method of this name
    try:
        yield
    finally:
        del shell.ask_exit


def _told(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}".removesuffix(": ")


def error_hint(error: str, parameters: Sequence[str]) -> str:
    """What may lie behind an exception."""
    if "positional argument" in error:
        return f"the function takes ({', '.join(parameters)}), in this order."
    if error.startswith("NameError"):
        return "this name is not known inside your function. Is it spelled as in the first line of the function?"
    if error.startswith("IndexError"):
        return "an index is too large: have the state and the action changed places? It is q[s, a]."
    if error.startswith("SystemExit"):
        return "exit() and quit() end the whole program. Leave a function with return."
    if error.startswith("RecursionError"):
        return "your function calls itself again and again, and nothing ends it."
    return ""
