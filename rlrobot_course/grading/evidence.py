"""What a check has seen of one wrong answer, and what it tells the learner about it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from rlrobot_course.grading.replay import Outcome

if TYPE_CHECKING:
    from rlrobot_course.grading.exercise import Exercise


class Hint(NamedTuple):
    """What is told about a wrong answer; id: of the mistake, or the name of the detector that has found it."""

    id: str
    text: str


@dataclass(frozen=True)
class Evidence:
    """One wrong answer, and what it has done in each case that was tried."""

    exercise: Exercise
    answer: Callable[..., Any]
    got: Sequence[Outcome]

    def shows(self, function: Callable[..., Any]) -> bool:
        """Whether the answer does in every case what `function` does. One case in which it fails is excused."""
        failed = [i for i, mine in enumerate(self.got) if mine.failure]
        return all(self.exercise.mistaken(function, i).equals(mine) for i, mine in enumerate(self.got) if [i] != failed)
