"""Typical wrong answers, and the three hints of an exercise."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from rlrobot_grading.answers.notebook import is_notebook
from rlrobot_grading.exercises.verdict import AS_GIVEN, Verdict

FIRST_STEP = "first_step"  # the id of a hint that fits every wrong answer


@dataclass(frozen=True)
class Mistake:
    """A typical wrong answer, and the hint for whoever gives it.

    wrong: of a `Question` the wrong value; of an `Exercise` what is written differently from the right function, as in
        ``{"max(q[s_next])": "q[s_next].mean()"}`` (see `edited`), or the wrong function where whole lines change
    id: what it is called where its verdict is compared, as ``past_the_end``; exercises set it from their mapping
    """

    hint: str
    wrong: Any
    id: str = ""


def with_ids(mistakes: Mapping[str, Mistake] | Sequence[Mistake]) -> list[Mistake]:
    """The mistakes of an exercise, each with the id under which it stands; a copy of an exercise has them already."""
    if isinstance(mistakes, Mapping):
        return [replace(mistake, id=name) for name, mistake in mistakes.items()]
    return list(mistakes)


def wrong_choices(
    right: list[int], options: Iterable[int], clues: Sequence[str], shown: Mistake
) -> dict[str, Mistake]:
    """All wrong answers to a question with a list of choices; the hint is the clue of the first choice that is wrong.

    shown: the answer that the notebook shows as an example
    """
    tried = map(list, product(options, repeat=len(right)))
    wrong = [choices for choices in tried if choices not in (right, shown.wrong)]
    first = [
        next(i for i, choice in enumerate(choices) if choice != right[i])
        for choices in wrong
    ]
    told = {
        "_".join(map(str, one)): Mistake(clues[i], one)
        for one, i in zip(wrong, first, strict=True)
    }
    return {"as_shown": shown, **told}


def hints_are_off() -> bool:
    """Whether no hint is told on request, as in a homework that has none."""
    return os.environ.get("RLROBOT_EDU_HINTS") == "0"


def offering_hints(verdict: Verdict, name: str, hints: Sequence[str]) -> Verdict:
    """The verdict; in a notebook that on a wrong answer whose cause is not known says where there are hints.

    name: of the exercise, as in ``check.NAME``; hints: what `hinted` is given
    """
    is_known = verdict.hint and verdict.id not in (FIRST_STEP, AS_GIVEN)
    if verdict.status != "wrong" or is_known or hints_are_off():
        return verdict
    if not (name and hints and is_notebook()):
        return verdict
    told = f"If you are stuck, write check.{name}.hint() in a new cell."
    return replace(verdict, text=f"{verdict.text} {told}")


def hinted(hints: Sequence[str], number: int) -> Verdict:
    """The hint of this number, from 1 on, and how to have the next; in homework there may be fewer, or none."""
    told = os.environ.get("RLROBOT_EDU_HINTS", "")
    if told.isdecimal() and int(told) < len(hints):
        if number > int(told):
            return Verdict(
                "hint", f"Hints told in this homework: {int(told)} of {len(hints)}."
            )
        hints = hints[: int(told)]
    if not 1 <= number <= len(hints):
        return Verdict(
            "hint",
            f"There are {len(hints)} hints: hint() or hint(1) to hint({len(hints)}).",
        )
    more = f" (hint({number + 1}) tells more.)" if number < len(hints) else ""
    return Verdict("hint", hints[number - 1] + more)
