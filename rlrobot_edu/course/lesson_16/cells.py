"""Five by seven cells with walls between start and goal, without chance: a small one of Sutton & Barto's example 8.1."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import steps as walk

MAP = """
....#.G
S##.#..
..#....
..###..
....#..
""".split()
SHAPE = len(MAP), len(MAP[0])  # rows, from the top, and columns
START, GOAL = (1, 0), (0, 6)
WALLS = frozenset(cell for cell in np.ndindex(SHAPE) if MAP[cell[0]][cell[1]] == "#")
MOVES = ((-1, 0), (0, 1), (1, 0), (0, -1))  # actions 0 to 3: up, right, down, left
SHORTEST = 11  # moves from start to goal

Seen = Mapping[tuple[int, int], tuple[float, int, bool]]  # what followed a pair: (s, a) -> (r, s', terminated)


def number(cell: tuple[int, int]) -> int:
    """The number of a cell's state; rows count slowest."""
    return cell[0] * SHAPE[1] + cell[1]


def neighbour(cell: tuple[int, int], a: int) -> tuple[int, int]:
    """Where action `a` leads: to the next cell, or nowhere if a wall or the edge is in the way."""
    row, column = cell[0] + MOVES[a][0], cell[1] + MOVES[a][1]
    inside = 0 <= row < SHAPE[0] and 0 <= column < SHAPE[1]
    return (row, column) if inside and (row, column) not in WALLS else cell


class Cells(gymnasium.Env[np.ndarray, np.int64]):
    """A robot in cells. It moves up, right, down or left by one; a step to the goal pays 1 and ends the episode.

    Any other step pays 0. In front of a wall the robot stays where it is.
    """

    def __init__(self) -> None:
        self.observation_space = MultiDiscrete(SHAPE)  # type: ignore[assignment]  # Gymnasium types it as its own
        self.action_space = Discrete(len(MOVES))
        self.cell = START

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict]:
        """Put the robot on the start."""
        super().reset(seed=seed)
        self.cell = START
        return np.array(self.cell), {}

    def step(self, action: np.int64) -> tuple[np.ndarray, float, bool, bool, dict]:
        """Move by one cell, if nothing is in the way."""
        self.cell = neighbour(self.cell, int(action))
        at_goal = self.cell == GOAL
        return np.array(self.cell), float(at_goal), at_goal, False, {}


def best_way(q: np.ndarray) -> list[tuple[int, int]]:
    """The cells from the start on of a robot that always takes its best action.

    q: array (35, 4). The way ends at the goal, where it comes back to a cell, or where nothing is known yet.
    """
    way = [START]
    while way[-1] != GOAL and len(set(way)) == len(way):
        row = q[number(way[-1])]
        if not row.any():
            break
        way.append(neighbour(way[-1], int(row.argmax())))
    return way
