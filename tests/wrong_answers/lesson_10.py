"""Typical wrong answers of lesson 10, written as learners write them, and a word of the hint each must get."""

import math


def motion_in_radians(left, right, radius, separation):
    return (left + right) / 2 * radius, (right - left) * radius / separation


def motion_turned_round(left, right, radius, separation):
    turn = (left * radius - right * radius) / separation
    return radius * (left + right) / 2, turn * 180 / math.pi


def motion_sum(left, right, radius, separation):
    return left * radius + right * radius, math.degrees((right * radius - left * radius) / separation)


def motion_half_the_turn(left, right, radius, separation):
    a, b = left * radius, right * radius
    return (a + b) / 2, math.degrees((b - a) / (2 * separation))


def motion_without_radius(left, right, radius, separation):
    return (left + right) / 2, math.degrees((right - left) / separation)


def motion_swapped(left, right, radius, separation):
    turn = math.degrees((right - left) * radius / separation)
    return turn, (left + right) / 2 * radius


def motion_speed_alone(left, right, radius, separation):
    return (left + right) / 2 * radius


def motion_of_one_robot(left, right, radius, separation):
    return 0.0975 * (left + right) / 2, math.degrees(0.0975 * (right - left) / 0.331)


WRONG = {
    "bins": [
        ((2, 2, 3, 0, 3), "exactly on a cut"),
        ([2, 3, 4, 1, 4], "counted from 0"),
        ((1, 1, 3, 0, 3), "0.54 m"),
        ((1, 2, 4, 0, 3), "no bin 4"),
        ((2, 1, 0, 3, 0), "the other way round"),
    ],
    "still_safe": [
        (0.05 + 0.0975, "single speed"),
        (2 * 0.0975, "must still be 0.05 m"),
        (2 * 0.0975 - 0.05, "Add it"),
        (0.27, "Work it out"),
        (24.5, "in metres"),
    ],
    "motion": [
        (motion_in_radians, "degrees"),
        (motion_turned_round, "wrong way"),
        (motion_sum, "divide by 2"),
        (motion_half_the_turn, "half"),
        (motion_without_radius, "both numbers lack the radius"),
        (motion_swapped, "changed places"),
        (motion_speed_alone, "speed alone"),
        (motion_of_one_robot, "one robot only"),
    ],
}
