"""What a check has seen of one wrong answer, and what it tells the learner about it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from rlrobot_grading.answers.replay import Outcome

if TYPE_CHECKING:
    from rlrobot_grading.exercises.exercise import Exercise


class Hint(NamedTuple):
    """What the check says about a wrong answer; id: of the mistake, or the name of the detector that has found it."""

    id: str
    text: str


@dataclass(frozen=True)
class Evidence:
    """One wrong answer, and what it has done in each case that was tried."""

    exercise: Exercise
    answer: Callable[..., Any]
    got: Sequence[Outcome]

    @cached_property
    def wrong(self) -> list[int]:
        """The cases in which it is wrong."""
        pairs = zip(self.exercise.expected, self.got, strict=False)
        return [i for i, (right, mine) in enumerate(pairs) if not right.equals(mine)]

    def shows(self, function: Callable[..., Any], endless: bool = False) -> bool:
        """Whether the answer does in every case what `function` does. One case in which it fails is excused.

        endless: whether `function` may take as long as it likes, since it is known to end
        """
        failed = [i for i, mine in enumerate(self.got) if mine.failure]
        order = dict.fromkeys(
            [*self.wrong, *range(len(self.got))]
        )  # most functions are told apart by a wrong one
        return all(
            self.exercise.mistaken(function, i, endless).equals(self.got[i])
            for i in order
            if [i] != failed
        )
