"""Questions: exercises whose answer is a value."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any

import numpy as np

from rlrobot_grading.answers.values import (
    MOST_SIGNS,
    as_data,
    is_large,
    safely,
    same,
    show,
)
from rlrobot_grading.exercises.mistake import (
    FIRST_STEP,
    Mistake,
    hinted,
    hints_are_off,
    offering_hints,
    with_ids,
)
from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.hints.evidence import Hint
from rlrobot_grading.hints.formula import Formula
from rlrobot_grading.hints.suspicions import unlike

ROUNDED = 5e-4  # how far a number given as an answer may be off, as a part of it
DIGITS = 3  # to which an answer may be rounded, unless that makes a known mistake of it
COMMA = "a point, not a comma, stands before the digits of a fraction: 0.5, not 0,5."
FURTHER = 0.05  # how far rounding may take it, before it is another number


@dataclass(frozen=True)
class Question:
    """An exercise whose answer is a value: a number, a name, several letters, a tuple or an array.

    right: the value; task: what is asked, for the message of a check that still waits; mistakes: typical wrong ones
    because: why it is right, told to those who gave it
    first_step: of the way to a number, in words: the hint for a wrong one for which there is no other
    hints: three, told on request: the idea, the line, almost the answer
    gained: what a right answer is good for
    witnesses: by id, wrong answers that must be recognised so
    name: as a notebook calls it, in ``check.NAME``
    formula: given as `right`, it makes the value, and tells of a wrong number by which change of it that comes about
    Numbers may be rounded to three digits, as lessons print them, unless that is a known mistake. Letters may
    come in any order, as text or as a list.
    """

    right: Any
    task: str = ""
    mistakes: Mapping[str, Mistake] | Sequence[Mistake] = ()
    because: str = ""
    first_step: str = ""
    hints: Sequence[str] = ()
    gained: str = ""
    witnesses: Mapping[str, Sequence[Any]] = field(default_factory=dict)
    formula: Formula | None = None
    name: str = ""

    def __post_init__(self) -> None:
        if isinstance(self.right, Formula):
            object.__setattr__(self, "formula", self.right)
            object.__setattr__(self, "right", self.right.value)
        object.__setattr__(self, "mistakes", with_ids(self.mistakes))

    def __call__(self, answer: Any, *more: Any) -> Verdict:
        """Judge `answer`; never raises."""
        return offering_hints(self._judged(answer, *more), self.name, self.hints)

    def _judged(self, answer: Any, *more: Any) -> Verdict:
        if more and self._has_comma((answer, *more)):
            return Verdict("wrong", "These are two numbers.", hint=COMMA, id="form")
        if more:
            told = f"one tuple is asked, in brackets of its own: (({', '.join(map(show, (answer, *more)))}))."
            return Verdict(
                "wrong", f"These are {1 + len(more)} answers.", hint=told, id="form"
            )
        if answer is ... or answer is None:
            told = f"This check waits for your answer: {self.task}.{self._form}"
            return Verdict("waiting", told)
        answer = as_data(answer)
        if self.equals(answer, self.right):
            return self._right()
        for mistake in self.mistakes:
            if self.equals(answer, mistake.wrong):
                return Verdict(
                    "wrong",
                    f"{show(answer)} is not it.",
                    hint=mistake.hint,
                    id=mistake.id,
                )
        if safely(False, _is_rounded, answer, self.right):
            return self._right()
        found = self.found(answer)
        return Verdict(
            "wrong", f"{show(answer)} is not it.", hint=found.text, id=found.id
        )

    @property
    def _form(self) -> str:
        """How an answer is written, where that is not clear: Python would stop before it comes to the check."""
        if isinstance(self.right, str):
            return " Text stands in quotation marks."
        if np.ndim(self.right) == 0:
            return " A calculation will do; 0.8² is 0.8 ** 2."
        return ""

    def _right(self) -> Verdict:
        return Verdict("right", f"Right. {self.because}".strip(), gained=self.gained)

    def found(self, answer: Any) -> Hint:
        """The hint that nobody had to write for a wrong answer, if there is one."""
        told = safely("", self._looked_at, answer)
        if told:
            return Hint("form", told)
        is_number = not (
            safely(True, is_large, answer)
            or isinstance(answer, str | bool)
            or isinstance(self.right, str)
        )
        if self.formula and is_number:
            # it is computed as often as there are changes
            told = safely("", self.formula.told, answer, ROUNDED)
            if told:
                return Hint("formula", told)
        if self.first_step and not hints_are_off():
            return Hint(FIRST_STEP, self.first_step)
        return Hint("", "")

    def hint(self, number: int = 1) -> Verdict:
        """One of the three hints: 1 the idea, 2 the line, 3 almost the answer."""
        return hinted(self.hints, number)

    @property
    def _has_letters(self) -> bool:
        return (
            isinstance(self.right, str) and len(self.right) > 1 and self.right.isupper()
        )

    def equals(self, answer: Any, value: Any) -> bool:
        """Whether an answer counts as this value."""
        if self._has_letters:
            letters = safely("", _letters, answer)
            return bool(letters) and letters == _letters(value)
        return same(answer, value, ROUNDED)

    def _looked_at(self, answer: Any) -> str:
        """What is wrong with the form of a value that may be right."""
        if is_large(answer):
            return ""
        if self._has_letters and safely("", _letters, answer):
            return ""
        if self._has_letters:
            return "write the letters as text, in quotation marks."
        if isinstance(self.right, str):
            return self._word_looked_at(answer)
        if isinstance(answer, str) and same(_read(answer), self.right, ROUNDED):
            return "the right number, but as text: leave out the quotation marks."
        if self._has_comma(answer):
            return COMMA
        told = unlike(self.right, answer)
        if told:
            return told
        if isinstance(answer, bool):
            return "True and False are no numbers."
        right, mine = (
            np.asarray(self.right, dtype=float),
            np.asarray(answer, dtype=float),
        )
        digits = safely([], _digits, mine, right)
        if digits and all(
            same(round(m, n), m) and same(round(r, n), m) for m, r, n in digits
        ):
            return "nearly: this is rounded too far. Give a digit or two more, or the formula itself."
        if same(-right, mine, ROUNDED):
            return "the sign is the wrong way round."
        if same(100 * right, mine, ROUNDED):
            return "this is 100 times as much: is it in per cent, or in centimetres?"
        return ""

    def _has_comma(self, answer: Any) -> bool:
        """Whether one number is asked, and two whole ones are given, as 0,5 is read."""
        return (
            not isinstance(self.right, str)
            and np.ndim(self.right) == 0
            and isinstance(answer, list | tuple)
            and [type(part) for part in answer] == [int, int]
        )

    def _word_looked_at(self, answer: Any) -> str:
        """What is wrong with the form of an answer that should be a word."""
        if isinstance(answer, list | tuple | set) and len(answer) == 1:
            return "take the word out of its brackets: text in quotation marks, and nothing else."
        if not isinstance(answer, str):
            return "the answer is a word: write it as text, in quotation marks."
        if len(answer.split()) > 1:
            return "asked is one word alone, written as in the text above."
        words = [self.right, *(mistake.wrong for mistake in self.mistakes)]
        if get_close_matches(answer.lower(), words, 1, 0.75):
            return "is it spelled as in the text above?"
        return ""


def _digits(mine: np.ndarray, right: np.ndarray) -> list[tuple[float, float, int]]:
    """Each number, the right one, and how many digits after the point the learner has written; nothing for afar."""
    near = np.abs(mine - right) <= FURTHER * np.maximum(np.abs(right), 1e-12)
    if not near.all():
        raise ValueError("these are other numbers")
    fractions = (
        len(repr(float(m)).partition(".")[2].rstrip("0")) for m in np.ravel(mine)
    )
    return list(
        zip(np.ravel(mine).tolist(), np.ravel(right).tolist(), fractions, strict=True)
    )


def _is_rounded(answer: Any, right: Any) -> bool:
    """Whether each number is the right one up to half a unit of its third digit; whole numbers are not rounded."""
    if is_large(answer) or unlike(right, answer):
        return False
    mine, exact = np.asarray(answer), np.asarray(right)
    if (
        exact.dtype.kind != "f"
        or mine.dtype.kind not in "if"
        or mine.shape != exact.shape
    ):
        return False
    unit = 10.0 ** (np.floor(np.log10(np.abs(exact))) - DIGITS + 1)
    return bool((np.abs(mine - exact) <= 0.5001 * unit).all())


def _read(text: str) -> float:
    return safely(float("nan"), float, text.strip().replace(",", "."))


def _letters(value: Any) -> str:
    """The letters of an answer in their order: of "C, a", ["A", "C"] and {"A", "C"} it is AC."""
    # of these it is sure that they end
    if type(value) in (list, tuple, set, frozenset) and not is_large(value):
        value = "".join(value)
    if not isinstance(value, str) or len(value) > MOST_SIGNS:
        return ""
    letters = re.sub(r"[\s,;+&'\"]|and", "", value).upper()
    return "".join(sorted(set(letters))) if letters.isalpha() else ""
