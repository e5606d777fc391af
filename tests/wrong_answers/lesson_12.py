"""Typical wrong answers of lesson 12, written as learners write them, and a word of the hint each must get."""

from math import cos, degrees, pi, sin

U, L, H = 0.23, 0.25, 0.12


def turned(out, up, arm):
    return out * cos(arm), out * sin(arm), up


def gripper_sine_for_cosine(arm, biceps, forearm):
    out, up = U * sin(biceps) + L * cos(biceps + forearm), H + U * cos(biceps) - L * sin(biceps + forearm)
    return out * sin(arm), out * cos(arm), up


def gripper_to_the_right(arm, biceps, forearm):
    out, up = U * sin(biceps) + L * cos(biceps + forearm), H + U * cos(biceps) - L * sin(biceps + forearm)
    return turned(out, up, -arm)


def gripper_elbow_alone(arm, biceps, forearm):
    return turned(U * sin(biceps) + L * cos(forearm), H + U * cos(biceps) - L * sin(forearm), arm)


def gripper_rises(arm, biceps, forearm):
    return turned(U * sin(biceps) + L * cos(biceps + forearm), H + U * cos(biceps) + L * sin(biceps + forearm), arm)


def gripper_from_the_table(arm, biceps, forearm):
    return turned(U * sin(biceps) + L * cos(biceps + forearm), U * cos(biceps) - L * sin(biceps + forearm), arm)


def gripper_from_the_side(arm, biceps, forearm):
    return U * sin(biceps) + L * cos(biceps + forearm), 0, H + U * cos(biceps) - L * sin(biceps + forearm)


def gripper_without_height(arm, biceps, forearm):
    out = U * sin(biceps) + L * cos(biceps + forearm)
    return out * cos(arm), out * sin(arm)


def gripper_in_degrees(arm, biceps, forearm):
    a, b, f = arm * pi / 180, biceps * pi / 180, forearm * pi / 180
    return turned(U * sin(b) + L * cos(b + f), H + U * cos(b) - L * sin(b + f), a)


def gripper_shows_it(arm, biceps, forearm):
    print(degrees(arm), gripper_from_the_side(arm, biceps, forearm))


def reward_of_the_task(before, after):
    if after <= 0.05:
        return 10
    gained = before - after
    if gained > 0.02:
        return 5
    return -1 if gained < -0.02 else -0.02


def reward_same_price(before, after):
    if after <= 0.05:
        return 10
    if before - after > 0.02:
        return 5
    return -5 if after - before > 0.02 else -0.02


def reward_by_sign(before, after):
    if after <= 0.05:
        return 10
    return (after < before) - (after > before)


def reward_contact_alone(before, after):
    return 10.0 if after <= 0.05 else 0.0


def reward_way_out(before, after):
    return 10.0 if after <= 0.05 else 100 * after - 100 * before


def reward_never_taken_back(before, after):
    if after <= 0.05:
        return 10.0
    return (before - after) * 100 if before > after else 0


def reward_being_near(before, after):
    return 10.0 if after <= 0.05 else 0.05 / after


def reward_too_large(before, after):
    return 10.0 if after <= 0.05 else 1000 * before - 1000 * after


def reward_no_contact(before, after):
    return 100 * (before - after)


def reward_rounded(before, after):
    return 10.0 if after <= 0.05 else round(100 * (before - after))


def reward_in_centimetres(before, after):
    return 10.0 if after <= 5 else 100 * (before - after)


def reward_negative_distance(before, after):
    return 10.0 if after <= 0.05 else -100 * after


WRONG = {
    "gripper": [
        (gripper_sine_for_cosine, "changed places"),
        (gripper_to_the_right, "without a minus"),
        (gripper_elbow_alone, "biceps + forearm"),
        (gripper_rises, "taken away"),
        (gripper_from_the_table, "begins at the shoulder"),
        (gripper_from_the_side, "becomes x and y"),
        (gripper_without_height, "height is missing"),
        (gripper_in_degrees, "radians already"),
        (gripper_shows_it, "print shows a value"),
    ],
    "pays": [
        ((4, 9), "half of that"),
        ((3, 5.5), "not 1 + 5"),
        ((2.5, 5), "not free"),
        ((2, 2), "not 5"),
        ((4.5, 2), "second loop first"),
    ],
    "arm_reward": [
        (reward_of_the_task, "the task's own reward"),
        (reward_same_price, "creeps away"),
        (reward_by_sign, "however long"),
        (reward_contact_alone, "contact alone"),
        (reward_way_out, "before − after that is above 0"),
        (reward_never_taken_back, "taken back"),
        (reward_being_near, "no nearer"),
        (reward_too_large, "With 1000 a metre"),
        (reward_no_contact, "contact is missing"),
        (reward_rounded, "closed path"),
        (reward_in_centimetres, "in metres"),
        (reward_negative_distance, "only costs"),
    ],
}
