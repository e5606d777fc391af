"""Exercises of assignment 1: state, return, replay of a log, greedy policy, the whole learner."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.assignment_1 import mistakes, solutions
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.grading.tapes import Q_START, Chooser, PatientWorld

VOLTS = [11.25, 11.75, 12.25]


def other_cell(rng: np.random.Generator, case: Case) -> Case:
    """A case of `state_of` in another cell, its voltages moved; what lies on a cut stays there."""
    volts = float(rng.uniform(-0.9, 0.9))
    cuts = [cut + volts for cut in case["cuts"]]
    return {"cell": case["cell"] + int(rng.integers(1, 4)), "voltage": case["voltage"] + volts, "cuts": cuts}


state_of = Exercise(
    task="return the number of the state: the cell counts most, the bin of the voltage least",
    right=solutions.state_of,
    returns="state",
    tape=[
        {"cell": 0, "voltage": 11.0, "cuts": VOLTS},
        {"cell": 0, "voltage": 12.0, "cuts": VOLTS},
        {"cell": 2, "voltage": 12.5, "cuts": VOLTS},
        {"cell": 1, "voltage": 11.75, "cuts": VOLTS},
        {"cell": 5, "voltage": 11.5, "cuts": [11.25]},
        {"cell": 3, "voltage": 13.0, "cuts": [11.0, 11.5, 12.0, 12.5, 13.5]},
        {"cell": 1, "voltage": 9.0, "cuts": VOLTS},
    ],
    mistakes=mistakes.STATE_OF,
    another=other_cell,
    hints=(
        "First the bin: how many cuts lie below the voltage? Then the number: how many states has each cell?",
        "k cuts make k + 1 bins. A cell is a block of k + 1 states, one for each bin: the cell's number times k + 1.",
        "charge = sum(voltage > cut for cut in cuts), and then cell * (len(cuts) + 1) + …",
    ),
    gained="Two readings, one number: from here on the cart is a row of a table. The last exercise learns in it.",
)

returns = Exercise(
    task="return the list of the returns G, one for each step of the day",
    right=solutions.returns,
    returns="returns",
    tape=[
        {"rewards": [-1.0, -1.0, 20.0], "ends": [False, False, True], "gamma": 0.5},
        {"rewards": [-1.0, 20.0, -1.0, -20.0], "ends": [False, True, False, True], "gamma": 0.9},
        {"rewards": [4.0, 2.5, 1.5], "ends": [False, False, False], "gamma": 0.8},
        {"rewards": [7.5], "ends": [True], "gamma": 0.9},
        {"rewards": [3.0, -2.0, 5.0, 1.25, 6.0], "ends": [True, True, False, True, False], "gamma": 0.6},
        {"rewards": [], "ends": [], "gamma": 0.6},
    ],
    mistakes=mistakes.RETURNS,
    hints=(
        "The return of a step is its reward, plus γ times the return of the next step. So begin at the last one.",
        "Go backward: for t in range(len(rewards) - 1, -1, -1). Keep the return that follows in a variable, and set it "
        "to 0 where ends[t] is true.",
        "In the loop, in this order: if ends[t]: follows = 0.0, then g[t] = rewards[t] + gamma * follows, then follows "
        "= …",
    ),
    gained="One pass from the evening to the morning, and each step knows what came of it. The next exercise does so "
    "with Q.",
)

LOG = [(0, 1, -1.5, 1, False), (1, 0, -1.25, 2, False), (2, 2, 20.5, 3, True), (0, 2, -1.0, 0, False),
       (0, 1, -20.0, 3, True)]  # fmt: skip

replay = Exercise(
    task="learn from the steps of the log by Q-learning, the last step first",
    right=solutions.replay,
    memory={"q": Q_START},
    tape=[
        {"log": LOG[:1], "alpha": 0.25, "gamma": 0.9},
        {"log": LOG[2:3], "alpha": 0.5, "gamma": 0.9},
        {"log": LOG[:3], "alpha": 0.5, "gamma": 0.8},
        {"log": LOG, "alpha": 0.1, "gamma": 0.95},
        {"log": [], "alpha": 0.1, "gamma": 0.95},
    ],
    mistakes=mistakes.REPLAY,
    hints=(
        "It is Q-learning's update, once for each step of the log. Only the order is new.",
        "for s, a, r, s_next, terminated in reversed(log): target, TD error, q[s, a]. At an end the target is r alone.",
        "target = r if terminated else r + gamma * max(q[s_next]); and below it q[s, a] += alpha * (…)",
    ),
    gained="Backward, one pass carries the reward of the shelf through a whole way; forward, one step of it.",
)

greedy = Exercise(
    task="return an array of probabilities: in each state the best actions share 1 equally",
    right=solutions.greedy,
    returns="policy",
    tape=[
        {"q": np.array([[1.5, 2.5, 0.5], [0.25, -1.0, -2.0]])},
        {"q": np.array([[2.5, 2.5, 0.5], [0.0, 0.0, 0.0], [-3.5, -1.5, -1.5]])},
        {"q": np.array([[-0.5, -1.5]])},
        {"q": np.array([[0.0, 3.5, 3.5, 3.5], [5.5, 0.0, 5.5, 1.0]])},
        {"q": np.array([[0.5, 1.25, 0.75], [7.5, 7.25, 7.0], [0.0, 0.125, -2.5]])},
    ],
    mistakes=mistakes.GREEDY,
    hints=(
        "In each row of q, which entries are as large as the row's largest? Each of them gets 1 / (how many they are).",
        "q.max(axis=1, keepdims=True) is a column, the best value of each state; q == that column marks the best ones.",
        "best = q == q.max(axis=1, keepdims=True), and then best / (how many there are in each row, as a column).",
    ),
    gained="A policy is a table, too. An untried state shares equally: it knows nothing, and says so.",
)


train = Exercise(
    task="learn for so many episodes, and return the list of their sums of rewards",
    right=solutions.train,
    returns="sums",
    memory={"env": PatientWorld(), "q": Q_START},
    tape=[
        {"choose": Chooser(rank), "episodes": n, "alpha": alpha, "gamma": gamma}
        for rank, n, alpha, gamma in ((0, 1, 0.5, 0.9), (1, 1, 0.1, 0.8), (2, 3, 0.25, 0.9), (0, 2, 0.4, 0.7))
    ],
    mistakes=mistakes.TRAIN,
    hints=(
        "Two loops, one in the other: episodes, and the steps of one. An episode begins with a reset and a sum of 0.",
        "Inside: choose, step, target, q[s, a], add r to the sum, go on from s_next. It is over when terminated or "
        "truncated; only terminated makes the target r alone.",
        "s, total, over = env.reset(), 0.0, False; then while not over: …; and below that loop sums.append(total).",
    ),
    gained="A learner, written by you from its equations. Now let it work.",
)
