"""The worlds of the textbook's examples as sample models, in which learning runs compiled."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import accumulate

import numpy as np
from gymnasium.envs.toy_text import FrozenLakeEnv, TaxiEnv

from rlrobot_edu.models.sample_model import SampleModel

Outcome = tuple[int, int, float, bool]  # how often, s', reward, terminated

UP, DOWN, LEFT, RIGHT = MOVES = ((-1, 0), (1, 0), (0, -1), (0, 1))  # rows, columns
THIRDS = 3  # Gymnasium's tables hold probabilities of 1 and of 1/3
WALK_CELLS = 19


def model_of(
    shape: tuple[int, ...], rows: Iterable[Sequence[Outcome]], starts: Sequence[int]
) -> SampleModel:
    """A sample model of what each pair leads to. rows: the outcomes of (0, 0), (0, 1), … in the order of the pairs."""
    rows = list(rows)
    outcomes = [outcome for row in rows for outcome in row]
    _, s_next, r, terminated = zip(*outcomes, strict=True)
    return SampleModel(
        shape=shape,
        n_actions=len(rows) // int(np.prod(shape)),
        offsets=np.cumsum([0, *map(len, rows)]),
        s_next=np.array(s_next),
        r=np.array(r, dtype=float),
        terminated=np.array(terminated),
        cumulative=np.concatenate(
            [list(accumulate(count for count, *_ in row)) for row in rows]
        ),
        starts=np.array(starts),
        rewards=np.unique(r).astype(float),
    )


def of_gymnasium(env: FrozenLakeEnv | TaxiEnv) -> SampleModel:
    """An environment of Gymnasium, copied from its own table of outcomes."""
    n_states, n_actions = env.observation_space.n, env.action_space.n
    rows = [
        [
            (round(THIRDS * p), int(s_next), float(r), bool(end))
            for p, s_next, r, end in env.P[s][a]
        ]
        for s in range(n_states)
        for a in range(n_actions)
    ]
    return model_of((n_states,), rows, np.flatnonzero(env.initial_state_distrib))


def grid(
    shape: tuple[int, int],
    start: tuple[int, int],
    outcome: Callable[[int, int, tuple[int, int]], tuple[tuple[int, int], float, bool]],
) -> SampleModel:
    """A grid without chance, with four moves. outcome: row, column, move -> cell, reward, terminated"""
    rows = []
    for row, column in np.ndindex(shape):
        for move in MOVES:
            cell, r, terminated = outcome(row, column, move)
            rows.append([(1, int(np.ravel_multi_index(cell, shape)), r, terminated)])
    return model_of(shape, rows, [int(np.ravel_multi_index(start, shape))])


def cliff() -> SampleModel:
    """Example 6.6: −1 a step; the cliff costs 100 and leads back to the start."""
    start, goal = (3, 0), (3, 11)

    def outcome(
        row: int, column: int, move: tuple[int, int]
    ) -> tuple[tuple[int, int], float, bool]:
        cell = min(max(row + move[0], 0), 3), min(max(column + move[1], 0), 11)
        falls = cell[0] == 3 and 0 < cell[1] < 11
        return (start, -100.0, False) if falls else (cell, -1.0, cell == goal)

    return grid((4, 12), start, outcome)


def windy_gridworld() -> SampleModel:
    """Example 6.5: −1 a step, and in the middle a wind that blows upwards by one or two cells."""
    wind, goal = (0, 0, 0, 1, 1, 1, 2, 2, 1, 0), (3, 7)

    def outcome(
        row: int, column: int, move: tuple[int, int]
    ) -> tuple[tuple[int, int], float, bool]:
        cell = (
            min(max(row + move[0] - wind[column], 0), 6),
            min(max(column + move[1], 0), 9),
        )
        return cell, -1.0, cell == goal

    return grid((7, 10), (3, 0), outcome)


def dyna_maze() -> SampleModel:
    """Example 8.1: walls, and 1 at the goal."""
    walls, goal = {(1, 2), (2, 2), (3, 2), (4, 5), (0, 7), (1, 7), (2, 7)}, (0, 8)

    def outcome(
        row: int, column: int, move: tuple[int, int]
    ) -> tuple[tuple[int, int], float, bool]:
        cell = min(max(row + move[0], 0), 5), min(max(column + move[1], 0), 8)
        cell = (row, column) if cell in walls else cell
        return cell, float(cell == goal), cell == goal

    return grid((6, 9), (2, 0), outcome)


def random_walk() -> SampleModel:
    """Section 12.5: 19 cells in a row, left or right by chance; −1 beyond the left end, 1 beyond the right one."""
    ends = {-1: -1.0, WALK_CELLS: 1.0}
    rows = [
        [
            (1, s if s_next in ends else s_next, ends.get(s_next, 0.0), s_next in ends)
            for s_next in (s - 1, s + 1)
        ]
        for s in range(WALK_CELLS)
    ]
    return model_of((WALK_CELLS,), rows, [WALK_CELLS // 2])
