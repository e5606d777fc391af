"""How a state is written, and where it stands among the others: alike on the page and in pictures."""

from __future__ import annotations

import math
from typing import NamedTuple

from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import Bin


def value_text(value: Bin) -> str:
    """A bin in as few signs as will do: its value without the unit where it has one, else its limits."""
    return f"{value.reading:g}".replace("-", "−") if value.low == value.high else str(value)


def state_text(task: Task, s: int) -> str:
    """State `s` as the paper writes it: ``(1,1,90,0)``."""
    return f"({','.join(value_text(value) for value in task.states.decode(s).values())})"


def inputs_text(task: Task) -> str:
    """The order of the inputs in `state_text`: ``(X,Y,theta,d)``."""
    return f"({','.join(variable.name for variable in task.states.inputs)})"


def state_words(task: Task, s: int) -> str:
    """State `s` in words: ``X 1, Y 1, theta 90 deg, d 0``."""
    return ", ".join(f"{name} {value}" for name, value in task.states.decode(s).items()).replace("-", "−")


class Place(NamedTuple):
    """Where a state is drawn: a block (column from the left, row from the bottom), and a cell inside it."""

    block: tuple[int, int]
    column: int
    row: int


def place_of(task: Task, s: int) -> Place:
    """Blocks are the first inputs in turn across and up, as on a map; inside are the last but one × the last."""
    shape, bins = task.states.shape, task.states.bins(s)
    outer = len(shape) - 2
    block = []
    for first in (0, 1):  # inputs 0, 2, … go across, 1, 3, … up
        number = 0
        for i in range(first, outer, 2):
            number = number * shape[i] + bins[i]
        block.append(number)
    column = bins[-2] if len(bins) > 1 else 0
    return Place((block[0], block[1]), column, bins[-1])


def blocks_of(task: Task) -> dict[tuple[int, int], list[int]]:
    """The states of each block, in order of their numbers."""
    size = math.prod(task.states.shape[-2:])
    groups = [list(range(first, first + size)) for first in range(0, task.states.n, size)]
    return {place_of(task, states[0]).block: states for states in groups}


def block_text(task: Task, s: int) -> str:
    """The values that all states of the block of `s` have in common: ``X = 1, Y = 0``; empty where there are none."""
    common = list(task.states.decode(s).items())[:-2]
    return ", ".join(f"{name} = {value_text(value)}" for name, value in common)
