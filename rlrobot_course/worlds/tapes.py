"""The experience that the checks replay: one short sequence of steps, which reveals every typical mistake."""

import functools
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar, cast

import numpy as np

from rlrobot_edu.environments import make_env

T = TypeVar("T")

# Q after some learning, 4 states × 3 actions. In no state is action 0 the best by accident, and state 3, where episodes
# end, has values that tempt those who look past the end.
Q_START = np.array(
    [[0.0, 2.0, 1.0], [4.0, -1.0, 5.5], [0.0, 0.5, 3.0], [5.0, 6.0, 7.0]]
)
# Of another world, with two actions, and values with many digits.
OTHER_Q = np.array([[-0.4871, 1.0032], [2.7183, -3.1416], [0.1234, -0.5772]])

# Of a world with two inputs, of two and three bins; so small that it is shown in full.
SMALL = np.array(
    [[1.0, -2.0], [4.0, 0.5], [7.0, 3.0], [0.0, 6.0], [5.0, 2.5], [-8.0, 9.0]]
)

_COLUMNS = ("s", "a", "r", "s_next", "a_next", "terminated")
_STEPS = (
    (0, 1, 10.0, 1, 0, False),
    (1, 0, -0.02, 2, 2, False),
    (2, 2, -2.0, 0, 2, False),
    (0, 2, 10.0, 0, 1, False),
    (0, 1, 10.0, 3, 2, True),
    (1, 1, -2.0, 1, 1, False),
    (1, 1, -0.02, 0, 1, False),
    (0, 1, 10.0, 1, 2, False),
    (1, 2, 10.0, 3, 0, True),
)
# (s, a, r, s', a', terminated); two episodes. a' is not always the best action, and at an end it means nothing.
TAPE = [dict(zip(_COLUMNS, step, strict=True)) for step in _STEPS]
# One more step, whose numbers have many digits: whoever rounds them goes another way.
FINE = dict(zip(_COLUMNS, (1, 2, 1.23456, 0, 1, False), strict=True))
FINE_ALPHA, FINE_GAMMA, FINE_LAMBDA = 0.31234, 0.87654, 0.65432


def without_next_action(steps: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The steps as Q-learning needs them, which does not ask for a'."""
    return [
        {name: value for name, value in step.items() if name != "a_next"}
        for step in steps
    ]


Q_TAPE = without_next_action(TAPE)
FINE_FOR_Q = without_next_action([FINE])


def rows(names: str, *values: Sequence[Any]) -> list[dict[str, Any]]:
    """Cases for an exercise as a table: the names of its columns in one text, then the values of each row.

    A column whose name ends with [] is one of arrays, which are written as lists.
    """
    columns = [name.partition("[]") for name in names.split()]
    cases = [zip(columns, row, strict=True) for row in values]
    return [
        {name: np.array(x) if array else x for (name, array, _), x in case}
        for case in cases
    ]


def with_columns(
    cases: Sequence[Mapping[str, Any]], **columns: Sequence[Any]
) -> list[dict[str, Any]]:
    """The cases with further arguments. columns: by the name of an argument its value in each case."""
    more = zip(*columns.values(), strict=True)
    return [
        {**case, **dict(zip(columns, row, strict=True))}
        for case, row in zip(cases, more, strict=True)
    ]


def draw(p: np.ndarray, u: float) -> int:
    """The first action at which the running sum of `p` exceeds `u`, or the last where rounding leaves it below."""
    return int(np.searchsorted(np.cumsum(p), u, side="right").clip(max=len(p) - 1))


HAIR = 1e-6  # how near to a border a random number lies


def beside(p: np.ndarray, u: float, above: bool) -> float:
    """A number just above, or just below, that border between two actions of probabilities `p` that is next to `u`."""
    borders = np.cumsum(p)[:-1]
    border = float(borders[np.abs(borders - u).argmin()])
    number = border + HAIR if above else border - HAIR
    return number if 0 <= number < 1 else 2 * border - number


def with_action(method: Callable[..., T]) -> Callable[..., T]:
    """A world's `step`, whose argument may be named as the lessons do, `a`, or as Gymnasium does, `action`."""

    @functools.wraps(method)
    def step(world: Any, *arguments: Any, **by_name: Any) -> T:
        given = [
            *arguments,
            *(by_name.pop(name) for name in ("a", "action") if name in by_name),
        ]
        if len(given) != 1 or by_name:
            raise TypeError("env.step takes an action and nothing else: env.step(a)")
        return method(world, *given)

    return step


class TapeWorld:
    """A deterministic world: the same state and action always have the same outcome.

    reset() -> state; step(action) -> state, reward, terminated, truncated. The first, third, fifth … episode terminates
    after three steps, in state 3; the others are truncated after two.
    """

    def __init__(self) -> None:
        self.episode, self.t, self.s = 0, 0, 0

    def __repr__(self) -> str:
        return f"episode {self.episode}, step {self.t}, state {self.s}"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TapeWorld) and vars(self) == vars(other)

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self.episode, self.t, self.s = self.episode + 1, 0, self.episode % 2
        return self.s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        self.t += 1
        reward = (10.0, -2.0, -0.0213)[(self.s + a) % 3]
        terminated = self.episode % 2 == 1 and self.t >= 3
        self.s = 3 if terminated else (2 * self.s + a + self.t) % 3
        return self.s, reward, terminated, self.episode % 2 == 0 and self.t >= 2


class PatientWorld(TapeWorld):
    """For loops over whole episodes: after six steps one terminates in any case, so even a wrong loop ends."""

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        s_next, reward, terminated, truncated = super().step(a)
        return s_next, reward, terminated or self.t >= 6, truncated


class RobotWorld:
    """A task's robot with the short interface of the course, which leaves out what a learner need not know.

    task: its name; seed: of all that is random
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def __init__(self, task: str, seed: int = 0) -> None:
        self.task, self.env = task, make_env(task, seed=seed)
        robot = cast(Any, self.env.unwrapped)
        self.shape: tuple[int, ...] = robot.task.states.shape
        self.n_actions: int = robot.task.actions.n
        self.r_max: float = robot.r_max

    def __repr__(self) -> str:
        return f"the robot of {self.task}"

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        info = self.env.reset()[1]
        return int(info["state"])

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        _, reward, terminated, truncated, info = self.env.step(a)
        return int(info["state"]), float(reward), terminated, truncated
