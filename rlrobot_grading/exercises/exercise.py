"""Exercises: cases are tried on the learner's function, and typical mistakes are recognised by what they compute."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from rlrobot_course.learner.my_functions import is_notebook, keep
from rlrobot_grading.answers.limits import PATIENCE, Elsewhere, Failure, TooLong
from rlrobot_grading.answers.replay import Case, Outcome, cases_of, outcome_of
from rlrobot_grading.answers.source import (
    COURSES_OWN,
    edited,
    is_courses_own,
    is_unfinished,
    parameters,
)
from rlrobot_grading.answers.values import (
    MOST_SHOWN,
    differences,
    one_line,
    safely,
    show,
)
from rlrobot_grading.exercises.mistake import Mistake, hinted, with_ids
from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.hints.detectors import find_hint
from rlrobot_grading.hints.errors import error_hint
from rlrobot_grading.hints.evidence import Evidence, Hint

MOST_PAIRED = (
    20  # of the mistakes, the frequent ones first, that are also tried two at a time
)
COPY = "work on a copy, as in {0} = {0}.copy(); or write x = x - y, a new array, where x -= y changes the old one."


@dataclass(frozen=True)
class Exercise:
    """An exercise whose answer is a function; its texts are on its page, see `page`.

    right: the function as a learner should write it; its arguments without a default come in the tape
    tape: the steps or cases, each a mapping from the names of the arguments to their values
    task: what is to be written, for the message of a check that still waits: "write …"
    mistakes: the wrong answers that are recognised, by their ids; each an edit of `right`, or a wrong function
    memory: arguments that last from step to step, as Q does; the function may change arrays among them in place. All
        others it should only read
    returns: what the returned value is called; if it is a name in `memory`, that takes the value. Empty for a function
        that only changes its arguments: then whatever it returns is ignored
    library: the library's function that does the same, if there is one: then it says what is expected, not `right`
    lenders: functions of earlier lessons that the answer may call, and where to have them: {name: "in lesson 04 …"}
    hints: three, told on request: the idea, the line, almost the code
    gained: what has been gained with a right answer, and where it will be used
    another: draws a case like the given one, for the secret tapes of homework; where it is missing, numbers with a
        fraction change
    witnesses: by id, wrong answers as learners write them that must be recognised so
    """

    right: Callable[..., Any]
    tape: Sequence[Case]
    task: str = ""
    mistakes: Mapping[str, Mistake] | Sequence[Mistake] = ()
    memory: Mapping[str, Any] = field(default_factory=dict)
    returns: str = ""
    library: Callable[..., Any] | None = None
    lenders: Mapping[str, str] = field(default_factory=dict)
    hints: Sequence[str] = ()
    gained: str = ""
    another: Callable[[np.random.Generator, Case], Case] | None = None
    witnesses: Mapping[str, Sequence[Any]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "mistakes", with_ids(self.mistakes))
        _ = (
            self.wrong_functions
        )  # an edit that no longer fits its function is told here, not to a learner

    def __call__(self, answer: Any) -> Verdict:
        """Judge `answer`, and keep it for later lessons if it is right; never raises."""
        if is_notebook() and safely(False, is_courses_own, answer, self.right):
            return Verdict("wrong", COURSES_OWN, id="courses_own")
        verdict = self.judge(answer)
        lesson = re.search(r"lesson_(\w+)", self.right.__module__)
        if not (verdict and lesson and is_notebook()):
            return verdict
        told = safely(
            "(Not kept for later lessons.)",
            keep,
            answer,
            lesson[1],
            self.right.__name__,
            self.judge,
        )
        return replace(verdict, gained=f"{verdict.gained} {told}".strip())

    def judge(self, answer: Any) -> Verdict:
        """Judge `answer`; never raises."""
        if answer is ... or answer is None:
            return self._waits()
        if not callable(answer):
            return Verdict(
                "wrong",
                f"This should be a function of ({', '.join(self.parameters)}), not {show(answer)}.",
            )
        expected = (
            self.expected
        )  # first: what is compiled meanwhile is not the learner's time
        got = self.outcomes(answer)
        wrong = [
            i
            for i, (mine, right) in enumerate(zip(got, expected, strict=False))
            if not right.equals(mine)
        ]
        if not wrong:
            how_often = (
                f"Right in all {len(self.tape)} {self._unit}s."
                if len(self.tape) > 1
                else "Right."
            )
            return Verdict("right", how_often, gained=self.gained)
        if safely(False, is_unfinished, answer):
            return self._waits()
        return self._wrong(answer, got, wrong[0], len(wrong))

    def share(self, answer: Callable[..., Any]) -> float:
        """The part of the cases in which `answer` does what is right."""
        pairs = zip(self.outcomes(answer), self.expected, strict=False)
        return sum(right.equals(mine) for mine, right in pairs) / len(self.tape)

    def hint(self, number: int = 1) -> Verdict:
        """One of the three hints: 1 the idea, 2 the line, 3 almost the code."""
        return hinted(self.hints, number)

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Names of the arguments, in their order."""
        return parameters(self.right)

    @cached_property
    def wrong_functions(self) -> tuple[Callable[..., Any], ...]:
        """The function of each mistake."""
        wrong = [mistake.wrong for mistake in self.mistakes]
        return tuple(
            change if callable(change) else edited(self.right, change)
            for change in wrong
        )

    @property
    def is_exact(self) -> bool:
        """Whether all right answers return the same, so that a wrong one tells what it does."""
        return True

    @property
    def tables(self) -> list[str]:
        """The tables in memory, if that holds nothing else than these and numbers: a world makes one mistake many."""
        tables = [
            name for name, thing in self.memory.items() if isinstance(thing, np.ndarray)
        ]
        numbers = [
            name
            for name, thing in self.memory.items()
            if isinstance(thing, int | float)
        ]
        return tables if len(tables) + len(numbers) == len(self.memory) else []

    @property
    def _unit(self) -> str:
        return "step" if self.memory else "case"

    @cached_property
    def cases(self) -> list[Case]:
        """The steps of the tape, each with the memory as the right function has left it."""
        return cases_of(
            self.right, self.tape, self.memory, self.returns, self.parameters
        )

    @cached_property
    def expected(self) -> list[Outcome]:
        """What the right function does in each case."""
        right = self.library or self.right
        return [self.outcome(right, case, endless=True) for case in self.cases]

    @cached_property
    def _tried(self) -> dict[tuple[Callable[..., Any], int], Outcome]:
        """What came of a mistake in a case, as far as anybody has asked."""
        return {}

    def mistaken(
        self, function: Callable[..., Any], i: int, endless: bool = False
    ) -> Outcome:
        """What comes of a mistake in case `i`; it is tried once, when first asked for."""
        if (function, i) not in self._tried:
            self._tried[function, i] = self.outcome(function, self.cases[i], endless)
        return self._tried[function, i]

    @cached_property
    def pairs(self) -> list[tuple[Mistake, Mistake, Callable[..., Any]]]:
        """Two mistakes, and the function that makes both at once."""
        pairs = []
        frequent = [
            mistake
            for mistake in self.mistakes[:MOST_PAIRED]
            if not callable(mistake.wrong)
        ]
        for one, other in combinations(frequent, 2):
            both = safely(None, edited, self.right, {**one.wrong, **other.wrong})
            if both is not None and not one.wrong.keys() & other.wrong.keys():
                pairs.append((one, other, both))
        return pairs

    def _waits(self) -> Verdict:
        return Verdict("waiting", f"This check waits for your answer: {self.task}.")

    def outcomes(self, answer: Callable[..., Any]) -> list[Outcome]:
        """What `answer` does in every case; a function that does not end is tried no further."""
        outcomes, begun = [], time.perf_counter()
        for case in self.cases:
            outcomes.append(self.outcome(answer, case))
            waited = time.perf_counter() - begun
            if (
                waited > PATIENCE
                and not isinstance(answer, Elsewhere)
                and not outcomes[-1].failure
            ):
                slow = Failure(
                    TooLong.__name__,
                    f"has taken {waited:.0f} seconds for the {self._unit}s so far",
                )
                outcomes[-1] = replace(outcomes[-1], failure=slow)
            if (failure := outcomes[-1].failure) and failure.kind == TooLong.__name__:
                break
        return outcomes

    def outcome(
        self, answer: Callable[..., Any], case: Case, endless: bool = False
    ) -> Outcome:
        """What `answer` does in a case; endless: whether it may take as long as it likes."""
        return outcome_of(
            answer, case, self.parameters, tuple(self.memory), self.returns, endless
        )

    def _wrong(
        self,
        answer: Callable[..., Any],
        got: Sequence[Outcome],
        first: int,
        n_wrong: int,
    ) -> Verdict:
        """The verdict on a wrong answer, which differs first in case `first`."""
        mine, right, n = got[first], self.expected[first], len(self.tape)
        called = self._called(self.cases[first])
        here = f"{self._unit} {first + 1} of {n}"
        if mine.failure:
            line = f", in the line “{mine.failure.line}”" if mine.failure.line else ""
            ends = f"{'' if mine.failure.kind == TooLong.__name__ else 'stops with '}{mine.failure.text}{line}"
            told = error_hint(mine.failure, answer, self.right, self.lenders)
            return Verdict(
                "wrong",
                one_line(f"In {here} your function {ends}.", 400),
                called,
                hint=told,
                id="exception",
            )
        rows = differences(right.values, mine.values)
        if not rows:
            names = " and ".join(mine.spoilt)
            told = f"The result is right, but in {here} your function changes {names}, which it should only read."
            return Verdict(
                "wrong", told, called, hint=COPY.format(mine.spoilt[0]), id="spoilt"
            )
        where = f"{here.capitalize()} is the first that differs."
        if 1 < n_wrong < n:
            where = f"{here.capitalize()} is the first of {n_wrong} that differ."
        if mine.printed:
            rows += (("printed", "", show(mine.printed)),)
        hint = self.hint_on(answer, got)
        if mine.spoilt and not hint.text:
            hint = Hint(
                "spoilt",
                ("{0} changes, and it should only be read: " + COPY).format(
                    *mine.spoilt
                ),
            )
        return Verdict("wrong", where, called, rows, hint.text, id=hint.id)

    def _called(self, case: Case) -> str:
        """The arguments of a case in words, but for functions and large arrays."""
        # a repr with an address says nothing to a learner
        told = [
            n
            for n in self.parameters
            if safely(0, np.size, case[n]) <= MOST_SHOWN
            and " at 0x" not in repr(case[n])
        ]
        return ", ".join(f"{n} = {show(case[n])}" for n in told)

    def hint_on(self, answer: Callable[..., Any], got: Sequence[Outcome]) -> Hint:
        """The hint for a wrong answer that has done this in the cases; empty where no detector knows one."""
        return find_hint(Evidence(self, answer, got))
