"""One colour and one sign for each input, on the page and in pictures."""

from __future__ import annotations

from typing import NamedTuple

from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.task.task import Task

MOST_STATES = 64  # more do not fit on a page


class Mark(NamedTuple):
    """What shows that a state belongs to the set of one input: a sign, and the name of its colour in the palette."""

    sign: str
    token: str

    @property
    def colour(self) -> str:
        """The colour on a light ground."""
        return LIGHT[self.token]


MARKS = (
    Mark("●", "input-1"),
    Mark("▲", "input-2"),
    Mark("■", "input-3"),
    Mark("◆", "input-4"),
    Mark("★", "input-5"),
    Mark("✚", "input-6"),
)


def marks_of(task: Task) -> dict[str, Mark]:
    """The mark of each input. Raises ValueError for a task that is too large to be shown state by state."""
    n_inputs = len(task.inputs)
    if task.states.n > MOST_STATES or n_inputs > len(MARKS):
        raise ValueError(
            f"{task.name} has {task.states.n} states of {n_inputs} inputs; the bias explorer shows each state, so take "
            f"a task of at most {MOST_STATES} states and {len(MARKS)} inputs, such as worked_example"
        )
    return dict(zip((v.name for v in task.inputs), MARKS, strict=False))
