"""What a check has seen of one wrong answer, and what it tells the learner about it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from rlrobot_grading.answers.replay import Case, Outcome
from rlrobot_grading.answers.values import Function


class Hint(NamedTuple):
    """What the check says about a wrong answer; id: of the mistake, or the name of the detector that has found it."""

    id: str
    text: str


Known = tuple[Hint, Function]  # a wrong function, and the hint for it


class Half(NamedTuple):
    """One of two mistakes: its hint, the function that makes it alone, and its edits of the right function."""

    text: str
    function: Function
    edits: Mapping[str, str]


class Pair(NamedTuple):
    """Two mistakes at once: the hint for both, and the function that makes both."""

    hint: Hint
    both: Function
    halves: tuple[Half, Half]


@dataclass(frozen=True)
class Evidence:
    """One wrong answer beside the right function, and what both have done in each case that was tried.

    answer, right: the functions; parameters: the names of their arguments
    cases: arguments by name; expected, got: what `right` and `answer` have done with them
    outcome: (function, case) -> what comes of a function in a case
    mistaken: (function, number of a case, endless) -> the same; it is tried once, for all answers
    mistakes: those that the exercise knows; pairs: two of them at once, made when first asked for
    memory, returns, lenders: as in `Exercise`
    is_exact: whether all right answers return the same, so that a wrong one tells what it does
    """

    answer: Function
    right: Function
    parameters: tuple[str, ...]
    cases: Sequence[Case]
    expected: Sequence[Outcome]
    got: Sequence[Outcome]
    outcome: Callable[[Function, Case], Outcome]
    mistaken: Callable[[Function, int, bool], Outcome]
    mistakes: Sequence[Known]
    pairs: Callable[[], Sequence[Pair]]
    memory: Mapping[str, Any]
    returns: str
    lenders: Mapping[str, str]
    is_exact: bool

    @cached_property
    def wrong(self) -> list[int]:
        """The cases in which it is wrong."""
        pairs = zip(self.expected, self.got, strict=False)
        return [i for i, (right, mine) in enumerate(pairs) if not right.equals(mine)]

    def shows(self, function: Function, endless: bool = False) -> bool:
        """Whether the answer does in every case what `function` does. One case in which it fails is excused.

        endless: whether `function` may take as long as it likes, since it is known to end
        """
        failed = [i for i, mine in enumerate(self.got) if mine.failure]
        # most functions are told apart by a wrong one
        order = dict.fromkeys([*self.wrong, *range(len(self.got))])
        return all(
            self.mistaken(function, i, endless).equals(self.got[i])
            for i in order
            if [i] != failed
        )
