"""The probabilities of the greedy policy, with ties."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def greedy(q):
    best = q == np.max(q, axis=1, keepdims=True)
    return best / best.sum(axis=1, keepdims=True)


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return an array of probabilities: in each state the best actions share 1 equally",
    right=greedy,
    returns="policy",
    tape=[
        {"q": np.array([[1.5, 2.5, 0.5], [0.25, -1.0, -2.0]])},
        {"q": np.array([[2.5, 2.5, 0.5], [0.0, 0.0, 0.0], [-3.5, -1.5, -1.5]])},
        {"q": np.array([[-0.5, -1.5]])},
        {"q": np.array([[0.0, 3.5, 3.5, 3.5], [5.5, 0.0, 5.5, 1.0]])},
        {"q": np.array([[0.5, 1.25, 0.75], [7.5, 7.25, 7.0], [0.0, 0.125, -2.5]])},
    ],
    mistakes={
        "not_shared": Mistake(
            "the best actions share 1: where two are best, each gets 1/2.",
            {"best / best.sum(axis=1, keepdims=True)": "best * 1.0"},
        ),
        "argmax": Mistake(
            "argmax marks the first of several best actions. All of them are best: compare with the largest value.",
            {"best = q == np.max(q, axis=1, keepdims=True)": "best = np.eye(q.shape[1])[q.argmax(axis=1)]"},
        ),
        "best_of_the_table": Mistake(
            "this compares with the largest value of the whole table. Each state has its own best: axis=1.",
            {
                "np.max(q, axis=1, keepdims=True)": "q.max()",
                "best.sum(axis=1, keepdims=True)": "best.sum(axis=1, keepdims=True).clip(1)",
            },
        ),
        "best_of_a_column": Mistake(
            "axis=0 goes down a column, one action in all states. A state is a row: axis=1.",
            {
                "max(q, axis=1": "max(q, axis=0",
                "best.sum(axis=1, keepdims=True)": "best.sum(axis=1, keepdims=True).clip(1)",
            },
        ),
        "worst": Mistake("these are the worst actions of each state: max, not min.", {"np.max": "np.min"}),
        "sum_of_the_table": Mistake(
            "each state has probabilities of its own, that sum to 1 in each row. Divide by the sum of the row.",
            {"best.sum(axis=1, keepdims=True)": "best.sum()"},
        ),
        "softmax": Mistake(
            "a greedy policy gives every action that is not best the probability 0.", CHANGED["softmax"]
        ),
    },
    hints=(
        "In each row of q, which entries are as large as the row's largest? Each of them gets 1 / (how many they are).",
        "q.max(axis=1, keepdims=True) is a column, the best value of each state; q == that column marks the best ones.",
        "best = q == q.max(axis=1, keepdims=True), and then best / (how many there are in each row, as a column).",
    ),
    gained="A policy is a table, too. An untried state shares equally: it knows nothing, and says so.",
    witnesses=WITNESSES,
)
