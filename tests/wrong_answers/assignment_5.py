"""Typical wrong answers of assignment 5, written as learners write them, and a word of the hint each must get."""

import math

import numpy as np

from rlrobot_edu.course.assignment_5.solutions import interval as right_interval


def touches(after):
    return min(after[f"laser_front{side}"] for side in ("", "_left", "_right")) < 0.05


def stands(before, after):
    return math.dist((before["x"], before["y"]), (after["x"], after["y"])) < 0.01


def comes(before, after):
    return after["laser_front"] > 0.35 and before["laser_front"] - after["laser_front"] > 0.01


def pays_for_the_place(before, after):
    if touches(after):
        return -10
    return 5 if 0.15 < after["laser_front"] <= 0.35 else comes(before, after)


def pays_at_the_end_only(before, after):
    if touches(after):
        return -10
    return 5 if 0.15 < after["laser_front"] <= 0.35 and stands(before, after) else 0


def pays_for_any_drive(before, after):
    if touches(after):
        return -10
    if 0.15 < after["laser_front"] <= 0.35 and stands(before, after):
        return 5
    return 0 if stands(before, after) else 1


def pays_without_care(before, after):
    if 0.15 < after["laser_front"] <= 0.35 and stands(before, after):
        return 5
    return 1 if comes(before, after) else 0


def pays_too_near(before, after):
    if touches(after):
        return -10
    if after["laser_front"] <= 0.35 and stands(before, after):
        return 5
    return 1 if comes(before, after) else 0


def values(rows, policy, n_states, gamma, sweeps, pick=None, mean=np.mean, copy=True):
    v = np.zeros(n_states)
    for _ in range(sweeps):
        old = v.copy() if copy else v
        for s in range(n_states):
            mine = [row for row in rows if row[0] == s and (pick or (lambda a, s: a == policy[s]))(row[1], s)]
            v[s] = mean([row[2] + gamma * old[row[3]] for row in mine]) if mine else 0
    return v


def value_of_all_actions(rows, policy, n_states, gamma, sweeps):
    return values(rows, policy, n_states, gamma, sweeps, pick=lambda a, s: True)


def value_summed(rows, policy, n_states, gamma, sweeps):
    return values(rows, policy, n_states, gamma, sweeps, mean=sum)


def value_in_place(rows, policy, n_states, gamma, sweeps):
    return values(rows, policy, n_states, gamma, sweeps, copy=False)


def value_undiscounted(rows, policy, n_states, gamma, sweeps):
    return values(rows, policy, n_states, 1.0, sweeps)


def value_of_luck(rows, policy, n_states, gamma, sweeps):
    return values(rows, policy, n_states, gamma, sweeps, mean=max)


def interval_by_n(values, t):
    half = t * np.std(values) / len(values) ** 0.5
    return np.mean(values) - half, np.mean(values) + half


def interval_of_robots(values, t):
    half = t * np.std(values, ddof=1)
    return np.mean(values) - half, np.mean(values) + half


def interval_without_root(values, t):
    half = t * np.std(values, ddof=1) / len(values)
    return np.mean(values) - half, np.mean(values) + half


def interval_of_extremes(values, t):
    return min(values), max(values)


def interval_mean_and_half(values, t):
    return np.mean(values), t * np.std(values, ddof=1) / len(values) ** 0.5


def verdict_by_means(first, second, t):
    d = np.mean(first) - np.mean(second)
    return "first" if d > 0 else "second" if d < 0 else "open"


def verdict_of_strangers(first, second, t):
    one, other = right_interval(first, t), right_interval(second, t)
    if one[0] > other[1]:
        return "first"
    return "second" if other[0] > one[1] else "open"


def verdict_swapped(first, second, t):
    low, high = right_interval(np.subtract(second, first), t)
    return "first" if low > 0 else "second" if high < 0 else "open"


def verdict_never_second(first, second, t):
    return "first" if right_interval(np.subtract(first, second), t)[0] > 0 else "open"


def verdict_never_open(first, second, t):
    return "first" if right_interval(np.subtract(first, second), t)[0] > 0 else "second"


WRONG = {
    "park_reward": [
        (pays_for_the_place, "driving through"),
        (pays_at_the_end_only, "nothing leads"),
        (pays_for_any_drive, "away from the wall"),
        (pays_without_care, "touching costs nothing"),
        (pays_too_near, "too near"),
    ],
    "inputs": [
        ("A", "ahead"),
        ("ADEF", "backward"),
        ("ABCDEFG", "thousands"),
        ("E, D, A and G", "time"),
        ("DE", "which input tells it"),
    ],
    "value_of": [
        (value_of_all_actions, "that of the policy"),
        (value_summed, "take their mean"),
        (value_in_place, "keep a copy"),
        (value_undiscounted, "γ is missing"),
        (value_of_luck, "luckiest"),
    ],
    "interval": [
        (interval_by_n, "n − 1"),
        (interval_of_robots, "root of n"),
        (interval_without_root, "not with n"),
        (interval_of_extremes, "smallest and the largest"),
        (interval_mean_and_half, "two ends"),
    ],
    "verdict": [
        (verdict_by_means, "whose mean"),
        (verdict_of_strangers, "strangers"),
        (verdict_swapped, "changed places"),
        (verdict_never_second, "never finds"),
        (verdict_never_open, "never leaves it open"),
    ],
}
