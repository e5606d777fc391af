"""Exercises of lesson 02: Q-learning."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE, TapeWorld
from rlrobot_edu.course.lesson_02 import solutions

by_hand = Question(
    task="the new Q(s, a), computed by hand",
    right=solutions.by_hand,
    because="4 + 0.1 · (10 + 0.9 · 5 − 4) = 5.05: one tenth of the way from 4 to the target of 14.5.",
    mistakes=[
        Mistake("this is the target itself. With α = 0.1, Q goes only a tenth of the way towards it.", 14.5),
        Mistake("you forgot γ: the value of the next state counts 0.9 times.", 5.1),
        Mistake("you added α times the target. The TD error is the target minus the old Q(s, a).", 5.45),
        Mistake("the next state counts, too: add γ times its best value to the reward.", 4.6),
        Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", 10.5),
        Mistake("this is the step α · δ. Add it to the old Q(s, a).", 1.05),
        Mistake("from the next state its best action counts: 5, not 3.7.", 4.933),
        Mistake("from the next state its best action counts: 5, not −1.", 4.51),
        Mistake("from the next state its best action counts: 5, not the mean.", 4.831),
    ],
)

target = Exercise(
    task="return what Q(s, a) should have been, r + γ · max Q(s', ·)",
    right=solutions.target,
    returns="target",
    tape=[{"q": Q_START, "gamma": 0.9} | {name: row[name] for name in ("r", "s_next", "terminated")} for row in TAPE],
    mistakes=[
        Mistake("this bootstraps past the end. After a terminal step nothing follows, so the target is the reward "
                "alone.", {"if terminated:": "if False:"}),
        Mistake("you forgot γ, which makes later rewards count less.", {"gamma * ": ""}),
        Mistake("this is what action 0 is worth in s', not what the best action is worth.",
                {"max(q[s_next])": "q[s_next, 0]"}),
        Mistake("argmax tells which action is best; the target needs how much it is worth. That is max.",
                {"max(q[s_next])": "q[s_next].argmax()"}),
        Mistake("this is the mean over the actions of s'. Q-learning assumes that the best one will be taken.",
                {"max(q[s_next])": "q[s_next].mean()"}),
        Mistake("this is the best value in the whole table. Only the row of s' counts.", {"max(q[s_next])": "q.max()"}),
        Mistake("γ discounts what comes later; the reward of this step counts in full.",
                {"return r\n": "return gamma * r\n", "r + gamma * max(q[s_next])": "gamma * (r + max(q[s_next]))"}),
    ],
)  # fmt: skip

update = Exercise(
    task="change q[s, a] by α times the TD error",
    right=solutions.update,
    memory={"q": Q_START},
    tape=[row | {"alpha": 0.1, "gamma": 0.9} for row in TAPE],
    mistakes=[
        Mistake("this bootstraps past the end. After a terminal step nothing follows, so the target is the reward "
                "alone.", {"terminated": "False"}),
        Mistake("you forgot γ, which makes later rewards count less.", {"gamma": "1"}),
        Mistake("the TD error is the target minus the old q[s, a]; here the old value is not taken off.",
                {" - q[s, a]": ""}),
        Mistake("q[s, a] should change by α · δ. You replaced it: write += instead of =.",
                {"q[s, a] + alpha": "alpha"}),
        Mistake("q[s, a] jumps to the target. It should go only the share α of the way.", {"alpha * delta": "delta"}),
        Mistake("the pair that learns is (s, a), where the step began, not s'.", {"q[s, a]": "q[s_next, a]"}),
        Mistake("only the action that was taken learns: change q[s, a], not the whole row q[s].", {"q[s, a]": "q[s]"}),
        Mistake("the value of what follows is that of the next state s', not of s.", {"s_next": "s"}),
        Mistake("in s' the best action counts, not the old action a once more.",
                {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * q[s_next, a]"}),
        Mistake("the table is as it was. Write the new value into q[s, a]; to return it is not enough.",
                {"q[s, a] = ": "return "}),
    ],
)  # fmt: skip


def best(q: np.ndarray, s: int) -> int:
    """Choose without chance."""
    return int(q[s].argmax())


def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, terminated: bool) -> None:
    """The update that the loop calls."""
    q[s, a] += 0.1 * (r + (0.0 if terminated else 0.9 * q[s_next].max()) - q[s, a])


learn = Exercise(
    task="choose, step, update, and go on from the next state, or from a reset where an episode has ended",
    right=solutions.learn,
    memory={"env": TapeWorld(), "q": Q_START},
    tape=[{"choose": best, "update": learn_from, "steps": n} for n in (1, 2, 4, 9)],
    mistakes=[
        Mistake("after the end of an episode the world must be reset, which gives a new s.",
                {"if terminated or truncated:": "if False:"}),
        Mistake("the next step starts where this one ended: you forgot s = s_next.", {"s = s_next": "pass"}),
        Mistake("truncated only means that time is up: the world goes on, so the target keeps its second part. Hand "
                "terminated alone to update.", {"s_next, terminated)": "s_next, terminated or truncated)"}),
        Mistake("an episode also ends when it is truncated. Reset then, too.", {" or truncated": ""}),
        Mistake("s has become s_next before the update. Update first, move on afterwards.",
                {"update(": "s = s_next; update("}),
        Mistake("reset belongs before the loop, and where an episode ends; here every step starts anew.",
                {"s = env.reset()\n    for _ in range(steps):": "for _ in range(steps):\n        s = env.reset()"}),
        Mistake("at the end of an episode the loop should go on with a new one until all steps are done.",
                {"truncated:\n            s = env.reset()": "truncated:\n            break"}),
        Mistake("the last step of an episode teaches something, too: update first, then reset.",
                {"update(": "if not (terminated or truncated): update("}),
    ],
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
        Mistake("nearly: 0.93 to the power of 10 is 0.48. Give three digits.", 0.93),
        Mistake("this is the fourth root of 0.5, as in the hint's example. You need the tenth.", 0.5**0.25),
        Mistake("this is 10 to the power of 0.5, the square root of 10. You have swapped base and exponent.", 10**0.5),
    ],
)
