"""Right answers and tapes of lesson 13; what is asked, hints and mistakes stand on the pages beside."""

import math

from rlrobot_course.grading.parts import Exercise, with_pages
from rlrobot_course.tapes import rows


def gripper(arm, biceps, forearm, upper=0.23, lower=0.25, shoulder=0.12):
    out = upper * math.sin(biceps) + lower * math.cos(biceps + forearm)
    up = shoulder + upper * math.cos(biceps) - lower * math.sin(biceps + forearm)
    return out * math.cos(arm), out * math.sin(arm), up


ANGLES = [(-0.42, 0.9, 0.26), (0.3, 0.5, 0.6), (0.7, 1.0, 0.0), (-0.7, 0.4, 0.1), (0.0, 0.7, 0.4), (0.14, 0.9, 0.39)]

check = with_pages(
    globals(),
    gripper=Exercise(gripper, returns="gripper", tape=rows("arm biceps forearm", *ANGLES)),
)
