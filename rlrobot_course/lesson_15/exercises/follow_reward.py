"""A reward for following a wall."""

from __future__ import annotations

from math import hypot

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.design import Design
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_15.situations import PAIRS, words


def follow_reward(before, after):
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    moved = hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -0.6
    beside = 0.10 < after["laser_right"] <= 0.40
    return 10 if beside and moved > 0.07 else -0.4


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

WITNESSES = read_answers(__file__, {})[1]

exercise = Design(
    task="return a number that is largest for following a wall on the right, 0.10 to 0.40 m away, and smallest for "
    "touching one",
    right=follow_reward,
    returns="more is paid when it",
    words=words,
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes={
        "standing_pays": Mistake(
            "you pay for being beside a wall, and who stands beside it is there for ever. Pay only if it has moved "
            "more than 0.07 m.",
            {" and moved > 0.07": ""},
        ),
        "turning_pays": Mistake(
            "turning on the spot is paid: its wheels' middle moves a little. Only more than 0.07 m in a step is "
            "driving.",
            {"> 0.07": "> 0.01"},
        ),
        "follows_before_it_touches": Mistake(
            "if both hold, it touches: ask for touching first.",
            {"if near < 0.05:": f"if near < 0.05 and not ({BAND} and moved > 0.07):"},
        ),
        "touched_before": Mistake(
            "touching is asked of the readings before the step. Look at after: that is where the action has led.",
            {NEAR: NEAR.replace("after", "before")},
        ),
        "curving_pays": Mistake("a curve of 0.06 m is paid. Only more than 0.07 m is driving.", {"> 0.07": "> 0.05"}),
        "at_0_40": Mistake("at 0.40 m it still follows the wall: at most 0.40 is asked, <=.", {"<= 0.40": "< 0.40"}),
        "at_0_10": Mistake("at 0.10 m it is too near: above 0.10 is asked, <.", {"0.10 < ": "0.10 <= "}),
        "asks_for_0_1": Mistake("driving begins at 0.07 m in a step. Yours asks for more.", {"> 0.07": "> 0.1"}),
        "no_wall": Mistake(
            "you pay for driving, wherever that is. The wall is missing: laser_right between 0.10 and 0.40 m.",
            {BAND: "True"},
        ),
        "either_side": Mistake(
            "a wall on the left is paid as well, or alone. Look at laser_right.",
            {BAND: '0.10 < min(after["laser_right"], after["laser_left"]) <= 0.40'},
        ),
        "wall_on_the_left": Mistake(
            "the wall on its left is followed. It is to be on the right: laser_right.",
            {BAND: '0.10 < after["laser_left"] <= 0.40'},
        ),
        "wall_ahead": Mistake(
            "a wall ahead on the right is not yet one beside the robot. Look at laser_right.",
            {BAND: '0.10 < after["laser_front_right"] <= 0.40'},
        ),
        "too_near": Mistake(
            "too near counts as well: below 0.10 m it is almost touching. The distance has two limits.", {"0.10 < ": ""}
        ),
        "too_far": Mistake(
            "too far counts as well: beyond 0.40 m it is leaving the wall. The distance has two limits.",
            {" <= 0.40": ""},
        ),
        "x_signed": Mistake(
            "only one direction pays. Following a wall leads along −x and along y, too. Take the length of the "
            "way: Pythagoras.",
            {WAY: '(after["x"] - before["x"])'},
        ),
        "only_x": Mistake(
            "following a wall leads along y, too. Take the length of the way: Pythagoras.",
            {WAY: 'abs(after["x"] - before["x"])'},
        ),
        "larger_of_both": Mistake(
            "askew, it goes 0.065 m in each direction, and 0.09 m in all. Take the length of the way: Pythagoras.",
            {"hypot(": "max(", WAY[6:-1]: 'abs(after["x"] - before["x"]), abs(after["y"] - before["y"])'},
        ),
        "place_as_the_way": Mistake(
            "this is where the robot is, not how far it has moved. Take the difference of after and before.",
            {' - before["x"]': "", ' - before["y"]': ""},
        ),
        "touching_is_free": Mistake(CARELESS, {"return -0.6": "pass"}),
        "touching_as_standing": Mistake(
            "touching a wall is paid as standing still. Nothing keeps the robot from it: pay less.",
            {"return -0.6": "return -0.4"},
        ),
        "touching_pays": Mistake(
            "touching a wall is paid better than standing still: has its reward the wrong sign?",
            {"return -0.6": "return 2"},
        ),
        "right_alone": Mistake(RIGHT_ALONE, {NEAR: 'after["laser_right"]'}),
        "front_alone": Mistake(FRONT_ALONE, {NEAR: 'after["laser_front"]'}),
        "not_front_right": Mistake(
            "the laser at the front right counts, too: it is the first that meets a corner.",
            {', after["laser_front_right"]': ""},
        ),
        "not_right": Mistake(NO_RIGHT, {', after["laser_right"])': ")"}),
        "scraping_pays": Mistake(CARELESS, {"return -0.6": "pass", **FREE_PAYS}),
        "only_y": Mistake(ONE_WAY, {WAY: 'abs(after["x"] - before["x"])', **FREE_PAYS}),
        "any_side_left": Mistake(BOTH_SIDES, {BAND: BOTH, **FREE_PAYS}),
        "front_alone_and_scraping": Mistake(FRONT_ALONE, {NEAR: 'after["laser_front"]', **FREE_PAYS}),
        "not_right_and_scraping": Mistake(NO_RIGHT, {', after["laser_right"])': ")", **FREE_PAYS}),
        "left_laser_too": Mistake(
            "the left laser is no part of this: a box on the left that is not touched is no reason to stop paying.",
            {NEAR: f'min({NEAR[4:-1]}, after["laser_left"] - 0.06)'},
        ),
        "lasers_before": Mistake(
            "look at the readings after the step: that is where the action has led.",
            {BAND: '0.10 < before["laser_right"] <= 0.40'},
        ),
        "all_alike": Mistake(
            "every step is paid the same, so nothing is wanted more than anything else.",
            {"near < 0.05": "False", "beside and moved > 0.07": "True"},
        ),
        "standing_pays_alone": Mistake(
            "you pay for standing still. Is the sign of > or < the wrong way round?", {"moved > 0.07": "moved < 0.07"}
        ),
    },
    hints=(
        "Three questions, in this order: does it touch a wall after the step? If not, has it moved more than 0.07 m? "
        "If so, is the wall on its right where it should be?",
        "near = min(…) of three lasers of after; moved = np.hypot(…, …); 0.10 < x <= 0.40 asks for both "
        "limits at once.",
        'If near < 0.05, return -0.6. Else 10 if moved > 0.07 and 0.10 < after["laser_right"] <= 0.40, and -0.4 '
        "if not.",
    ),
    gained="The order is right: what is wanted pays more. Whether the sizes are right, too, the next cells will show, "
    "where a robot takes your reward at its word.",
    witnesses=WITNESSES,
)
