"""Answers to the exercises of the lessons."""

import math
from itertools import pairwise

import numpy as np


def l01_bin_of(x, cuts):
    return sum(x > cut for cut in cuts)


def l01_state_number(bins, shape):
    number = 0
    for b, n in zip(bins, shape, strict=True):
        number = number * n + b
    return number


def l01_reward(before, after):
    if min(after["laser_front_left"], after["laser_front_right"]) < 0.10:
        return -2
    moved = math.hypot(after["x"] - before["x"], after["y"] - before["y"])
    return 10 if moved > 0.07 else 0


def l02_discounted_return(rewards, gamma):
    return sum(gamma**k * r for k, r in enumerate(rewards))


l03_q_by_hand = 4 + 0.2 * (10 + 0.9 * 6 - 4)


def l03_target(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * np.max(q[s_next])


def l03_update(q, s, a, r, s_next, terminated, alpha, gamma):
    best = 0 if terminated else np.max(q[s_next])
    q[s, a] += alpha * (r + gamma * best - q[s, a])


def l03_learn(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = env.reset() if terminated or truncated else s_next


def l04_epsilon_greedy(q_s, epsilon):
    best = q_s == q_s.max()
    return epsilon / len(q_s) + (1 - epsilon) * best / best.sum()


def l04_draw(p, u):
    return int(np.searchsorted(np.cumsum(p), u, side="right"))


def l04_softmax(x, temperature):
    powers = np.exp((x - np.max(x)) / temperature)
    return powers / powers.sum()


def l04_normalise(q_s, r_max, gamma):
    return q_s * (1 - gamma) / r_max


def l05_siblings(shape, s, i):
    bins = list(np.unravel_index(s, shape))
    found = []
    for b in range(shape[i]):
        bins[i] = b
        found.append(int(np.ravel_multi_index(bins, shape)))
    return sorted(found)


l05_bias_by_hand = ((5 + 10) / 2 + (5 + 2) / 2 + (5 + 14 - 1) / 3 + (5 - 8) / 2) / 4


def l05_bias(q, shape, s):
    sets = [l05_siblings(shape, s, i) for i in range(len(shape))]
    return np.mean([q[each].mean(axis=0) for each in sets], axis=0)


l05_best_adviser = "floor"


def l06_sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    later = 0 if terminated else q[s_next, a_next]
    q[s, a] += alpha * (r + gamma * later - q[s, a])


def l06_sarsa_learn(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = None if terminated else choose(q, s_next)
        update(q, s, a, r, s_next, a_next, terminated)
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)
        else:
            s, a = s_next, a_next


l06_fall = 1 - (1 - 0.1 / 4) ** 11
l07_traced_by_hand = 2 + 0.1 * -10 * (0.9 * 0.5) ** 2


def l07_sarsa_lambda_update(
    q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
):
    later = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * later - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def l08_dutch(e, alpha):
    return (1 - alpha) * e + 1


_TRACE = (1 - 0.25) * 0.6 + 1
l08_true_online_by_hand = (
    6 + 0.25 * (10 + 0.9 * 10 - 6 + 6 - 1) * _TRACE - 0.25 * (6 - 1)
)


def l08_true_online_update(
    q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
):
    now = q[s, a]
    later = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * later - now
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (delta + now - q_old) * e
    q[s, a] -= alpha * (now - q_old)
    e *= gamma * lam
    return later


def l09_new_temperature(temperature, states, rewards, s, default):
    if states.count(s) > 1 and np.mean(rewards) < 0:
        return temperature + len(states) / len(set(states))
    return default


l09_heats = "ABCF"


def l10_preferences(q, shape, s, r_max, gamma):
    return l04_normalise(q[s] + l05_bias(q, shape, s), r_max, gamma)


def l10_choose(q, shape, s, temperature, r_max, gamma, u):
    return l04_draw(
        l04_softmax(l10_preferences(q, shape, s, r_max, gamma), temperature), u
    )


def l10_learn(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature):
    q = np.zeros((np.prod(shape), n_actions))
    e = np.zeros_like(q)

    def choose(s):
        return l10_choose(q, shape, s, temperature, r_max, gamma, rng.random())

    s = env.reset()
    a, q_old = choose(s), 0
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(s_next)
        q_old = l08_true_online_update(
            q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
        )
        s, a = s_next, a_next
        if terminated or truncated:
            e[:] = 0
            s = env.reset()
            a, q_old = choose(s), 0
    return q


def l11_motion(left, right, radius, separation):
    speed = radius * (left + right) / 2
    return speed, np.degrees(radius * (right - left) / separation)


l12_targets = (10, 10 + 0.9 * 50)
l12_to_and_fro = (5 - 0.9) / (1 - 0.81)


def l12_shaping(phi, phi_next, terminated, gamma):
    return gamma * (0 if terminated else phi_next) - phi


def l13_gripper(arm, biceps, forearm, upper=0.23, lower=0.25, shoulder=0.12):
    below = biceps + forearm
    out = upper * np.sin(biceps) + lower * np.cos(below)
    up = shoulder + upper * np.cos(biceps) - lower * np.sin(below)
    return out * np.cos(arm), out * np.sin(arm), up


l13_pays = (0, 5)


def l13_arm_reward(before, after):
    return 10 if after <= 0.05 else 10 * (before - after)


def l14_estimate(rows, s, a):
    found = {}
    for row in rows:
        if row[:2] == (s, a):
            found.setdefault(row[3], []).append(row[2])
    n = sum(len(rewards) for rewards in found.values())
    return {
        s_next: (len(rewards) / n, sum(rewards) / len(rewards))
        for s_next, rewards in found.items()
    }


def l14_sample(rows, s, a, u):
    mine = [row for row in rows if row[:2] == (s, a)]
    if not mine:
        return None
    _, _, r, s_next = mine[int(u * len(mine))]
    return s_next, r


l14_second_look = (5 - 0.01 + 0.45 * 40) / (1 - 0.45)


def l15_p_value(observed, shuffled):
    return np.mean(shuffled >= observed)


l15_agents_needed = 2 * (3 / (0.5 / 3)) ** 2
l16_size = [3 * 4 * 2 * 8, 3600 / 192]


def l16_follow_reward(before, after):
    if (
        min(after["laser_front"], after["laser_front_right"], after["laser_right"])
        < 0.05
    ):
        return -2
    moved = math.hypot(after["x"] - before["x"], after["y"] - before["y"])
    return 10 if moved > 0.07 and 0.10 < after["laser_right"] <= 0.40 else -0.1


l16_still_safe = 2 * 0.0975 + 0.05
l17_planned_by_hand = 0.5 * 0.9 * (0.5 * 0.9 * 0.5)


def l17_dyna(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = env.reset() if terminated or truncated else s_next


def l18_nearest_ahead(ranges, angle_min, increment):
    met = [(i, r) for i, r in enumerate(ranges) if 0 < r < math.inf]
    if not met:
        return math.nan
    ahead = [r for i, r in met if math.cos(angle_min + i * increment) >= 0.5]
    return min(ahead, default=math.inf)


def l18_wheels(v, omega, radius, separation):
    turn = omega * separation / 2
    return (v - turn) / radius, (v + turn) / radius


def l18_allowed(v, omega, ahead, age):
    if math.isnan(age) or math.isnan(ahead) or age > 0.5:
        return 0, 0
    if ahead < 0.18 and v > 0:
        return 0, omega
    return v, omega


l19_one_stand = 0.1 * 10 * 0.81


def l20_learn_from(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        l03_update(q, s, a, r, s_next, terminated, alpha, gamma)


l20_two_targets = (10 + 0.9 * 40, 10 + 0.9 * 5)


def l21_overlaps(left, right, edges):
    pairs = pairwise(edges)
    return [
        max(0, min(right, high) - max(left, low)) / (right - left)
        for low, high in pairs
    ]


l22_two_biases = (((2 + 10) / 4 + 2 / 4) / 2, (3 * 2 + 10 + 3 * 2) / (3 + 1 + 3))
l22_how_far = (0.0975 * 0.75, 0.0975 * 0.5)
