"""One colour and one sign for each input, on the page and in pictures."""

from __future__ import annotations

from typing import NamedTuple

from rlrobot_edu.show.palette import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    WHITE,
)
from rlrobot_edu.task.task import Task

MOST_STATES = 64  # more do not fit on a page


class Mark(NamedTuple):
    """What shows that a state belongs to the set of one input: a sign, its colour, and a colour to write on that."""

    sign: str
    colour: str
    ink: str


MARKS = (
    Mark("●", ORANGE, BLACK),
    Mark("▲", SKY, BLACK),
    Mark("■", GREEN, WHITE),
    Mark("◆", PURPLE, WHITE),
    Mark("★", RED, WHITE),
    Mark("✚", BLUE, WHITE),
)
HERE = Mark("", WHITE, BLACK)  # the state itself, which is in every set


def marks_of(task: Task) -> dict[str, Mark]:
    """The mark of each input. Raises ValueError for a task that is too large to be shown state by state."""
    n_inputs = len(task.inputs)
    if task.states.n > MOST_STATES or n_inputs > len(MARKS):
        raise ValueError(
            f"{task.name} has {task.states.n} states of {n_inputs} inputs; the bias explorer shows each state, so take "
            f"a task of at most {MOST_STATES} states and {len(MARKS)} inputs, such as worked_example"
        )
    return dict(zip((v.name for v in task.inputs), MARKS, strict=False))
