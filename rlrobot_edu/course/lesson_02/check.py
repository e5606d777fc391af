"""Exercises of lesson 02: Q-learning."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.tapes import TAPE, Fickle, TapeWorld, in_order
from rlrobot_edu.course.lesson_02 import loop_mistakes, mistakes, solutions

# as in the other lessons, and a state in which every action is bad
Q = np.array([[0.0, 2.0, 1.0], [4.0, -1.0, 5.5], [0.0, 0.5, 3.0], [5.0, 6.0, 7.0], [-1.375, -3.0, -2.0]])
by_hand = Question(
    task="the new Q(s, a), computed by hand",
    right=solutions.by_hand,
    because="4 + 0.2 · (10 + 0.9 · 6 − 4) = 6.28: one fifth of the way from 4 to the target of 15.4.",
    mistakes=[
        Mistake("this is the target itself. With α = 0.2, Q goes only a fifth of the way towards it.", 15.4),
        Mistake("you forgot γ: the value of the next state counts 0.9 times.", 6.4),
        Mistake("you forgot γ, and the gap begins at the old Q(s, a): take 4 off before you multiply by α.", 7.2),
        Mistake("you added α times the target. The TD error is the target minus the old Q(s, a).", 7.08),
        Mistake("the next state counts, too: add γ times its best value to the reward.", 5.2),
        Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", 11.4),
        Mistake("this is the step α · δ. Add it to the old Q(s, a).", 2.28),
        Mistake("this is α times the target. Q moves from 4 towards the target: 4 + α · δ.", 3.08),
        Mistake("α and γ have changed places: α multiplies the whole of δ, γ the value of s'.", 10.48),
        Mistake("you took α · δ off. The gap is positive, so Q rises.", 1.72),
        Mistake("γ discounts what comes later; the reward of this step counts in full.", 6.08),
        Mistake("this goes four fifths of the way. α is the share to go, 1 − α the share that stays.", 13.12),
        Mistake("6 is what the best action of s' is worth. Q(s, a) moves a part of the way from 4 to the target. (If "
                "you have rounded: give two digits more.)", 6.0),
        Mistake("from the next state its best action counts: 6, not 3.7.", 5.866),
        Mistake("from the next state its best action counts: 6, not −1.", 5.02),
        Mistake("from the next state its best action counts: 6, not the mean.", 5.722),
        Mistake("from the next state its best action counts: 6, not the sum.", 6.766),
        Mistake("with α = 0.1 it would be this. Here α is 0.2.", 5.14),
        Mistake("brackets: α multiplies the whole gap, 0.2 · (10 + 0.9 · 6 − 4), not the reward alone.", 7.4),
        Mistake("brackets: γ multiplies the 6 alone. The old Q(s, a) is taken off in full.", 6.36),
        Mistake("what the next state is worth is added to the reward, not taken off.", 4.12),
        Mistake("this goes 0.9 of the way. The share to go is α = 0.2; γ multiplies the value of s'.", 14.26),
        Mistake("what follows is worth the best of s', 6, not the old Q(s, a) once more.", 5.92),
        Mistake("this multiplies 4 + α by the gap. Multiply first, then add: 4 + 0.2 · 11.4.", 47.88),
        Mistake("the reward is missing: the target is 10 + 0.9 · 6.", 4.28),
        Mistake("the old Q(s, a) is taken off the target, not added to it.", 7.88),
        Mistake("the target has the weight α, as the old value has 1 − α: 0.8 · 4 + 0.2 · 15.4.", 18.6),
        Mistake("the old value is taken off twice: δ has it already. All of the 4 stays: 4 + 0.2 · 11.4.", 5.48),
        Mistake("γ belongs to what follows, not to the whole gap. Here the gap is multiplied by it once more.",
                4 + 0.2 * 0.9 * 11.4),
    ],
    hints=(
        "Q(s, a) moves a part of the way from where it is to the target. How far is the target, how large the part?",
        "Target: 10 + 0.9 · (the best of the three). δ: the target minus 4. New value: 4 + 0.2 · δ.",
        "4 + 0.2 * (10 + 0.9 * … - 4): only the best value of s' is missing.",
    ),
    gained="This one line of arithmetic is all that the robot does to learn. The rest is repetition.",
)  # fmt: skip

target = Exercise(
    task="return what Q(s, a) should have been, r + γ · max Q(s', ·)",
    right=solutions.target,
    returns="target",
    lenders={
        "s": "not handed over: what counts is the state after the step, s_next",
        "a": "not handed over: in s_next any action may follow, and the best one counts",
        "a_next": "not known in Q-learning, and not needed: it takes the best action of s_next",
    },
    tape=[
        {"q": Q, "r": 1.25, "s_next": 1, "terminated": False, "gamma": 0.75},
        {"q": Q, "r": -0.02, "s_next": 2, "terminated": False, "gamma": 0.9},
        {"q": Q, "r": 10.0, "s_next": 3, "terminated": True, "gamma": 0.9},
        {"q": Q, "r": -2.0, "s_next": 4, "terminated": False, "gamma": 0.95},
        {"q": Q, "r": -2.0, "s_next": 1, "terminated": True, "gamma": 0.5},
        {"q": Q, "r": 0.0, "s_next": 0, "terminated": False, "gamma": 0.6},
        {"q": Q[:, :2] + 0.0625, "r": 3.0, "s_next": 2, "terminated": False, "gamma": 0.99},
        {"q": Q, "r": 0.37, "s_next": 4, "terminated": True, "gamma": 0.85},
        {"q": Q[1:3], "r": 10.0, "s_next": 0, "terminated": False, "gamma": 0.25},
        {"q": np.array([[0.4, -7.0, 0.1, 0.3], [-8.0, 0.9, -0.5, 1.2]]), "r": 0.125, "s_next": 1, "terminated": False,
         "gamma": 0.9},
        {"q": np.array([[1.5, 0.0], [-3e4, -12500.0]]), "r": -100.0, "s_next": 1, "terminated": False, "gamma": 0.8},
    ],
    mistakes=mistakes.TARGET,
    hints=(
        "Two cases: after a terminated step nothing follows. After any other, s' is worth what its best action is.",
        "The row of s' is q[s_next], and its largest number max(q[s_next]). It counts γ times, and r comes on top.",
        "if terminated: return r. And below it, for all other steps: return r + gamma * (the largest of q[s_next]).",
    ),
    gained="The line between terminated and truncated trips up many who have done this for years. Your target keeps to "
    "it, and every method of this course has a target like yours.",
)  # fmt: skip

ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.1, 0.3, 0.7, 0.05, 0.2, 0.4, 0.3)
GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9, 0.7, 0.8)
AT_A_WALL = (
    {"s": 4, "a": 1, "r": -2.0, "s_next": 4, "terminated": False},
    {"s": 4, "a": 0, "r": -0.02, "s_next": 4, "terminated": False},  # it stays, and a is the best action there
)

update = Exercise(
    task="change q[s, a] by α times the TD error",
    right=solutions.update,
    memory={"q": Q},
    lenders={"target": "your function of the exercise above: run its cell first"},
    tape=[
        {name: row[name] for name in ("s", "a", "r", "s_next", "terminated")} | {"alpha": alpha, "gamma": gamma}
        for row, alpha, gamma in zip(
            (*TAPE, *AT_A_WALL), ALPHAS, GAMMAS, strict=True
        )
    ],
    mistakes=mistakes.UPDATE,
    hints=(
        "Only one number of the table changes, q[s, a]. It goes the share α of the way to the target.",
        "Give the gap a name: delta = target(q, r, s_next, terminated, gamma) - q[s, a]. Then change q[s, a].",
        "Below delta = … comes one more line: q[s, a] += alpha * delta. Nothing is returned.",
    ),
    gained="This is Q-learning, the whole of it. In the next section it gets the steps of a robot.",
)  # fmt: skip


class Chooser:
    """What the loop of the exercise calls to choose: the best action, or another one, always without chance."""

    def __init__(self, rank: int) -> None:
        self.rank = rank

    def __call__(self, *arguments: Any) -> int:
        """An action. Raises TypeError for other arguments than (q, s)."""
        return self._action(*in_order("choose", ("q", "s"), arguments))

    def _action(self, q: np.ndarray, s: int) -> int:
        """The action of this rank, 0 for the worst."""
        return int(q[s].argsort(kind="stable")[self.rank])


class Wavering(Chooser):
    """A choice that the smallest change of the table changes: it tells who chooses before the update."""

    def _action(self, q: np.ndarray, s: int) -> int:
        return (super()._action(q, s) + int(1000 * q.sum())) % 3


def learner(alpha: float, gamma: float) -> Callable[..., None]:
    """The update that the loop of the exercise calls."""

    def update(*arguments: Any) -> None:
        learn_from(*in_order("update", ("q", "s", "a", "r", "s_next", "terminated"), arguments))

    def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, terminated: bool) -> None:
        q[s, a] += alpha * (r + (0.0 if terminated else gamma * q[s_next].max()) - q[s, a])

    return update


WORLD = TapeWorld()

learn = Exercise(
    task="choose, step, update, and go on from the next state, or from a reset where an episode has ended",
    right=solutions.learn,
    memory={"env": TapeWorld(), "q": Q[:4]},
    # every call stops within an episode, so that it does not matter whether one resets at once or when going on
    tape=[
        {"choose": Chooser(rank), "update": learner(alpha, gamma), "steps": n}
        for rank, alpha, gamma, n in ((1, 0.1, 0.9, 4), (2, 0.5, 0.7, 2), (0, 0.3, 0.8, 9), (1, 0.25, 0.9, 1))
    ]
    + [{"choose": Wavering(1), "update": learner(0.4, 0.9), "steps": 7}]
    + [{"env": WORLD, "choose": Fickle(WORLD), "update": learner(0.2, 0.9), "steps": 9}],
    mistakes=loop_mistakes.LEARN,
    hints=(
        "Before the loop comes one line, and in it four things: choose, step, update, go on.",
        "a = choose(q, s), then s_next, r, terminated, truncated = env.step(a), then update(…). Then s becomes s_next, "
        "or what env.reset() returns.",
        "The last lines of the loop: s = s_next; and below it, if terminated or truncated: s = env.reset().",
    ),
    gained="Update and loop: that is a learning robot. At the end of this lesson it drives, by your code alone.",
)  # fmt: skip

look_ahead = Question(
    task="the discount rate γ with which a reward ten steps ahead counts one half",
    right=solutions.look_ahead,
    because="0.933 to the power of 10 is one half. A rule of thumb: γ looks about 1 / (1 − γ) steps ahead, here 15.",
    mistakes=[
        Mistake("with γ = 0.5 a reward halves at every step: ten steps ahead it counts 0.001 times.", 0.5),
        Mistake("this is 0.5 / 10. Discounting multiplies: γ · γ · … · γ, ten times, must be one half.", 0.05),
        Mistake("this takes 0.05 off at each step. Discounting multiplies: 0.95 to the power of 10 is 0.6.", 0.95),
        Mistake("this is 0.5 to the power of 10. You want the opposite, the tenth root of 0.5.", 0.5**10),
        Mistake("with γ = 0.9 it counts 0.35 times: too little.", 0.9),
        Mistake("this is how much the reward counts with γ = 0.9. Which γ makes it count 0.5 times?", 0.9**10),
        Mistake("nearly: 0.93 to the power of 10 is 0.48. Give three digits.", 0.93),
        Mistake("this is the fourth root of 0.5, as in the hint's example. You need the tenth.", 0.5**0.25),
        Mistake("this is the square root of 0.5. You need the tenth root.", 0.5**0.5),
        Mistake("this is the ninth root. The reward lies ten steps ahead: γ to the power of 10.", 0.5 ** (1 / 9)),
        Mistake("this is the eleventh root. The reward lies ten steps ahead: γ to the power of 10.", 0.5 ** (1 / 11)),
        Mistake("this is the logarithm of γ. Take e to the power of it.", float(np.log(0.5) / 10)),
        Mistake("a γ above 1 would make later rewards count more. This is the tenth root of 2; take that of 0.5.",
                2**0.1),
        Mistake("this is 10 to the power of 0.5, the square root of 10. You have swapped base and exponent.", 10**0.5),
        Mistake("this is 0.1 to the power of 0.5. You have swapped base and exponent.", 0.1**0.5),
        Mistake("this is 0.5 · 10. Discounting multiplies γ by itself, ten times.", 5.0),
        Mistake("nearly: 0.94 to the power of 10 is 0.54. Give three digits, or the formula.", 0.94),
        Mistake("nearly: 0.92 to the power of 10 is 0.43. Give three digits, or the formula.", 0.92),
        Mistake("this is 0.5 divided by the root of 10. What you want is the tenth root of 0.5.", 0.5 / 10**0.5),
        Mistake("the root alone is γ. You multiplied it by 10.", 10 * 0.5**0.1),
        Mistake("this is 1 − γ. γ itself is the tenth root of 0.5.", 1 - 0.5**0.1),
    ],
    hints=(
        "γ multiplied by itself ten times is to be 0.5. What undoes “to the power of 10”?",
        "The tenth root of 0.5, and a root is a power, too: the fourth root of x is x ** 0.25.",
        "0.5 ** (1 / …): which root is it?",
    ),
    gained="Now you can say how far ahead a robot looks, and choose γ by it.",
)  # fmt: skip
