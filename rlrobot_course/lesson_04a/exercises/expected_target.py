"""The target of expected SARSA."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import DISCOUNTS_THE_REWARD, FORGOT_GAMMA
from rlrobot_course.tapes import Q_START, TAPE


def expected_target(q, p, r, s_next, terminated, gamma):
    if terminated:
        return r
    return r + gamma * sum(p * q[s_next])


# Another world for the last cases: two actions, and values with many digits.
OTHER_Q = np.array([[-0.4871, 1.0032], [2.7183, -3.1416], [0.1234, -0.5772]])

# How probable each action is in s'. The most probable one is not always the best, as after a change of Q.
POLICIES = ((0.8, 0.15, 0.05), (0.5, 0.3, 0.2), (0.2, 0.5, 0.3), (0.0, 1.0, 0.0), (0.6, 0.3, 0.1))

OTHER_CASES = (
    {"q": OTHER_Q, "p": np.array((0.37, 0.63)), "gamma": 0.5, "r": -0.3, "s_next": 0, "terminated": False},
    {"q": OTHER_Q, "p": np.array((0.1, 0.9)), "gamma": 0.99, "r": 0.0, "s_next": 2, "terminated": False},
    {"q": OTHER_Q, "p": np.array((0.2, 0.8)), "gamma": 0.7, "r": -1.25, "s_next": 1, "terminated": True},
)

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return r + γ · the mean of Q(s', ·), each action weighted with its probability",
    right=expected_target,
    returns="target",
    tape=[
        {"q": Q_START, "p": np.array(p), "gamma": gamma} | {name: row[name] for name in ("r", "s_next", "terminated")}
        for p, gamma, row in zip(POLICIES, (0.9, 0.8, 0.95, 0.7, 0.9), TAPE, strict=False)
    ]
    + [*OTHER_CASES],
    hints=(
        "a mean in which the likelier counts more: each value times its probability, and all of that added up.",
        "p * q[s_next] is an array, one weighted value for each action. What is asked is its sum.",
        "r if terminated else r + gamma * sum(…), and inside it the line of the second hint",
    ),
    gained="No a' is drawn, so no luck is in the target: you have traded chance for a sum. With p greedy it is "
    "Q-learning, so one function now holds both.",
    mistakes={
        "past_the_end": Mistake(
            "this bootstraps past the end. After a terminal step nothing follows, so the target is the reward alone.",
            {"if terminated:": "if False:"},
        ),
        "inverted": Mistake(
            "the if is the wrong way round: the reward stands alone where the episode has ended.",
            {"if terminated:": "if not terminated:"},
        ),
        "no_reward_at_the_end": Mistake("at the end the target is the reward, not 0.", CHANGED["no_reward_at_the_end"]),
        "no_gamma": Mistake(FORGOT_GAMMA, {"gamma * ": ""}),
        "no_reward": Mistake("the reward is missing: it is r + γ · the mean.", {"r + gamma": "gamma"}),
        "q_learning": Mistake(
            "this is Q-learning's target: the best action as if it were certain. Weight every action with p.",
            {"sum(p * q[s_next])": "q[s_next].max()"},
        ),
        "mean": Mistake(
            "here all actions count alike. Those that are likelier should count more: weight each with p.",
            {"sum(p * q[s_next])": "q[s_next].mean()"},
        ),
        "sum": Mistake(
            "here the values are only added up. Those that are likelier should count more: weight each with p.",
            {"sum(p * q[s_next])": "q[s_next].sum()"},
        ),
        "likeliest": Mistake(
            "this takes the likeliest action as if it were certain. The others happen, too: weight each with p.",
            {"sum(p * q[s_next])": "q[s_next, p.argmax()]"},
        ),
        "likeliest_weighted": Mistake(
            "only the likeliest action counts here. Weight every action with its probability, and add up.",
            {"sum(p * q[s_next])": "(p.max() * q[s_next, p.argmax()])"},
        ),
        "best_weighted": Mistake(
            "only the best action counts here. Weight every action with its probability, and add up.",
            {"sum(p * q[s_next])": "(p[q[s_next].argmax()] * q[s_next].max())"},
        ),
        "largest_weighted": Mistake(
            "the largest of the weighted values is not enough: they are added up, all of them.",
            {"sum(p * q[s_next])": "max(p * q[s_next])"},
        ),
        "not_added_up": Mistake(
            "this is one number for each action. Add the weighted values up: the target is a single number.",
            {"sum(p * q[s_next])": "p * q[s_next]"},
        ),
        "reward_for_each": Mistake(
            "the reward and γ belong to the whole sum, once: here there is one number for each action.",
            {"r + gamma * sum(p * q[s_next])": "p * (r + gamma * q[s_next])"},
        ),
        "averaged_twice": Mistake(
            "weighted twice: p already sums to 1, so the weighted values are added up, not averaged.",
            {"sum(p * q[s_next])": "(p * q[s_next]).mean()"},
        ),
        "adds_probabilities": Mistake(
            "this adds probabilities to values. Multiply each value with its probability.",
            {"sum(p * q[s_next])": "sum(p + q[s_next])"},
        ),
        "one_minus_p": Mistake("an action with probability p counts p, not 1 − p.", {"sum(p *": "sum((1 - p) *"}),
        "p_of_s_next": Mistake(
            "p is already the row for s_next, one probability for each action: it needs no index.",
            {"p * q[s_next]": "p[s_next % len(p)] * q[s_next]"},
        ),
        "takes_the_best_off": Mistake(
            "the best value has no place here: the target is r + γ · the mean, and nothing is taken off.",
            {"sum(p * q[s_next])": "sum(p * q[s_next]) - q[s_next].max()"},
        ),
        "not_below_zero": Mistake(
            "a value may be negative: max and abs do not belong here.",
            {"sum(p * q[s_next])": "max(0, sum(p * q[s_next]))"},
        ),
        "discounts_every_reward": Mistake(DISCOUNTS_THE_REWARD, CHANGED["discounts_every_reward"]),
        "discounts_the_reward": Mistake(
            DISCOUNTS_THE_REWARD,
            {"r + gamma * sum(p * q[s_next])": "gamma * (r + sum(p * q[s_next]))"},
        ),
        "first_row": Mistake(
            "this takes the first row of q. What follows is in the row of s_next.", {"q[s_next]": "q[0]"}
        ),
        "whole_table": Mistake(
            "this takes the whole table. What follows is in the row of s_next alone.",
            {"sum(p * q[s_next])": "(p * q).sum()"},
        ),
    },
    witnesses=WITNESSES,
)
