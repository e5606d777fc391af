"""Solutions of lesson 12, as a learner writes them."""

import math

pays = ((-1 + 5) / 2, (-1 + 10) / 2)


def gripper(arm, biceps, forearm, upper=0.23, lower=0.25, shoulder=0.12):
    out = upper * math.sin(biceps) + lower * math.cos(biceps + forearm)
    up = shoulder + upper * math.cos(biceps) - lower * math.sin(biceps + forearm)
    return out * math.cos(arm), out * math.sin(arm), up


def arm_reward(before, after):
    if after <= 0.05:
        return 10.0
    return 100 * (before - after)
