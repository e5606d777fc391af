"""Right answers and tapes of assignment 4; the pages of this folder have the tasks, hints and mistakes."""

import copy
import math
from collections.abc import Sequence
from types import FunctionType

import numpy as np

from rlrobot_course.assignment_4.fixtures import draw, softmax, table
from rlrobot_course.exercises.parts import Case, Exercise, with_pages
from rlrobot_course.worlds.tapes import TapeWorld, beside, rows, with_action


def near_states(s, shape, is_circle):
    near, bins = set(), np.unravel_index(s, shape)
    for i in range(len(shape)):
        for step in (-1, 1):
            other = list(bins)
            other[i] += step
            if is_circle[i]:
                other[i] %= shape[i]
            if 0 <= other[i] < shape[i]:
                near.add(int(np.ravel_multi_index(other, shape)))
    return sorted(near - {s})


def other_state(rng: np.random.Generator, case: Case) -> Case:
    """A case of `near_states` with more bins where there are more than two, and any state."""
    shape = tuple(n + int(rng.integers(3)) * (n > 2) for n in case["shape"])
    return {**case, "shape": shape, "s": int(rng.integers(math.prod(shape)))}


def bias_table(q, shape):
    table = q.reshape(*shape, q.shape[1])
    total = np.zeros(table.shape)
    for i in range(len(shape)):
        total += table.mean(axis=i, keepdims=True)
    return (total / len(shape)).reshape(q.shape)


def period(states):
    for p in range(1, len(states) // 2 + 1):
        if states[-p:] == states[-2 * p : -p]:
            return p
    return 0


def renamed(rng: np.random.Generator, case: Case) -> Case:
    """A case of `period` in which the states have other numbers; which are equal stays so."""
    factor, shift = int(rng.integers(2, 9)), int(rng.integers(1, 50))
    return {"states": [factor * s + shift for s in case["states"]]}


def next_temperature(temperature, states, rewards, default):
    p = period(states)
    if p > 0 and sum(rewards[-p:]) < 0:
        return min(50, temperature + len(states) / (4 * p))
    return default


def drive(env, q, shape, us, alpha, gamma, scale, default):
    earned, heat, states, rewards, temperature = [], [], [], [], default
    s = env.reset()
    for u in us:
        x = scale * (q[s] + bias_table(q, shape)[s])
        a = draw(x, temperature, u)
        s_next, r, terminated, truncated = env.step(a)
        target = r if terminated else r + gamma * max(q[s_next])
        q[s, a] += alpha * (target - q[s, a])
        earned.append(r)
        heat.append(temperature)
        states, rewards = [*states, s_next][-8:], [*rewards, r][-8:]
        temperature = next_temperature(temperature, states, rewards, default)
        s = s_next
        if terminated or truncated:
            s, states, rewards, temperature = env.reset(), [], [], default
    return earned, heat


class Yard(TapeWorld):
    """A world without chance of four states (2 × 2 bins) and three actions; 0 stays where it is, and earns little.

    Action 2 in state 1 leads to state 3. The first, third … episode terminates there, and that pays; the others are
    truncated after 14 steps. So it goes in circles much of the time.
    pays: instead, the rewards of the steps of an episode, again and again, whatever the steps do
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def __init__(self, pays: Sequence[float] = ()) -> None:
        super().__init__()
        self.pays = pays

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self.episode, self.t, self.s = self.episode + 1, 0, self.episode % 3
        return self.s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        self.t, before = self.t + 1, self.s
        self.s = (self.s + a) % 4
        odd = self.episode % 2 == 1
        there = before == 1 and a == 2 and odd
        reward = 1.5 if there else -0.5 - 0.25 * a
        if self.pays:
            reward = self.pays[(self.t - 1) % len(self.pays)]
        return self.s, reward, there, not odd and self.t >= 14


def numbers(n: int) -> list[float]:
    """Random numbers for the choices, always the same."""
    return [float(u) for u in np.random.default_rng(n).random(n)]


DRIVEN = {"env": Yard(), "q": table(4, 3, 7) / 6}
# whose sum is below 0, though their signs cancel, and they do if they are rounded
UNEVEN = (0.3051, -0.3054)
FINELY = {
    "shape": (2, 2),
    "us": numbers(60),
    "alpha": 0.31234,
    "gamma": 0.87654,
    "scale": 0.65432,
    "default": 0.54321,
}


def sharp(case: Case) -> Case:
    """A case of `drive` with random numbers beside the borders between the actions of the right answer."""
    numbers: list[float] = []

    def draw_beside(x: np.ndarray, temperature: float, u: float) -> int:
        p = softmax(x, temperature)
        numbers.append(beside(p, u, len(numbers) % 2 == 0))
        return draw(x, temperature, numbers[-1])

    driver = FunctionType(drive.__code__, drive.__globals__ | {"draw": draw_beside})
    driver(**copy.deepcopy(case))
    return {**case, "us": numbers}


def other_drive(rng: np.random.Generator, case: Case) -> Case:
    """A case of `drive` with other numbers; those that lie beside borders do so again."""
    new = {**case, "us": rng.random(len(case["us"])).tolist()}
    for name in ("alpha", "gamma", "scale", "default"):
        new[name] = case[name] * float(rng.uniform(0.8, 1.0))
    return sharp(new) if "q" in case else new


check = with_pages(
    globals(),
    near_states=Exercise(
        near_states,
        returns="near",
        tape=rows(
            "s shape is_circle",
            (1, (3,), (False,)),
            (0, (4,), (True,)),
            (0, (2, 3), (False, False)),
            (5, (2, 3), (False, True)),
            (17, (3, 4, 2), (False, False, False)),
            (6, (2, 5), (True, True)),
            (23, (3, 4, 2), (True, True, False)),
            (37, (5, 2, 5), (False, True, True)),
        ),
        another=other_state,
    ),
    bias_table=Exercise(
        bias_table,
        returns="bias",
        tape=rows(
            "q shape",
            (table(4, 2, 0), (2, 2)),
            (table(3, 2, 1), (3,)),
            (table(6, 3, 2), (2, 3)),
            (table(6, 2, 3), (3, 2)),
            (table(12, 2, 4), (2, 3, 2)),
            (table(8, 1, 5), (2, 2, 2)),
            (table(6, 2, 6) / 7, (2, 3)),
        ),
    ),
    period=Exercise(
        period,
        returns="period",
        tape=[
            {"states": [4, 7, 4, 7]},
            {"states": [3, 1, 2, 5]},
            {"states": [5, 9, 6, 6]},
            {"states": [1, 2, 3, 1, 2, 3]},
            {"states": [1, 2, 1, 2, 1, 2, 1, 2]},
            {"states": [4, 4, 8, 3, 5]},
            {"states": [2, 7, 1, 1, 7, 2]},
            {"states": [1, 5, 2, 5]},
            {"states": [8]},
            {"states": []},
            {"states": [0, 6, 2, 3, 1, 2, 3, 1]},
            {"states": [1, 2, 2, 1]},
            {"states": [1, 2, 3, 4, 1, 2, 3, 4]},
            {"states": [6, 2, 8, 4, 5, 7, 2, 8, 4, 5, 7]},
            {"states": [9, 1, 2, 1, 3, 5, 4, 1, 2, 1, 3, 5, 4]},
            {"states": [3, 1, 4, 1, 5, 9, 2, 3, 1, 4, 1, 5, 9, 2]},
        ],
        another=renamed,
    ),
    next_temperature=Exercise(
        next_temperature,
        returns="temperature",
        tape=rows(
            "temperature states rewards default",
            (1.5, [4, 7, 4, 7], [-0.5, -0.25, -0.5, -0.25], 1.5),
            (9.5, [3, 1, 2, 5], [-0.5, -0.5, -2.5, -0.5], 1.25),
            (3.5, [6, 6, 6, 6, 6, 6], [-0.5] * 6, 0.5),
            (3.5, [6, 2, 6, 2], [-20.5, -0.5, 9.5, -0.25], 0.75),
            (4.5, [6, 2, 6, 2], [9.5, 9.25, -0.5, -0.25], 1.5),
            (6.5, [3, 6, 8, 1, 2, 1, 2], [9.5, 9.25, 9.5, 9.25, 9.5, -0.5, -0.25], 1.5),
            (62.5, [8, 8, 8], [-0.5, -0.5, -0.5], 1.5),
            (7.5, [1, 2, 1, 2], [-3.5, 1.5, 0.0, 0.0], 1.5),
            (5.5, [9], [-0.5], 2.5),
            (2.5, [0, 1, 2, 3, 1, 2, 3], [-0.25] * 7, 0.5),
            (1.23456, [6, 2, 6, 2], [0.5, 0.5, -0.0004, 0.0], 0.5),
            (1.5, [6, 2, 6, 2], [0.5, 0.5, 0.0004, 0.0], 0.54321),
        ),
    ),
    drive=Exercise(
        drive,
        returns="rewards and temperatures",
        memory=DRIVEN,
        tape=rows(
            "shape us alpha gamma scale default",
            ((2, 2), numbers(6), 0.5, 0.9, 1.25, 0.75),
            ((2, 2), numbers(25), 0.25, 0.8, 0.75, 0.5),
            ((2, 2), numbers(40), 0.4, 0.7, 1.5, 0.25),
            ((2, 2), numbers(60), 0.1, 0.9, 0.5, 0.125),
            ((2, 2), numbers(15), 0.3, 0.0, 0.5, 0.5),
            ((2, 2), numbers(15), 0.2, 0.99, 0.5, 0.5),
        )
        + [sharp(DRIVEN | {"env": Yard(UNEVEN)} | FINELY)],
        another=other_drive,
    ),
)
