"""Exercise of lesson 04a: Expected SARSA's target."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.course.lesson_04a import solutions

# Another world for the last cases: two actions, and values with many digits.
OTHER_Q = np.array([[-0.4871, 1.0032], [2.7183, -3.1416], [0.1234, -0.5772]])
# How probable each action is in s'. The most probable one is not always the best, as after a change of Q.
POLICIES = ((0.8, 0.15, 0.05), (0.5, 0.3, 0.2), (0.2, 0.5, 0.3), (0.0, 1.0, 0.0), (0.6, 0.3, 0.1))
OTHER_CASES = (
    {"q": OTHER_Q, "p": np.array((0.37, 0.63)), "gamma": 0.5, "r": -0.3, "s_next": 0, "terminated": False},
    {"q": OTHER_Q, "p": np.array((0.1, 0.9)), "gamma": 0.99, "r": 0.0, "s_next": 2, "terminated": False},
    {"q": OTHER_Q, "p": np.array((0.2, 0.8)), "gamma": 0.7, "r": -1.25, "s_next": 1, "terminated": True},
)

expected_target = Exercise(
    task="return r + γ · the mean of Q(s', ·), each action weighted with its probability",
    right=solutions.expected_target,
    returns="target",
    tape=[
        {"q": Q_START, "p": np.array(p), "gamma": gamma} | {name: row[name] for name in ("r", "s_next", "terminated")}
        for p, gamma, row in zip(POLICIES, (0.9, 0.8, 0.95, 0.7, 0.9), TAPE, strict=False)
    ] + [*OTHER_CASES],
    hints=(
        "a mean in which the likelier counts more: each value times its probability, and all of that added up.",
        "p * q[s_next] is an array, one weighted value for each action. What is asked is its sum.",
        "r if terminated else r + gamma * sum(…), and inside it the line of the second hint",
    ),
    gained="No a' is drawn, so no luck is in the target: you have traded chance for a sum. With p greedy it is "
    "Q-learning, so one function now holds both.",
    mistakes=[
        Mistake("this bootstraps past the end. After a terminal step nothing follows, so the target is the reward "
                "alone.", {"if terminated:": "if False:"}),
        Mistake("the if is the wrong way round: the reward stands alone where the episode has ended.",
                {"if terminated:": "if not terminated:"}),
        Mistake("at the end the target is the reward, not 0.", {"return r\n": "return 0\n"}),
        Mistake("you forgot γ, which makes later rewards count less.", {"gamma * ": ""}),
        Mistake("the reward is missing: it is r + γ · the mean.", {"r + gamma": "gamma"}),
        Mistake("this is Q-learning's target: the best action as if it were certain. Weight every action with p.",
                {"sum(p * q[s_next])": "q[s_next].max()"}),
        Mistake("here all actions count alike. Those that are likelier should count more: weight each with p.",
                {"sum(p * q[s_next])": "q[s_next].mean()"}),
        Mistake("here the values are only added up. Those that are likelier should count more: weight each with p.",
                {"sum(p * q[s_next])": "q[s_next].sum()"}),
        Mistake("this takes the likeliest action as if it were certain. The others happen, too: weight each with p.",
                {"sum(p * q[s_next])": "q[s_next, p.argmax()]"}),
        Mistake("only the likeliest action counts here. Weight every action with its probability, and add up.",
                {"sum(p * q[s_next])": "(p.max() * q[s_next, p.argmax()])"}),
        Mistake("only the best action counts here. Weight every action with its probability, and add up.",
                {"sum(p * q[s_next])": "(p[q[s_next].argmax()] * q[s_next].max())"}),
        Mistake("the largest of the weighted values is not enough: they are added up, all of them.",
                {"sum(p * q[s_next])": "max(p * q[s_next])"}),
        Mistake("this is one number for each action. Add the weighted values up: the target is a single number.",
                {"sum(p * q[s_next])": "p * q[s_next]"}),
        Mistake("the reward and γ belong to the whole sum, once: here there is one number for each action.",
                {"r + gamma * sum(p * q[s_next])": "p * (r + gamma * q[s_next])"}),
        Mistake("here the values are only added up. Those that are likelier should count more: weight each with p.",
                {"sum(p * q[s_next])": "sum(p) * sum(q[s_next])"}),
        Mistake("weighted twice: p already sums to 1, so the weighted values are added up, not averaged.",
                {"sum(p * q[s_next])": "(p * q[s_next]).mean()"}),
        Mistake("this adds probabilities to values. Multiply each value with its probability.",
                {"sum(p * q[s_next])": "sum(p + q[s_next])"}),
        Mistake("an action with probability p counts p, not 1 − p.", {"sum(p *": "sum((1 - p) *"}),
        Mistake("a value may be negative: max and abs do not belong here.",
                {"sum(p * q[s_next])": "max(0, sum(p * q[s_next]))"}),
        Mistake("γ discounts what comes later; the reward of this step counts in full.",
                {"return r\n": "return gamma * r\n",
                 "r + gamma * sum(p * q[s_next])": "gamma * (r + sum(p * q[s_next]))"}),
        Mistake("γ discounts what comes later; the reward of this step counts in full.",
                {"r + gamma * sum(p * q[s_next])": "gamma * (r + sum(p * q[s_next]))"}),
        Mistake("this takes the first row of q. What follows is in the row of s_next.", {"q[s_next]": "q[0]"}),
        Mistake("this takes the whole table. What follows is in the row of s_next alone.",
                {"sum(p * q[s_next])": "(p * q).sum()"}),
    ],
)  # fmt: skip
