"""The target of Q-learning."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import DISCOUNTS_THE_REWARD, FORGOT_GAMMA, IS_TRUE, PAST_THE_END


def target(q, r, s_next, terminated, gamma):
    if terminated:
        return r
    return r + gamma * max(q[s_next])


TILDE = "~ is for arrays: of Python's False it makes −1, and of True −2. Write not terminated."

INVERTED = (
    "if is the wrong way round: the reward alone counts after a terminated step, the value of s' after all others."
)

# as in the other lessons, and a state in which every action is bad
Q = np.array([[0.0, 2.0, 1.0], [4.0, -1.0, 5.5], [0.0, 0.5, 3.0], [5.0, 6.0, 7.0], [-1.375, -3.0, -2.0]])

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return what Q(s, a) should have been, r + γ · max Q(s', ·)",
    right=target,
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
        {"q": Q, "r": 0.37, "s_next": 4, "terminated": np.True_, "gamma": 0.85},  # as a comparison in numpy has it
        {"q": Q[1:3], "r": 10.0, "s_next": 0, "terminated": False, "gamma": 0.25},
        {
            "q": np.array([[0.4, -7.0, 0.1, 0.3], [-8.0, 0.9, -0.5, 1.2]]),
            "r": 0.125,
            "s_next": 1,
            "terminated": False,
            "gamma": 0.9,
        },
        {"q": np.array([[1.5, 0.0], [-3e4, -12500.0]]), "r": -100.0, "s_next": 1, "terminated": False, "gamma": 0.8},
    ],
    mistakes={
        "past_the_end": Mistake(PAST_THE_END, {"if terminated:": "if False:"}),
        "is_true": Mistake(IS_TRUE, {"if terminated:": "if terminated is True:"}),
        "inverted": Mistake(INVERTED, {"if terminated": "if not terminated"}),
        "no_gamma": Mistake(FORGOT_GAMMA, {"gamma * ": ""}),
        "no_reward": Mistake(
            "the reward is missing: it is r plus γ times the best value of s'.", {"r + gamma": "gamma"}
        ),
        "reward_alone": Mistake(
            "this is always the reward alone. Unless the step is terminated, add γ times the best value of s'.",
            {"if terminated:": "if True:"},
        ),
        "nothing_at_the_end": Mistake(
            "after a terminated step the reward still counts: return r, not 0.", CHANGED["nothing_at_the_end"]
        ),
        "none_at_the_end": Mistake(
            "after a terminated step your function returns nothing. There the target is r.", CHANGED["none_at_the_end"]
        ),
        "action_0": Mistake(
            "this is what action 0 is worth in s', not what the best action is worth.",
            {"max(q[s_next])": "q[s_next, 0]"},
        ),
        "last_action": Mistake(
            "this is what the last action is worth in s', not what the best action is worth.",
            {"max(q[s_next])": "q[s_next, -1]"},
        ),
        "argmax": Mistake(
            "argmax tells which action is best; the target needs how much it is worth. That is max.",
            {"max(q[s_next])": "q[s_next].argmax()"},
        ),
        "mean": Mistake(
            "this is the mean over the actions of s'. Q-learning assumes that the best one will be taken.",
            {"max(q[s_next])": "q[s_next].mean()"},
        ),
        "sum": Mistake(
            "this adds up all actions of s'. Only one will be taken, the best: max, not sum.",
            {"max(q[s_next])": "q[s_next].sum()"},
        ),
        "min": Mistake(
            "this is the worst action of s'. Q-learning takes the best: max, not min.",
            {"max(q[s_next])": "min(q[s_next])"},
        ),
        "whole_table": Mistake(
            "this is the best value in the whole table. Only the row of s' counts.", {"max(q[s_next])": "q.max()"}
        ),
        "column": Mistake(
            "q[:, s_next] is a column: one action in all states. The row of s' is q[s_next].",
            {"max(q[s_next])": "max(q[:, s_next])"},
        ),
        "row_before": Mistake(
            "this is the row before: states count from 0, and so do rows, so the row of s' is q[s_next].",
            {"max(q[s_next])": "max(q[s_next - 1])"},
        ),
        "row_after": Mistake(
            "this is the row after: states count from 0, and so do rows, so the row of s' is q[s_next].",
            {"max(q[s_next])": "max(q[s_next + 1])"},
        ),
        "not_below_zero": Mistake(
            "values may be negative. Where all actions are bad, the best of them is still below 0: leave it so.",
            {"max(q[s_next])": "max(0, max(q[s_next]))"},
        ),
        **{
            f"begins_at_minus_{n}": Mistake(
                "the search for the best begins with a number of your own, and all values may lie below it. Begin with "
                "the first of the row, or take max.",
                {"max(q[s_next])": f"max(-{n}, max(q[s_next]))"},
            )
            for n in (1, 2, 10, 100, 999, 1000, 9999)
        },
        "abs_of_each": Mistake(
            "abs takes the sign away, and −3 looks better than 2. Take the largest value as it is.",
            {"max(q[s_next])": "max(abs(q[s_next]))"},
        ),
        "abs_of_the_best": Mistake(
            "abs takes the sign away: a value below 0 is a bad one, and must lower the target.",
            {"max(q[s_next])": "abs(max(q[s_next]))"},
        ),
        "minus_what_follows": Mistake("the value of s' is added to the reward, not taken off.", {"r + ": "r - "}),
        "discounts_every_reward": Mistake(DISCOUNTS_THE_REWARD, CHANGED["discounts_every_reward"]),
        "discounts_the_reward": Mistake(
            DISCOUNTS_THE_REWARD,
            {"r + gamma * max(q[s_next])": "gamma * (r + max(q[s_next]))"},
        ),
        "gamma_at_the_reward": Mistake(
            "γ is at the wrong number: it multiplies what comes later, not the reward.",
            {"r + gamma * max(q[s_next])": "gamma * r + max(q[s_next])"},
        ),
        "brackets": Mistake(
            "brackets: only the value of s' is multiplied, r + γ · max, not (r + γ) · max.",
            {"r + gamma * max(q[s_next])": "(r + gamma) * max(q[s_next])"},
        ),
        "reward_weighs_1_minus_gamma": Mistake(
            "this gives the reward the weight 1 − γ. It counts in full: r + γ · max.",
            {"r + gamma": "(1 - gamma) * r + gamma"},
        ),
        "gamma_squared": Mistake(
            "γ counts once here: s' is one step away. (The rest is already in Q.)", {"gamma * ": "gamma ** 2 * "}
        ),
        "one_minus_gamma": Mistake(
            "1 − γ is how much the future is cut. What comes later counts γ times.", {"gamma * ": "(1 - gamma) * "}
        ),
        "divides_by_gamma": Mistake(
            "γ multiplies what comes later, so that it counts less. You divide by it.", {"gamma * ": "1 / gamma * "}
        ),
        "tilde": Mistake(TILDE, CHANGED["tilde"]),
        "multiplies": Mistake("the reward and the value of s' are added, not multiplied.", {"r + gamma": "r * gamma"}),
        "own_gamma": Mistake(
            "γ is an argument. Use it in place of the number 0.9, so that any γ can be tried.", {"gamma * ": "0.9 * "}
        ),
        "three_actions": Mistake(
            "only three actions are compared here. There may be more or fewer: max goes through the whole row.",
            {"max(q[s_next])": "max(q[s_next][:3])"},
        ),
        "two_actions": Mistake(
            "only two actions are compared here. There may be more: max goes through the whole row.",
            {"max(q[s_next])": "max(q[s_next][:2])"},
        ),
        "first_row": Mistake(
            "this is the first state's row. What follows is in the row of s', q[s_next].",
            {"max(q[s_next])": "max(q[0])"},
        ),
        "max_with_reward": Mistake(
            "max compares γ · Q with the reward here. The two are added: r + γ · max Q(s', ·).",
            {"r + gamma * max(q[s_next])": "max(r, gamma * max(q[s_next]))"},
        ),
    },
    hints=(
        "Two cases: after a terminated step nothing follows. After any other, s' is worth what its best action is.",
        "The row of s' is q[s_next], and its largest number max(q[s_next]). It counts γ times, and r comes on top.",
        "if terminated: return r. And below it, for all other steps: return r + gamma * (the largest of q[s_next]).",
    ),
    gained="The line between terminated and truncated trips up many who have done this for years. Your target keeps to "
    "it, and every method of this course has a target like yours.",
    witnesses=WITNESSES,
)
