"""Right answers and tapes of lesson 16; the pages of this folder have the tasks, hints and mistakes."""

from math import hypot

from rlrobot_course.exercises.parts import (
    Design,
    Formula,
    Mistake,
    Question,
    with_pages,
    wrong_choices,
)
from rlrobot_course.lesson_16.situations import PAIRS, words
from rlrobot_course.worlds.tapes import rows


def follow_reward(before, after):
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    moved = hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -0.6
    beside = 0.10 < after["laser_right"] <= 0.40
    return 10 if beside and moved > 0.07 else -0.4


faults = [3, 1, 4]
# What is at fault, by number, and why it cannot be so in one of the three files
CLUES = (
    "in file A, the reward 10 was never given, whatever the robot did. Which fault puts it out of reach?",
    "in file B, one bin of an input was never reached, and that input is always in its other bin. What is it that it "
    "cannot see?",
    "in file C, two actions do the same. Where is it said what the wheels are told?",
)
FAULTS = (1, 2, 3, 4)
STILL_SAFE = Formula(
    "margin + way",
    margin=0.05,
    radius=0.0975,
    speed=2,
    single_speed=1,
    way="speed * radius",
)
EXAMPLE = Mistake(
    "that was only to show how it is written. Read the three reports, one after the other.",
    [2, 2, 2],
)

check = with_pages(
    globals(),
    follow_reward=Design(
        follow_reward,
        returns="more is paid when it",
        words=words,
        tape=rows("wanted unwanted", *PAIRS),
    ),
    size=Question(
        Formula("[states, steps / states]", steps=3600, states="3 * 4 * 2 * 8")
    ),
    still_safe=Question(STILL_SAFE),
    faults=Question(faults, mistakes=wrong_choices(faults, FAULTS, CLUES, EXAMPLE)),
)
