"""What the reader of lesson 04 moves: u, ε and T, over one bar of probabilities."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_04.exercises import epsilon_greedy as right_epsilon_greedy
from rlrobot_course.lesson_04.exercises import softmax as right_softmax
from rlrobot_course.lesson_04.figures import Picture, plot_draw, plot_rules
from rlrobot_edu.learning.selections.greedy import epsilon_greedy
from rlrobot_edu.learning.selections.softmax import softmax

TEMPERATURES = [0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100]  # fmt: skip
T = 3  # at which it opens
EPSILON = 0.2
HUNDREDS = 8  # after so many presses the first numbers come again


def draw(p, u):
    """The first action at which the running sum of p, array (n_actions,), exceeds u; the last if rounding lets none."""
    total = 0.0
    for a in range(p.shape[0]):
        total += p[a]
        if u < total:
            return a
    return p.shape[0] - 1


def draw_on_bar(p: Sequence[float], u: float) -> Handle:
    """Probabilities end to end, and the number u that draws an action. p: sums to 1"""
    name = "Random numbers on a bar of probabilities"
    return _bar(name, {"p": list(p), "q": None, "u": u}, plot_draw(p, u))


def rules_on_bar(q_s: Sequence[float], u: float = 0.65) -> Handle:
    """The probabilities that a rule makes of a row of Q, the rule and its number to be chosen."""
    q = np.array(q_s, dtype=float)
    rules = {f"ε-greedy, ε = {EPSILON}": right_epsilon_greedy(q, EPSILON)}
    rules |= {f"softmax, T = {t}": right_softmax(q, t) for t in (0.5, T, 100)}
    feed = {"q": q.tolist(), "u": u, "temperatures": TEMPERATURES}
    feed |= {"opening": TEMPERATURES.index(T), "epsilon": EPSILON}
    return _bar("What ε and T make of a row of Q", feed, plot_rules(q, rules))


def _bar(name: str, feed: dict[str, Any], picture: Picture) -> Handle:
    numbers = np.random.default_rng(3).random((HUNDREDS, 100)).round(4).tolist()
    return Handle(
        name,
        __package__,
        ["chances.js"],
        {**feed, "numbers": numbers},
        picture,
        {"draw": draw, "softmax": softmax, "epsilon_greedy": epsilon_greedy},
    )
