"""Typical wrong answers, and the three hints of an exercise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from rlrobot_edu.course.grading.verdict import Verdict


@dataclass(frozen=True)
class Mistake:
    """A typical wrong answer, and the hint for whoever gives it.

    wrong: of a `Question` the wrong value; of an `Exercise` what is written differently from the right function, as in
        ``{"max(q[s_next])": "q[s_next].mean()"}`` (see `edited`)
    id: what it is called where its verdict is compared, as ``past_the_end``; empty in lessons that have no ids yet
    witnesses: answers as learners write them that must be recognised as this mistake
    """

    hint: str
    wrong: Any
    id: str = ""
    witnesses: Sequence[Any] = ()


def hinted(hints: Sequence[str], number: int) -> Verdict:
    """The hint of this number, from 1 on, and how to have the next."""
    if not 1 <= number <= len(hints):
        return Verdict("hint", f"There are {len(hints)} hints: hint() or hint(1) to hint({len(hints)}).")
    more = f" (hint({number + 1}) tells more.)" if number < len(hints) else ""
    return Verdict("hint", hints[number - 1] + more)
