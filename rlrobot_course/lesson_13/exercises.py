"""Right answers and tapes of lesson 13; the pages of this folder have the tasks, hints and mistakes."""

import math

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.lesson_13.reward_exercise import RewardExercise
from rlrobot_course.worlds.tapes import rows


def gripper(arm, biceps, forearm, upper=0.23, lower=0.25, shoulder=0.12):
    out = upper * math.sin(biceps) + lower * math.cos(biceps + forearm)
    up = shoulder + upper * math.cos(biceps) - lower * math.sin(biceps + forearm)
    return out * math.cos(arm), out * math.sin(arm), up


def arm_reward(before, after):
    if after <= 0.05:
        return 10.0
    return 100 * (before - after)


ANGLES = [
    (-0.42, 0.9, 0.26),
    (0.3, 0.5, 0.6),
    (0.7, 1.0, 0.0),
    (-0.7, 0.4, 0.1),
    (0.0, 0.7, 0.4),
    (0.14, 0.9, 0.39),
    (0.12345, 0.67891, 0.23457),
]

check = with_pages(
    globals(),
    gripper=Exercise(
        gripper, returns="gripper", tape=rows("arm biceps forearm", *ANGLES)
    ),
    pays=Question(Formula("((away + 5) / 2, (away + 10) / 2)", away=-1, γ=0.9)),
    arm_reward=RewardExercise(
        arm_reward,
        returns="reward",
        tape=rows(
            "before after",
            (0.20, 0.17),
            (0.17, 0.20),
            (0.12, 0.105),
            (0.105, 0.12),
            (0.15, 0.15),
            (0.06, 0.04),
            (0.04, 0.03),
            (0.03, 0.08),
            (0.09, 0.05),
            (0.085, 0.0501),
            (0.30, 0.24),
            (0.10, 0.135),
        ),
    ),
)
