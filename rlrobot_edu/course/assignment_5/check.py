"""Exercises of assignment 5: a reward, inputs, the value of a policy by a recording, an interval and a verdict."""

from __future__ import annotations

from rlrobot_edu.course.assignment_5 import mistakes, solutions
from rlrobot_edu.course.assignment_5.parking import PAIRS, words
from rlrobot_edu.course.grading.design import Design
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question

park_reward = Design(
    task="return a number that is largest for standing 0.15 to 0.35 m in front of a wall, smallest for touching one, "
    "and larger for coming nearer than for standing afar",
    right=solutions.park_reward,
    returns="more is paid when it",
    words=words,
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes=mistakes.PARK,
    hints=(
        "Three questions, in this order: does it touch? If not, is it parked? If not, has the wall ahead come nearer?",
        "Touching: the smallest of three lasers of after is below 0.05. Parked: 0.15 < front <= 0.35, and moved "
        "less than 0.01 m.",
        "Coming nearer: front > 0.35 and front < before[\"laser_front\"] - 0.01. Pay −2, 10, 1, and 0 for the rest.",
    ),
    gained="A robot will take it at its word, below.",
)  # fmt: skip

inputs = Question(
    task='the letters of the inputs that a state needs, such as "BC"',
    right=solutions.inputs,
    because="The front laser tells whether it is parked, and the two beside it whether it is about to touch. Nothing "
    "else tells anything about the next reward that these three do not.",
    mistakes=[
        Mistake("who sees only what is ahead learns nothing about walls that are touched beside it.", "A"),
        Mistake("the wall ahead decides whether the robot is parked, so which input tells it?", "DE"),
        Mistake("and on the other side? A wall may be touched left and right.", "AD"),
        Mistake("and on the other side? A wall may be touched left and right.", "AE"),
        Mistake("where it is in this arena tells where walls are only here, and the lasers tell it anywhere. It makes "
                "four times as many states.", "ABDE"),
        Mistake("the reward asks nothing about the heading: a wall is a wall. It makes eight times as many states.",
                "ACDE"),
        Mistake("this robot never drives backward, so what is behind it cannot be touched.", "ADEF"),
        Mistake("the time since the start tells nothing about the next reward.", "ADEG"),
        Mistake("all of them: that are thousands of states, most of which are never met twice. Which readings does the "
                "reward ask for?", "ABCDEFG"),
        Mistake("that was only to show how it is written.", "BC"),
        Mistake("a map would do where nothing ever changes: but the heading alone has eight sectors of 45°, and a step "
                "is 0.1 m. The lasers tell it finer and with fewer states.", "ABC"),
    ],
    hints=(
        "Which readings does your reward look at after the step? The state must let the robot foresee them.",
        "Three of the seven are enough, and they are of one kind.",
        "The laser that looks ahead, and the two that look to the left and the right of it.",
    ),
    gained="4 · 2 · 2 = 16 states: an afternoon's exercise for a table.",
)  # fmt: skip

ROWS = [
    (0, 0, 1.5, 1), (0, 0, 2.5, 0), (0, 1, -3.5, 2), (1, 1, 4.5, 2), (1, 1, 0.5, 1), (1, 1, 1.25, 0), (1, 0, 9.5, 1),
    (2, 0, -0.5, 0), (0, 0, 1.5, 1), (2, 1, 7.5, 2),
]  # fmt: skip

value_of = Exercise(
    task="return the value of each state under the policy, after so many sweeps over the recording",
    right=solutions.value_of,
    returns="v",
    tape=[
        {"rows": rows, "policy": policy, "n_states": n, "gamma": gamma, "sweeps": sweeps}
        for rows, policy, n, gamma, sweeps in (
            (ROWS, [0, 1, 0], 3, 0.9, 1), (ROWS, [0, 1, 0], 3, 0.8, 2), (ROWS, [1, 0, 1], 3, 0.75, 12),
            (ROWS[:6], [0, 1, 1], 3, 0.9, 3), (ROWS, [0, 1, 0], 3, 0.5, 40), ([], [0, 0], 2, 0.9, 5),
        )
    ],
    mistakes=mistakes.VALUE,
    hints=(
        "One state, one sweep: look for the rows that begin in s with policy[s]. What has each of them come to, and "
        "what is their mean?",
        "Of one row it is r + gamma * old[s_next], old being the values before this sweep: old = v.copy().",
        "seen = [r + gamma * old[s_next] for s_row, a, r, s_next in rows if …]; v[s] = sum(seen) / len(seen), or 0 if "
        "there is none.",
    ),
    gained="A recording of one robot tells what another would earn that behaves otherwise, and nobody had to drive.",
)  # fmt: skip

EARNED = [2.5, 3.25, 1.75, 4.5, 3.0]
LIKE = [x - 0.25 + 0.0625 * i for i, x in enumerate(EARNED)]  # a little less, nearly the same pair by pair

interval = Exercise(
    task="return the two ends of the interval of the mean",
    right=solutions.interval,
    returns="interval",
    tape=[
        {"values": EARNED, "t": 2.78},
        {"values": [0.5, -1.5], "t": 12.7},
        {"values": [1.25, 1.25, 1.25], "t": 4.3},
        {"values": [10.5, 0.25, -3.5, 8.75, 2.0, 2.25, 1.5], "t": 2.45},
        {"values": [-0.5, -0.75, -1.0, -0.25], "t": 3.18},
    ],
    mistakes=mistakes.INTERVAL,
    hints=(
        "Mean first. Then half the width: t times the standard deviation of one robot, divided by the root of n.",
        "np.std(values, ddof=1) divides by n − 1, and np.sqrt(len(values)) is the root of n.",
        "half = t * np.std(values, ddof=1) / np.sqrt(n), and then [mean - half, …].",
    ),
    gained="With four times as many robots it is half as wide: that is what a second decimal costs.",
)

verdict = Exercise(
    task='return "first", "second" or "open"',
    right=solutions.verdict,
    returns="verdict",
    lenders={"interval": "your function of exercise 4"},
    tape=[
        {"first": EARNED, "second": LIKE, "t": 2.0},
        {"first": LIKE, "second": EARNED, "t": 2.0},
        {"first": EARNED, "second": EARNED[::-1], "t": 2.78},
        {"first": EARNED, "second": EARNED, "t": 2.78},
        {"first": [5.5, 6.25, 5.75], "second": [1.25, 0.5, 2.5], "t": 4.3},
        {"first": [1.25, 0.5, 2.5], "second": [5.5, 6.25, 5.75], "t": 4.3},
        {"first": [1.0, 3.5, 1.25, 2.5], "second": [1.5, 2.0, 1.5, 1.75], "t": 3.18},
        {"first": [1.5, 2.0, 1.5, 1.75], "second": [1.0, 3.5, 1.25, 2.5], "t": 3.18},
        {"first": [2.5, 2.75, 3.0, 3.5, 4.0, 4.5], "second": [2.625, 2.0, 2.25, 2.75, 3.0, 3.5], "t": 2.57},
    ],
    mistakes=mistakes.VERDICT,
    hints=(
        "Number i of both lists had the same luck with its world. What is left if you take one from the other?",
        "low, high = interval(np.subtract(first, second), t). Where does 0 lie?",
        'if low > 0: return "first"; if high < 0: return "second"; and below both return "open".',
    ),
    gained="Open is a result, too, and the honest one more often than papers tell.",
)
