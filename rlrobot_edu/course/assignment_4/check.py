"""Exercises of assignment 4: neighbours, the bias of a whole table, circles, heat, and all of it on a robot."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_edu.course.assignment_4 import mistakes, solutions
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.grading.tapes import TapeWorld


def other_state(rng: np.random.Generator, case: Case) -> Case:
    """A case of `near_states` with more bins where there are more than two, and any state."""
    shape = tuple(n + int(rng.integers(3)) * (n > 2) for n in case["shape"])
    return {**case, "shape": shape, "s": int(rng.integers(math.prod(shape)))}


near_states = Exercise(
    task="return the sorted list of the states that lie one bin beside s, in one input",
    right=solutions.near_states,
    returns="near",
    tape=[
        {"s": 1, "shape": (3,), "is_circle": (False,)},
        {"s": 0, "shape": (4,), "is_circle": (True,)},
        {"s": 0, "shape": (2, 3), "is_circle": (False, False)},
        {"s": 5, "shape": (2, 3), "is_circle": (False, True)},
        {"s": 17, "shape": (3, 4, 2), "is_circle": (False, False, False)},
        {"s": 6, "shape": (2, 5), "is_circle": (True, True)},
        {"s": 23, "shape": (3, 4, 2), "is_circle": (True, True, False)},
        {"s": 37, "shape": (5, 2, 5), "is_circle": (False, True, True)},
    ],
    mistakes=mistakes.NEAR,
    another=other_state,
    hints=(
        "Go from the number to the bins, change one of them by one, up and down, and go back to the number. For each "
        "input.",
        "np.unravel_index(s, shape) gives the bins, np.ravel_multi_index(bins, shape) the number. On a circle: "
        "bin % shape[i]. On a line: leave out what lies outside.",
        "Gather the numbers in a set, near.add(int(…)); at the end sorted(near - {s}).",
    ),
    gained="A coding of the world says who is near whom. A heading of 350° lies beside one of 10° only if you say so.",
)


def table(states: int, actions: int, turn: int) -> np.ndarray:
    """A table of Q with no two alike rows."""
    return np.round(np.sin(np.arange(states * actions) * 1.7 + turn).reshape(states, actions) * 6, 2)


bias_table = Exercise(
    task="return the bias of all states at once, an array like q",
    right=solutions.bias_table,
    returns="bias",
    tape=[
        {"q": table(4, 2, 0), "shape": (2, 2)},
        {"q": table(3, 2, 1), "shape": (3,)},
        {"q": table(6, 3, 2), "shape": (2, 3)},
        {"q": table(6, 2, 3), "shape": (3, 2)},
        {"q": table(12, 2, 4), "shape": (2, 3, 2)},
        {"q": table(8, 1, 5), "shape": (2, 2, 2)},
    ],
    mistakes=mistakes.BIAS,
    hints=(
        "Give the table an axis for each input: then the states that share all inputs but one lie along that one's "
        "axis.",
        "table = q.reshape(*shape, q.shape[1]); table.mean(axis=i, keepdims=True) is the bias of input i, for all "
        "states.",
        "Add these up for all i (numpy stretches an axis of length 1), divide by len(shape), and reshape to q.shape.",
    ),
    gained="What was a loop over states is now one mean along each axis: a whole table in a blink.",
)  # fmt: skip


def renamed(rng: np.random.Generator, case: Case) -> Case:
    """A case of `period` in which the states have other numbers; which are equal stays so."""
    factor, shift = int(rng.integers(2, 9)), int(rng.integers(1, 50))
    return {"states": [factor * s + shift for s in case["states"]]}


period = Exercise(
    task="return after how many steps the states repeat, 0 if they do not",
    right=solutions.period,
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
    mistakes=mistakes.PERIOD,
    another=renamed,
    hints=(
        "If the robot goes in a circle of p states, the last p of the list are the same as the p before them.",
        "states[-p:] are the last p, states[-2 * p : -p] the p before. Try p = 1, 2, … up to half of the list.",
        "for p in range(1, len(states) // 2 + 1): if …: return p. Below the loop: return 0.",
    ),
    gained="The paper's redundancy asks how often a robot comes by the same states. Yours asks whether it goes round.",
)

next_temperature = Exercise(
    task="return the temperature of the next step: hotter in a circle that does not pay, default otherwise",
    right=solutions.next_temperature,
    returns="temperature",
    lenders={"period": "your function of exercise 3"},
    tape=[
        {"temperature": 1.5, "states": [4, 7, 4, 7], "rewards": [-0.5, -0.25, -0.5, -0.25], "default": 1.5},
        {"temperature": 9.5, "states": [3, 1, 2, 5], "rewards": [-0.5, -0.5, -2.5, -0.5], "default": 1.25},
        {"temperature": 3.5, "states": [6, 6, 6, 6, 6, 6], "rewards": [-0.5] * 6, "default": 0.5},
        {"temperature": 3.5, "states": [6, 2, 6, 2], "rewards": [-20.5, -0.5, 9.5, -0.25], "default": 0.75},
        {"temperature": 4.5, "states": [6, 2, 6, 2], "rewards": [9.5, 9.25, -0.5, -0.25], "default": 1.5},
        {"temperature": 62.5, "states": [8, 8, 8], "rewards": [-0.5, -0.5, -0.5], "default": 1.5},
        {"temperature": 7.5, "states": [1, 2, 1, 2], "rewards": [-3.5, 1.5, 0.0, 0.0], "default": 1.5},
        {"temperature": 5.5, "states": [9], "rewards": [-0.5], "default": 2.5},
        {"temperature": 2.5, "states": [0, 1, 2, 3, 1, 2, 3], "rewards": [-0.25] * 7, "default": 0.5},
    ],
    mistakes=mistakes.TEMPERATURE,
    hints=(
        "Two questions: does it go in a circle, and did the last round of it earn less than nothing?",
        "p = period(states); the rewards of the last round are rewards[-p:], and they only mean something if p > 0.",
        "if p > 0 and sum(rewards[-p:]) < 0: return min(50, temperature + …); else default.",
    ),
    gained="The smaller the circle, the more it heats up: a robot that stands still gets hot at once.",
)


class Yard(TapeWorld):
    """A world without chance of four states (2 × 2 bins) and three actions; 0 stays where it is, and earns little.

    Action 2 in state 1 leads to state 3. The first, third … episode terminates there, and that pays; the others are
    truncated after 14 steps. So it goes in circles much of the time.
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self.episode, self.t, self.s = self.episode + 1, 0, self.episode % 3
        return self.s

    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        self.t, before = self.t + 1, self.s
        self.s = (self.s + a) % 4
        odd = self.episode % 2 == 1
        there = before == 1 and a == 2 and odd
        return self.s, 1.5 if there else -0.5 - 0.25 * a, there, not odd and self.t >= 14


def numbers(n: int, turn: int) -> list[float]:
    """Random numbers for the choices, always the same."""
    return [float(u) for u in np.random.default_rng(turn).random(n)]


drive = Exercise(
    task="choose by Q and bias, learn, note, heat up, and go on; return all rewards and all temperatures",
    right=solutions.drive,
    returns="rewards and temperatures",
    memory={"env": Yard(), "q": table(4, 3, 7) / 6},
    lenders={"bias_table": "your function of exercise 2", "next_temperature": "your function of exercise 4"},
    tape=[
        {"shape": (2, 2), "us": numbers(n, n), "alpha": alpha, "gamma": gamma, "scale": scale, "default": default}
        for n, alpha, gamma, scale, default in ((6, 0.5, 0.9, 1.25, 0.75), (25, 0.25, 0.8, 0.75, 0.5),
                                                (40, 0.4, 0.7, 1.5, 0.25), (60, 0.1, 0.9, 0.5, 0.125))
    ],
    mistakes=mistakes.DRIVE,
    hints=(
        "Write the loop of Q-learning first, choosing with draw(x, temperature, u). Then add what is noted, and the "
        "temperature.",
        "x = scale * (q[s] + bias_table(q, shape)[s]); after the update append s_next and r, keep the last 8 of each, "
        "and ask next_temperature.",
        "At an end: s, states, rewards, temperature = env.reset(), [], [], default.",
    ),
    gained="Choice, learning, memory and escape, and each line of it is yours.",
)  # fmt: skip
