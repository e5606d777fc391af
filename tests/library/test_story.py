"""What the live page tells of a film: its headline, the moments on its slider, and what its colours mean."""

import numpy as np

from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.in3d.story import key, story

ARM = (
    "gripper within 0.05 m of the object: 10; further away than before by more than 0.02 m: −1; "
    "nearer by more than 0.02 m: 5; else −0.02"
)
WANDER = "of the three front lasers, two or more below 0.05 m: −10, one: −2; moved more than 0.07 m: 10; else −0.02"
OBJECT = Solid("object", "cylinder", (0.05, 0.1), pose(0.3, 0, 0.05), "object")
UPPER = Solid("robot/upper_arm", "box", (0.3, 0.05, 0.05), pose(0, 0, 0.3), "robot")
BODY = Solid("robot/body", "box", (0.1, 0.1, 0.1), pose(0, 0, 0.1), "robot")
WHEEL = Solid("robot/left_wheel", "box", (0.1, 0.1, 0.1), pose(0, 0, 0.1), "wheel")
NO_BEAMS = np.empty((0, 2, 3))


def scenes(solids, bumps) -> list[Scene]:
    room = Scene(tuple(solids), NO_BEAMS, (-1, -1, 1, 1))
    return [room._replace(bumped=bump) for bump in bumps]


def of_arm(rewards, rules=ARM):
    return story(
        scenes([OBJECT, UPPER, BODY], [False] * len(rewards)), rewards, "Reach", rules
    )


def of_wanderer(rewards, bumps):
    return story(scenes([BODY, WHEEL], bumps), rewards, "Wander", WANDER)


def test_an_arm_tells_when_it_was_there_and_how_long():
    told = of_arm([5.0, 10.0, -1.0, 10.0, 10.0, 5.0])
    assert told.headline == "Reach: reached in step 2, there in 3 of 6 steps (+10 each)"
    assert told.moments == [(1, "reached"), (3, "longest stay")]
    assert "yellow object" in told.aim


def test_an_arm_that_never_came_says_so_and_what_was_paid_most_is_no_arrival():
    told = of_arm([5.0, -0.02, 5.0])
    assert told.headline == "Reach: not reached in 3 steps"
    assert told.moments == []


def test_what_the_rules_do_not_explain_is_no_arrival():
    told = of_arm([5.0, 7.0, 7.0])
    assert told.headline == "Reach: reward +7 in 2 of 3 steps"


def test_bumps_are_told_with_what_they_cost_and_marked():
    told = of_wanderer([10.0, -2.0, 10.0, -2.0], [False, True, False, True])
    assert told.headline == "Wander: reward +10 in 2 of 4 steps, 2 bumps (−2 each)"
    assert told.moments == [(1, "bump"), (3, "bump")]
    told = of_wanderer([10.0, -2.0, -10.0], [False, True, True])
    assert told.headline.endswith("2 bumps (−12 in all)")
    told = of_wanderer([10.0, -2.0], [False, False])
    assert told.headline.endswith("1 loss (−2)")


def test_a_touch_that_cost_little_is_no_costly_bump():
    assert of_wanderer([10.0, -0.02], [False, True]).headline.endswith("no costly bump")
    assert of_wanderer([10.0, -0.02], [False, False]).headline.endswith(", no bump")


def test_each_rule_that_was_met_has_the_colour_of_what_it_paid():
    told = key(WANDER, [10.0, -2.0, -0.02], has_beams=True)
    *rules, (colour, laser) = told
    met = WANDER.split("; ")
    assert rules == [("red", met[0]), ("green", met[1]), ("grey", met[2])]
    assert colour == "orange" and "laser" in laser
    assert key(WANDER, [-0.02], has_beams=False) == [("grey", "else −0.02")]


def test_amounts_without_a_rule_are_listed_and_many_are_told_by_their_colours():
    assert key("", [3.0, 3.0, -0.1], has_beams=False) == [
        ("green", "+3 in 2 steps"),
        ("grey", "−0.1 in 1 step"),
    ]
    many = key("", [1.0, 2.0, 3.0, 4.0, 5.0], has_beams=False)
    assert many == [("green", "earned")]
