"""Solutions of assignment 5, as a learner writes them."""

import numpy as np


def park_reward(before, after):
    front = after["laser_front"]
    near = min(front, after["laser_front_left"], after["laser_front_right"])
    moved = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -2
    if 0.15 < front <= 0.35 and moved < 0.01:
        return 10
    return 1 if front > 0.35 and front < before["laser_front"] - 0.01 else 0


inputs = "ADE"


def value_of(rows, policy, n_states, gamma, sweeps):
    v = np.zeros(n_states)
    for _ in range(sweeps):
        old = v.copy()
        for s in range(n_states):
            seen = [r + gamma * old[s_next] for s_row, a, r, s_next in rows if (s_row, a) == (s, policy[s])]
            v[s] = sum(seen) / len(seen) if seen else 0
    return v


def interval(values, t):
    mean, n = np.mean(values), len(values)
    half = t * np.std(values, ddof=1) / np.sqrt(n)
    return [mean - half, mean + half]


def verdict(first, second, t):
    low, high = interval(np.subtract(first, second), t)
    if low > 0:
        return "first"
    if high < 0:
        return "second"
    return "open"
