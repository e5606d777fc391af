"""Exercises: cases are tried on the learner's function, and typical mistakes are recognised by what they compute."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations
from typing import Any, ClassVar

import numpy as np

from rlrobot_grading.answers.limits import PATIENCE, Elsewhere, Failure, TooLong
from rlrobot_grading.answers.notebook import is_notebook, told_if_slow
from rlrobot_grading.answers.replay import Case, Outcome, cases_of, outcome_of
from rlrobot_grading.answers.source import (
    COURSES_OWN,
    edited,
    is_courses_own,
    is_unfinished,
    is_written_alike,
    parameters,
)
from rlrobot_grading.answers.values import (
    MOST_SHOWN,
    Function,
    differences,
    one_line,
    safely,
    show,
)
from rlrobot_grading.exercises.copying import work_on_a_copy
from rlrobot_grading.exercises.mistake import Mistake, hinted, offering_hints, with_ids
from rlrobot_grading.exercises.verdict import AS_GIVEN, Verdict
from rlrobot_grading.hints.detectors import find_hint
from rlrobot_grading.hints.errors import error_hint
from rlrobot_grading.hints.evidence import Evidence, Half, Hint, Known, Pair
from rlrobot_grading.hints.first_change import first_that_differs

# of the mistakes, the frequent ones first, that are also tried two at a time
MOST_PAIRED = 20
NOT_MENDED = "This is the code as it was given: one line of it is wrong."

Keep = Callable[["Exercise", Function], str]
Offer = Callable[["Exercise", Function], Any]


@dataclass(frozen=True)
class Exercise:
    """An exercise whose answer is a function; its texts are on its page, see `page`.

    right: the function as a learner should write it; its arguments without a default come in the tape
    tape: the steps or cases, each a mapping from the names of the arguments to their values
    task: what is to be written, for the message of a check that still waits: "write …"
    given: of an exercise to mend, the function with a wrong line that stands in its cell, and the hint for whoever
        has not changed it yet. None where the cell has dots
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
    keep: called in a notebook with this exercise and a right answer; returns a sentence for the verdict
    offer: called in a notebook with this exercise and a wrong answer; returns what is shown below the verdict, or None
    name: as a notebook calls it, in ``check.NAME``
    """

    # whether all right answers return the same, so that a wrong one tells what it does
    is_exact: ClassVar[bool] = True

    right: Function
    tape: Sequence[Case]
    task: str = ""
    given: Mistake | None = None
    mistakes: Mapping[str, Mistake] | Sequence[Mistake] = ()
    memory: Mapping[str, Any] = field(default_factory=dict)
    returns: str = ""
    library: Function | None = None
    lenders: Mapping[str, str] = field(default_factory=dict)
    hints: Sequence[str] = ()
    gained: str = ""
    another: Callable[[np.random.Generator, Case], Case] | None = None
    witnesses: Mapping[str, Sequence[Any]] = field(default_factory=dict)
    keep: Keep | None = None
    offer: Offer | None = None
    name: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "mistakes", with_ids(self.mistakes))
        # an edit that no longer fits its function is told here, not to a learner
        _ = self.wrong_functions

    def __call__(self, answer: Any) -> Verdict:
        """Judge `answer`, and in a notebook keep it if it is right; never raises."""
        if not is_notebook():
            return self.judge(answer)
        if safely(False, is_courses_own, answer, self.right):
            return Verdict("wrong", COURSES_OWN, id="courses_own")
        with told_if_slow(
            f"Your function is tried in {len(self.tape)} {self._unit}s …"
        ):
            verdict = self.judge(answer)
        if not verdict:
            verdict = offering_hints(verdict, self.name, self.hints)
            is_offered = verdict.status == "wrong" and verdict.id != AS_GIVEN
            if not is_offered or self.offer is None or not callable(answer):
                return verdict
            return replace(verdict, below=safely(None, self.offer, self, answer))
        if self.keep is None:
            return verdict
        told = self.keep(self, answer)
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
        if self.given and safely(False, is_written_alike, answer, self.given.wrong):
            return Verdict("wrong", NOT_MENDED, hint=self.given.hint, id=AS_GIVEN)
        expected = self.expected  # what is compiled now is not the learner's time
        got = self.outcomes(answer)
        pairs = enumerate(zip(got, expected, strict=False))
        wrong = [i for i, (mine, right) in pairs if not right.equals(mine)]
        if not wrong:
            n = len(self.tape)
            told = f"Right in all {n} {self._unit}s." if n > 1 else "Right."
            return Verdict("right", told, gained=self.gained)
        if safely(False, is_unfinished, answer):
            return self._waits()
        return self._wrong(answer, got, wrong[0], len(wrong))

    def share(self, answer: Function) -> float:
        """The part of the cases in which `answer` does what is right; 0 for what was given and is not mended."""
        got = self.outcomes(answer)
        if self.given:
            unchanged = self.outcomes(self.given.wrong)
            alike = zip(unchanged, got, strict=False)
            if all(was.equals(mine) for was, mine in alike):
                return 0.0
        pairs = zip(got, self.expected, strict=False)
        return sum(right.equals(mine) for mine, right in pairs) / len(self.tape)

    def hint(self, number: int = 1) -> Verdict:
        """One of the three hints: 1 the idea, 2 the line, 3 almost the code."""
        return hinted(self.hints, number)

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Names of the arguments, in their order."""
        return parameters(self.right)

    @cached_property
    def wrong_functions(self) -> tuple[Function, ...]:
        """The function of each mistake."""
        wrong = [mistake.wrong for mistake in self.mistakes]
        return tuple(
            change if callable(change) else edited(self.right, change)
            for change in wrong
        )

    @property
    def _unit(self) -> str:
        if "env" in self.parameters:
            return "run"
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
    def _tried(self) -> dict[tuple[Function, int], Outcome]:
        """What came of a mistake in a case, as far as anybody has asked."""
        return {}

    def mistaken(self, function: Function, i: int, endless: bool = False) -> Outcome:
        """What comes of a mistake in case `i`; it is tried once, when first asked for."""
        if (function, i) not in self._tried:
            self._tried[function, i] = self.outcome(function, self.cases[i], endless)
        return self._tried[function, i]

    @cached_property
    def _known(self) -> list[Known]:
        """Each mistake's function, and the hint for it."""
        hints = [Hint(mistake.id, mistake.hint) for mistake in self.mistakes]
        return list(zip(hints, self.wrong_functions, strict=True))

    @cached_property
    def _pairs(self) -> list[Pair]:
        """The functions that make two mistakes at once, each with its hint."""
        frequent = list(zip(self.mistakes, self.wrong_functions, strict=True))
        edits = [
            (mistake.id, Half(mistake.hint, function, mistake.wrong))
            for mistake, function in frequent[:MOST_PAIRED]
            if not callable(mistake.wrong)
        ]
        pairs = []
        for (first, one), (second, other) in combinations(edits, 2):
            if one.edits.keys() & other.edits.keys():
                continue
            both = safely(None, edited, self.right, {**one.edits, **other.edits})
            if both is not None:
                told = f"two things at once. First, {one.text} Second, {other.text}"
                pairs.append(Pair(Hint(f"{first}+{second}", told), both, (one, other)))
        return pairs

    def _waits(self) -> Verdict:
        return Verdict("waiting", f"This check waits for your answer: {self.task}.")

    def outcomes(self, answer: Function) -> list[Outcome]:
        """What `answer` does in every case; a function that does not end is tried no further."""
        outcomes: list[Outcome] = []
        begun = time.perf_counter()
        for case in self.cases:
            outcome = self.outcome(answer, case)
            waited = time.perf_counter() - begun
            is_slow = waited > PATIENCE and not isinstance(answer, Elsewhere)
            if is_slow and not outcome.failure:
                told = f"has taken {waited:.0f} seconds for the {self._unit}s so far"
                failure = Failure(TooLong.__name__, told)
                outcome = replace(outcome, failure=failure)
            outcomes.append(outcome)
            if outcome.failure and outcome.failure.kind == TooLong.__name__:
                break
        return outcomes

    def outcome(self, answer: Function, case: Case, endless: bool = False) -> Outcome:
        """What `answer` does in a case; endless: whether it may take as long as it likes."""
        return outcome_of(
            answer, case, self.parameters, tuple(self.memory), self.returns, endless
        )

    def _wrong(
        self,
        answer: Function,
        got: Sequence[Outcome],
        first: int,
        n_wrong: int,
    ) -> Verdict:
        """The verdict on a wrong answer, which differs first in case `first`."""
        mine, right, n = got[first], self.expected[first], len(self.tape)
        called = self._called(self.cases[first])
        here = f"{self._unit} {first + 1} of {n}"
        if mine.failure:
            text = one_line(f"In {here} your function {mine.failure.ends}.", 400)
            hint = error_hint(mine.failure, answer, self.right, self.lenders)
            return Verdict("wrong", text, called, hint=hint, id="exception")
        rows = differences(right.values, mine.values)
        if not rows:
            names = " and ".join(mine.spoilt)
            told = f"The result is right, but in {here} your function changes {names}, which it should only read."
            name = mine.spoilt[0]
            hint = work_on_a_copy(name, self.cases[first].get(name))
            return Verdict("wrong", told, called, hint=hint, id="spoilt")
        where = f"{here.capitalize()} is the first that differs."
        if 1 < n_wrong < n:
            where = f"{here.capitalize()} is the first of {n_wrong} that differ."
        seen = self.evidence(answer, got)
        what, first_rows = first_that_differs(seen)
        if what:
            rows = first_rows
            where += f" The table has {what}."
        if mine.printed:
            rows += (("printed", "", show(mine.printed)),)
        id, told = self.hint_on(seen)
        if mine.spoilt and not told:
            name = mine.spoilt[0]
            remedy = work_on_a_copy(name, self.cases[first].get(name))
            told = f"{name} changes, and it should only be read: {remedy}"
            id = "spoilt"
        return Verdict("wrong", where, called, rows, told, id=id)

    def _called(self, case: Case) -> str:
        """The arguments of a case in words, but for functions and large arrays."""
        # a repr with an address says nothing to a learner
        told = [
            n
            for n in self.parameters
            if safely(0, np.size, case[n]) <= MOST_SHOWN
            and not callable(case[n])
            and " at 0x" not in repr(case[n])
        ]
        return ", ".join(f"{n} = {show(case[n])}" for n in told)

    def hint_on(self, seen: Evidence) -> Hint:
        """The hint for a wrong answer; empty where no detector knows one."""
        return find_hint(seen)

    def evidence(self, answer: Function, got: Sequence[Outcome]) -> Evidence:
        """What the detectors are given of a wrong answer."""
        return Evidence(
            answer=answer,
            right=self.right,
            parameters=self.parameters,
            cases=self.cases,
            expected=self.expected,
            got=got,
            outcome=self.outcome,
            mistaken=self.mistaken,
            mistakes=self._known,
            pairs=lambda: self._pairs,
            memory=self.memory,
            returns=self.returns,
            lenders=self.lenders,
            is_exact=self.is_exact,
        )
