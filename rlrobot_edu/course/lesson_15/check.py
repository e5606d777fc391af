"""Exercises of lesson 15: a reward, the size of a design, and what is wrong with three task files."""

from __future__ import annotations

from itertools import product

from rlrobot_edu.course.grading.design import Design
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_15 import solutions
from rlrobot_edu.course.lesson_15.situations import PAIRS, words

BAND = '0.10 < after["laser_right"] <= 0.40'
WAY = 'hypot(after["x"] - before["x"], after["y"] - before["y"])'
NEAR = 'min(after["laser_front"], after["laser_front_right"], after["laser_right"])'
FREE_PAYS = {"10 if beside and moved > 0.07 else -0.4": "(10 if beside else 1) if moved > 0.07 else -0.4"}
CARELESS = "touching a wall costs nothing more than standing. What is forbidden must be the smallest reward."
RIGHT_ALONE = "only touching on the right costs. A wall may be in front, too."
FRONT_ALONE = "only touching in front costs. Scraping along the wall on the right is touching, too."
NO_RIGHT = "the wall on the right must be watched, too: who scrapes along it reads less than 0.05 m there."
ONE_WAY = "following a wall leads along y, too. Take the length of the way: Pythagoras."
BOTH_SIDES = "a wall on the left is paid as well. Look at laser_right alone."
BOTH = f"{BAND} or {BAND.replace('right', 'left')}"

follow_reward = Design(
    task="return a number that is largest for following a wall on the right, 0.10 to 0.40 m away, and smallest for "
    "touching one",
    right=solutions.follow_reward,
    returns="more is paid when it",
    words=words,
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes=[
        Mistake("you pay for being beside a wall, and who stands beside it is there for ever. Pay only if it has moved "
                "more than 0.07 m.", {" and moved > 0.07": ""}),
        Mistake("turning on the spot is paid: its wheels' middle moves a little. Only more than 0.07 m in a step is "
                "driving.", {"> 0.07": "> 0.01"}),
        Mistake("driving begins at 0.07 m in a step. Yours asks for more.", {"> 0.07": "> 0.1"}),
        Mistake("you pay for driving, wherever that is. The wall is missing: laser_right between 0.10 and 0.40 m.",
                {BAND: "True"}),
        Mistake("a wall on the left is paid as well, or alone. Look at laser_right.",
                {BAND: '0.10 < min(after["laser_right"], after["laser_left"]) <= 0.40'}),
        Mistake("the wall on its left is followed. It is to be on the right: laser_right.",
                {BAND: '0.10 < after["laser_left"] <= 0.40'}),
        Mistake("a wall ahead on the right is not yet one beside the robot. Look at laser_right.",
                {BAND: '0.10 < after["laser_front_right"] <= 0.40'}),
        Mistake("too near counts as well: below 0.10 m it is almost touching. The distance has two limits.",
                {"0.10 < ": ""}),
        Mistake("too far counts as well: beyond 0.40 m it is leaving the wall. The distance has two limits.",
                {" <= 0.40": ""}),
        Mistake("only one direction pays. Following a wall leads along −x and along y, too. Take the length of the "
                "way: Pythagoras.", {WAY: '(after["x"] - before["x"])'}),
        Mistake("following a wall leads along y, too. Take the length of the way: Pythagoras.",
                {WAY: 'abs(after["x"] - before["x"])'}),
        Mistake("askew, it goes 0.065 m in each direction, and 0.09 m in all. Take the length of the way: Pythagoras.",
                {"hypot(": "max(", WAY[6:-1]: 'abs(after["x"] - before["x"]), abs(after["y"] - before["y"])'}),
        Mistake("this is where the robot is, not how far it has moved. Take the difference of after and before.",
                {' - before["x"]': "", ' - before["y"]': ""}),
        Mistake(CARELESS, {"return -0.6": "pass"}),
        Mistake("touching a wall is paid as standing still. Nothing keeps the robot from it: pay less.",
                {"return -0.6": "return -0.4"}),
        Mistake("touching a wall is paid better than standing still: has its reward the wrong sign?",
                {"return -0.6": "return 2"}),
        Mistake(RIGHT_ALONE, {NEAR: 'after["laser_right"]'}),
        Mistake(FRONT_ALONE, {NEAR: 'after["laser_front"]'}),
        Mistake("the laser at the front right counts, too: it is the first that meets a corner.",
                {', after["laser_front_right"]': ""}),
        Mistake(NO_RIGHT, {', after["laser_right"])': ")"}),
        Mistake(CARELESS, {"return -0.6": "pass", **FREE_PAYS}),
        Mistake(ONE_WAY, {WAY: 'abs(after["x"] - before["x"])', **FREE_PAYS}),
        Mistake(BOTH_SIDES, {BAND: BOTH, **FREE_PAYS}),
        Mistake(BOTH_SIDES, {BAND: BOTH}),
        Mistake(RIGHT_ALONE, {NEAR: 'after["laser_right"]', **FREE_PAYS}),
        Mistake(FRONT_ALONE, {NEAR: 'after["laser_front"]', **FREE_PAYS}),
        Mistake(NO_RIGHT, {', after["laser_right"])': ")", **FREE_PAYS}),
        Mistake("the left laser is no part of this: a box on the left that is not touched is no reason to stop paying.",
                {NEAR: f'min({NEAR[4:-1]}, after["laser_left"] - 0.06)'}),
        Mistake("look at the readings after the step: that is where the action has led.",
                {BAND: '0.10 < before["laser_right"] <= 0.40'}),
        Mistake("every step is paid the same, so nothing is wanted more than anything else.",
                {"near < 0.05": "False", "beside and moved > 0.07": "True"}),
        Mistake("you pay for standing still. Is the sign of > or < the wrong way round?",
                {"moved > 0.07": "moved < 0.07"}),
    ],
    hints=(
        "Three questions, in this order: does it touch a wall after the step? If not, has it moved more than 0.07 m? "
        "If so, is the wall on its right where it should be?",
        "near = min(…) of three lasers of after; moved = np.hypot(…, …); 0.10 < x <= 0.40 asks for both "
        "limits at once.",
        "If near < 0.05, return -0.6. Else 10 if moved > 0.07 and 0.10 < after[\"laser_right\"] <= 0.40, and -0.4 "
        "if not.",
    ),
    gained="In the next cells a robot takes your reward at its word.",
)  # fmt: skip

STATES, STEPS = 3 * 4 * 2 * 8, 3600

size = Question(
    task="the number of states, and how many of 3600 steps each gets on average",
    right=solutions.size,
    because="3 · 4 · 2 · 8 = 192 states, and 3600 / 192 = 18.75 steps for each: about two for each action.",
    mistakes=[
        Mistake("k cut points make k + 1 bins: 2 cuts are 3 bins, 3 cuts 4, 1 cut 2. The sectors are 8 already.",
                [2 * 3 * 1 * 8, STEPS / (2 * 3 * 1 * 8)]),
        Mistake("8 sectors of a circle are 8 bins: a circle has no ends.", [3 * 4 * 2 * 9, STEPS / (3 * 4 * 2 * 9)]),
        Mistake("the bins multiply, for every bin of one input may come with every bin of another.",
                [3 + 4 + 2 + 8, STEPS / (3 + 4 + 2 + 8)]),
        Mistake("the heading makes states, too: all four inputs count.", [3 * 4 * 2, STEPS / (3 * 4 * 2)]),
        Mistake("these are pairs of a state and an action. Asked are states, and how often each is met.",
                [STATES * 9, STEPS / (STATES * 9)]),
        Mistake("the states are right. The second number is for a state, not for each of its nine actions.",
                [STATES, STEPS / (STATES * 9)]),
        Mistake("the states are right. The second number is upside down: steps divided by states.",
                [STATES, STATES / STEPS]),
        Mistake("the states are right. The mean is 3600 / 192 and need not be a whole number.", [STATES, 18]),
        Mistake("the states are right. The mean is 3600 / 192 and need not be a whole number.", [STATES, 19]),
        Mistake("the right numbers have changed places: the states come first.", [STEPS / STATES, STATES]),
    ],
    hints=(
        "How many bins has each of the four inputs? Then multiply.",
        "k cut points make k + 1 bins; 8 sectors are 8. So there are 3 · 4 · 2 · 8 states.",
        "size = [3 * 4 * 2 * 8, 3600 / (3 * 4 * 2 * 8)]",
    ),
    gained="Two lines of arithmetic before the first run save many hours after it.",
)  # fmt: skip

# What is at fault, by number, and why it cannot be so in one of the three files
CLUES = (
    "in file A, the reward 10 was never given, whatever the robot did. Which fault puts it out of reach?",
    "in file B, one bin of an input was never reached, and that input is always in its other bin. What is it that it "
    "cannot see?",
    "in file C, two actions do the same. Where is it said what the wheels are told?",
)
FAULTS = (1, 2, 3, 4)
EXAMPLE = [2, 2, 2]

faults = Question(
    task="the number of the fault in A, B and C, such as [2, 2, 2]",
    right=solutions.faults,
    because="A asks for 7 metres in a step, B cuts its laser where no wall ever is, and C's command stops one wheel.",
    mistakes=[
        Mistake("that was only to show how it is written. Read the three reports, one after the other.", EXAMPLE),
        *(
            Mistake(CLUES[next(i for i in range(3) if tried[i] != solutions.faults[i])], list(tried))
            for tried in product(FAULTS, repeat=3)
            if list(tried) not in (EXAMPLE, solutions.faults)
        ),
    ],
    hints=(
        "Read the sentences under “Worth a look” first; the tables say where they come from.",
        "A: look at reports['A'].rewards. B: look at reports['B'].inputs. C: look at reports['C'].actions.",
        "A is 3. B is one of 1 and 2, and C is 4.",
    ),
    gained="You can read a report: it names the symptom, and the fault is for you to find.",
)
