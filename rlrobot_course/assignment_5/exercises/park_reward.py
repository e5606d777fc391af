"""A reward for parking in front of a wall."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_5.parking import PAIRS, words
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.design import Design
from rlrobot_course.grading.mistake import Mistake


def park_reward(before, after):
    front = after["laser_front"]
    near = min(front, after["laser_front_left"], after["laser_front_right"])
    moved = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -2
    if 0.15 < front <= 0.35 and moved < 0.01:
        return 10
    return 1 if front > 0.35 and front < before["laser_front"] - 0.01 else 0


NEAR = 'min(front, after["laser_front_left"], after["laser_front_right"])'

COMING = '1 if front > 0.35 and front < before["laser_front"] - 0.01 else 0'

WITNESSES = read_answers(__file__, {})[1]

exercise = Design(
    task="return a number that is largest for standing 0.15 to 0.35 m in front of a wall, smallest for touching one, "
    "and larger for coming nearer than for standing afar",
    right=park_reward,
    returns="more is paid when it",
    words=words,
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes={
        "drives_through": Mistake(
            "driving through the right place is paid as parking there. Parked is who has not moved: less than 0.01 m.",
            {" and moved < 0.01": ""},
        ),
        "too_near": Mistake(
            "too near is paid as well: at 0.15 m or less the robot is not parked well.", {"0.15 < front": "front"}
        ),
        "too_far": Mistake(
            "too far is paid as well: beyond 0.35 m the robot is not parked.", {"front <= 0.35": "front"}
        ),
        "no_way_to_it": Mistake(
            "nothing leads the robot to the wall: from afar, coming nearer must be worth more than standing there.",
            {COMING: "0"},
        ),
        "pays_driving": Mistake(
            "whoever drives afar is paid, also away from the wall. Is the wall ahead nearer than before?",
            {COMING: "1 if moved > 0.01 else 0"},
        ),
        "pays_leaving": Mistake(
            "leaving the wall is paid, and coming is not: compare the front laser after and before the step.",
            {'front < before["laser_front"] - 0.01': 'front > before["laser_front"] + 0.01'},
        ),
        "touching_is_free": Mistake(
            "touching costs nothing. What is forbidden must be the smallest reward.", {"return -2": "pass"}
        ),
        "front_alone": Mistake("only touching in front costs. The two lasers beside it count, too.", {NEAR: "front"}),
        "not_front_right": Mistake("the laser at the front right is forgotten.", {', after["laser_front_right"]': ""}),
        "not_front_left": Mistake("the laser at the front left is forgotten.", {', after["laser_front_left"]': ""}),
        "coming_pays_as_well": Mistake(
            "coming nearer is paid as well as being there. Then why should it ever stop?", {"return 10": "return 1"}
        ),
        "standing_anywhere": Mistake(
            "standing anywhere is paid. Only 0.15 to 0.35 m in front of a wall is parked.",
            {"0.15 < front <= 0.35 and moved": "moved"},
        ),
    },
    hints=(
        "Three questions, in this order: does it touch? If not, is it parked? If not, has the wall ahead come nearer?",
        "Touching: the smallest of three lasers of after is below 0.05. Parked: 0.15 < front <= 0.35, and moved "
        "less than 0.01 m.",
        'Coming nearer: front > 0.35 and front < before["laser_front"] - 0.01. Pay −2, 10, 1, and 0 for the rest.',
    ),
    gained="A robot will take it at its word, below.",
    witnesses=WITNESSES,
)
