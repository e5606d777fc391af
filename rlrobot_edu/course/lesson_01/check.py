"""Exercises of lesson 01: states, rewards and returns."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_01 import solutions
from rlrobot_edu.course.lesson_01.design import PAIRS, Design

LASER = [0.27, 0.53, 0.80]  # cut points [m]
ANGLE = [-45, 0, 45, 90]  # cut points [deg]

bin_of = Exercise(
    task="return the number of the bin that the reading x falls into",
    right=solutions.bin_of,
    returns="bin",
    tape=[{"x": x, "cuts": LASER} for x in (0.30, 0.10, 0.70, 0.53, 2.00, 0.27)]
    + [{"x": x, "cuts": [0.20]} for x in (0.20, 0.21)]
    + [{"x": x, "cuts": ANGLE} for x in (-30, -90, 90, 180)],
    mistakes=[
        Mistake("a reading exactly on a cut point belongs to the bin below it: x ≤ c₁ is bin 0.",
                {"x > cut": "x >= cut"}),
        Mistake("bins are counted from 0, and yours from 1.", {"number = 0": "number = 1"}),
        Mistake("these are the cut points above x. The number of the bin is how many lie below it.",
                {"x > cut": "x <= cut"}),
        Mistake("this is the index of the last cut point below x; the bin's number is one more.",
                {"number = 0": "number = -1"}),
        Mistake("the last bin is missing: k cut points make k + 1 bins, and beyond the last cut is bin k.",
                {"return number": "return min(number, len(cuts) - 1)"}),
        Mistake("only one cut point is looked at. Compare x with every one of them.", {"in cuts": "in cuts[:1]"}),
        Mistake("this is a cut point, and what is asked is the number of the bin.",
                {"if x > cut": "if x <= cut", "number += 1": "return cut", "return number": "return cut"}),
        Mistake("the bins are not equally wide, so dividing does not tell which it is. Compare with the cut points.",
                {"return number": "return int(x // cuts[0])"}),
    ],
)  # fmt: skip

ROBOT = (2, 2, 3, 2)  # bins of the inputs of worked_example

state_number = Exercise(
    task="return the number of the state that has these bins",
    right=solutions.state_number,
    returns="state",
    tape=[{"bins": bins, "shape": ROBOT} for bins in ((1, 0, 1, 1), (0, 1, 2, 0), (0, 0, 0, 1), (1, 1, 2, 1))]
    + [
        {"bins": (2, 1), "shape": (3, 4)},
        {"bins": (1, 3, 0, 2), "shape": (2, 5, 3, 4)},
        {"bins": (4,), "shape": (6,)},
        {"bins": (0, 1, 3, 3, 1), "shape": (4, 4, 4, 4, 4)},
    ],
    mistakes=[
        Mistake("here the first input varies fastest. It should vary slowest: begin with the first bin.",
                {"zip(bins, shape": "zip(bins[::-1], shape[::-1]"}),
        Mistake("each bin is multiplied by the size of its own input, too. Multiply first, then add the bin.",
                {"s * n + b": "(s + b) * n"}),
        Mistake("this is the sum of the bins, which different states share. Each input needs its own weight.",
                {"s * n + b": "s + b"}),
        Mistake("all inputs were taken to have as many bins as the first one. Each has its own number in shape.",
                {"s * n": "s * shape[0]"}),
        Mistake("these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
                "combinations.", {"s * n": "s * 10"}),
        Mistake("states are counted from 0, and yours from 1.", {"return s": "return s + 1"}),
        Mistake("each bin is multiplied by the size of its own input alone. What has been added up so far is to be "
                "multiplied.", {"s * n + b": "s + b * n"}),
        Mistake("the last input is left out.", {"zip(bins, shape": "zip(bins[:-1], shape[:-1]"}),
    ],
)  # fmt: skip

reward = Design(
    task="return a number that is larger for what the robot should do than for what it should not",
    right=solutions.reward,
    returns="more is paid when it",
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes=[
        Mistake("you pay for not touching anything, and who stands still touches nothing. Pay for driving.",
                {"10 if hypot(dx, dy) > 0.07 else -0.02": "1"}),
        Mistake("you pay for open space, and the robot need not move to have it. Compare x and y before and after.",
                {"dx, dy = ": "return min(left, right)\n    dx, dy = "}),
        Mistake("you pay for a change of the lasers' readings, and turning on the spot changes them, too.",
                {"dx, dy = ": "return abs(left - before['laser_front_left'])\n    dx, dy = "}),
        Mistake("only one direction pays. Driving back along x counts as well: is a minus sign in the way?",
                {"hypot(dx, dy)": "dx"}),
        Mistake("driving along y is driving, too.", {"hypot(dx, dy)": "abs(dx)"}),
        Mistake("askew, it goes 0.06 m in each direction, and 0.085 m in all. Take the length of the way: Pythagoras.",
                {"hypot(dx, dy)": "max(abs(dx), abs(dy))"}),
        Mistake("a wall 0.15 m away is not touched; the limit is 0.10 m.", {"0.10": "0.20"}),
        Mistake("touching a wall costs nothing. What is forbidden needs a reward below that of standing still.",
                {"return -2": "pass"}),
        Mistake("touching a wall pays: has its reward the wrong sign?", {"return -2": "return 2"}),
        Mistake("one laser is enough to see a wall that is touched. Here both are needed.", {"min(": "max("}),
        Mistake("only the left laser is watched, and walls are on the right, too.", {"min(left, right)": "left"}),
        Mistake("whether a wall is touched must be asked of the readings after the step; that is where the action led.",
                {'after["laser': 'before["laser'}),
        Mistake("scraping along a wall still pays, because what driving earns is more than what touching costs.",
                {"return -2": "return 10 * (hypot(dx, dy) > 0.07) - 2"}),
    ],
)  # fmt: skip

discounted_return = Exercise(
    task="return the sum of the rewards, the one of step k multiplied by γ to the power of k",
    right=solutions.discounted_return,
    returns="G",
    tape=[
        {"rewards": [10.0], "gamma": 0.9},
        {"rewards": [-0.02, 10.0, 10.0], "gamma": 0.9},
        {"rewards": [0.0, 0.0, 0.0, 1.0], "gamma": 0.5},
        {"rewards": [1.0, 2.0, 3.0], "gamma": 1.0},
        {"rewards": [5.0, -2.0, 7.0], "gamma": 0.0},
        {"rewards": [], "gamma": 0.9},
        {"rewards": [10.0] * 12, "gamma": 0.99},
    ],
    mistakes=[
        Mistake("the first reward counts in full: it has γ to the power of 0, which is 1.",
                {"gamma**k": "gamma ** (k + 1)"}),
        Mistake("this is the plain sum; γ is missing.", {"gamma**k * ": ""}),
        Mistake("all later rewards have the same factor γ here. Each further step brings one more factor.",
                {"gamma**k": "gamma ** min(k, 1)"}),
        Mistake("your sum begins at the wrong end: here the last reward counts in full, not the first.",
                {"enumerate(rewards)": "enumerate(rewards[::-1])"}),
        Mistake("γ to the power of k is γ ** k. You multiplied γ by k.", {"gamma**k": "gamma * k"}),
        Mistake("the return is a sum, not a mean.", {"return total": "return total / max(len(rewards), 1)"}),
        Mistake("this is the last reward alone. Add them all up.", {"total +=": "total ="}),
        Mistake("a list without rewards has the return 0, and your function must not ask for its first one.",
                {"return total": "return total if rewards else -1"}),
    ],
)  # fmt: skip

far_from_the_goal = Question(
    task="the value of a state that is four steps away from the goal, with γ = 0.5",
    right=solutions.far_from_the_goal,
    because="The rewards ahead are 0, 0, 0 and 1, so V = 0.5 · 0.5 · 0.5 · 1 = 0.125.",
    mistakes=[
        Mistake("one factor too many: the fourth step has γ to the power of 3, because the first has the power of 0.",
                0.0625),
        Mistake("one factor too few. Write down the four rewards and number them from 0.", 0.25),
        Mistake("you forgot γ: a reward that lies three steps behind the next one does not count in full.", 1.0),
        Mistake("γ counts once for every step that the reward lies ahead, not once in all.", 0.5),
        Mistake("only the next reward is 0. The value looks at all that is to come.", 0.0),
        Mistake("only the step into the goal pays 1; the steps before it pay 0.", 1.875),
        Mistake("γ is a factor for each step. You multiplied it by their number.", 2.0),
        Mistake("γ is a factor for each step. You multiplied it by their number.", 1.5),
    ],
)  # fmt: skip
