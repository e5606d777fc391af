"""Typical wrong answers of lesson 15, written as learners write them, and a word of the hint each must get."""

from math import hypot


def moved(before, after):
    return hypot(after["x"] - before["x"], after["y"] - before["y"]) > 0.07


def touches(after):
    return min(after["laser_front"], after["laser_front_right"], after["laser_right"]) < 0.05


def beside(after, laser="laser_right"):
    return 0.10 < after[laser] <= 0.40


def reward_standing(before, after):
    if touches(after):
        return -2.0
    return 10.0 if beside(after) else 0.0


def reward_turning(before, after):
    if touches(after):
        return -2.0
    if before["x"] == after["x"] and before["y"] == after["y"]:
        return -0.02
    return 10.0 if beside(after) else 1.0


def reward_driving(before, after):
    if touches(after):
        return -2.0
    return 10.0 if moved(before, after) else -0.02


def reward_left(before, after):
    if touches(after):
        return -2.0
    return 10.0 if moved(before, after) and beside(after, "laser_left") else -0.02


def reward_both_sides(before, after):
    if touches(after):
        return -2.0
    if not moved(before, after):
        return -0.02
    return 10.0 if beside(after) or beside(after, "laser_left") else 1.0


def reward_no_lower_limit(before, after):
    if touches(after):
        return -2.0
    if not moved(before, after):
        return -0.02
    return 10.0 if after["laser_right"] <= 0.40 else 1.0


def reward_no_upper_limit(before, after):
    if touches(after):
        return -2.0
    if not moved(before, after):
        return -0.02
    return 10.0 if after["laser_right"] > 0.10 else 1.0


def reward_along_x(before, after):
    if touches(after):
        return -2.0
    if abs(after["x"] - before["x"]) <= 0.07:
        return -0.02
    return 10.0 if beside(after) else 1.0


def reward_careless(before, after):
    if not moved(before, after):
        return -0.02
    return 10.0 if beside(after) else 1.0


def reward_right_alone(before, after):
    if after["laser_right"] < 0.05:
        return -2.0
    if not moved(before, after):
        return -0.02
    return 10.0 if beside(after) else 1.0


def reward_front_alone(before, after):
    if after["laser_front"] < 0.05:
        return -2.0
    if not moved(before, after):
        return -0.02
    return 10.0 if beside(after) else 1.0


def reward_of_before(before, after):
    if touches(after):
        return -2.0
    if not moved(before, after):
        return -0.02
    return 10.0 if beside(before) else 1.0


def reward_text(before, after):
    return "10" if beside(after) else "0"


WRONG = {
    "follow_reward": [
        (reward_standing, "for ever"),
        (reward_turning, "turning on the spot"),
        (reward_driving, "The wall is missing"),
        (reward_left, "on its left"),
        (reward_both_sides, "on the left is paid as well"),
        (reward_no_lower_limit, "too near"),
        (reward_no_upper_limit, "too far"),
        (reward_along_x, "Pythagoras"),
        (reward_careless, "costs nothing"),
        (reward_right_alone, "in front"),
        (reward_front_alone, "Scraping"),
        (reward_of_before, "after the step"),
        (reward_text, "one number"),
    ],
    "size": [
        ([48, 75], "k + 1 bins"),
        ([216, 16.6667], "a circle has no ends"),
        ([17, 211.76], "multiply"),
        ([1728, 2.08333], "Asked are states"),
        ([192, 2.08333], "not for each of its nine"),
        ((18.75, 192), "changed places"),
    ],
    "faults": [
        ([1, 1, 4], "file A"),
        ([3, 2, 4], "file B"),
        ([3, 1, 2], "file C"),
        ((4, 1, 3), "file A"),
        ([3, 1, 3], "file C"),
        ([2, 2, 2], "only to show"),
    ],
}
