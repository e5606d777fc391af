"""Answers to the exercises of the assignments, in the versions that the notebooks have."""

import math

import numpy as np


def a1_state_of(cell, voltage, cuts):
    return cell * (len(cuts) + 1) + sum(voltage > cut for cut in cuts)


def a1_returns(rewards, ends, gamma):
    found, later = [], 0
    for r, end in zip(reversed(rewards), reversed(ends), strict=True):
        later = r if end else r + gamma * later
        found.append(later)
    return found[::-1]


def a1_replay(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in reversed(log):
        best = 0 if terminated else q[s_next].max()
        q[s, a] += alpha * (r + gamma * best - q[s, a])


def a1_greedy(q):
    best = q == q.max(axis=1, keepdims=True)
    return best / best.sum(axis=1, keepdims=True)


def a1_train(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s, total, over = env.reset(), 0, False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            a1_replay(q, [(s, a, r, s_next, terminated)], alpha, gamma)
            s, total, over = s_next, total + r, terminated or truncated
        sums.append(total)
    return sums


def a2_epsilon_at(t, start, end, half_life):
    return end + (start - end) * 0.5 ** (t / half_life)


def a2_policy_value(q_s, temperature):
    powers = np.exp((q_s - q_s.max()) / temperature)
    return (powers * q_s).sum() / powers.sum()


a2_who = [3, 2, 1, 0]


def a2_double_update(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    mine, other = (q1, q2) if heads else (q2, q1)
    later = 0 if terminated else other[s_next, np.argmax(mine[s_next])]
    mine[s, a] += alpha * (r + gamma * later - mine[s, a])


def a2_double_learn(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, over = env.reset(), False
        while not over:
            a = choose(q1 + q2, s)
            s_next, r, terminated, truncated = env.step(a)
            a2_double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s, over = s_next, terminated or truncated


def a3_return_over_n(rewards, values, t, n, gamma):
    end = min(t + n, len(rewards))
    total = sum(gamma**k * r for k, r in enumerate(rewards[t:end]))
    if t + n < len(rewards):
        total += gamma**n * values[t + n]
    return total


def a3_trace_after(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e *= decay
        e[s] = e[s] + 1 if kind == "accumulating" else 1
    return e


def a3_td_episode(v, path, rewards, alpha, gamma, lam, kind):
    e = np.zeros(len(v))
    for t, r in enumerate(rewards):
        s = path[t]
        later = v[path[t + 1]] if t + 1 < len(rewards) else 0
        delta = r + gamma * later - v[s]
        e *= gamma * lam
        e[s] = e[s] + 1 if kind == "accumulating" else 1
        v += alpha * delta * e


def a3_true_online_episode(v, path, rewards, alpha, gamma, lam):
    e = np.zeros(len(v))
    old = 0
    for t, r in enumerate(rewards):
        s, now = path[t], v[path[t]]
        later = v[path[t + 1]] if t + 1 < len(rewards) else 0
        delta = r + gamma * later - now
        e *= gamma * lam
        e[s] = (1 - alpha) * e[s] + 1
        v += alpha * (delta + now - old) * e
        v[s] -= alpha * (now - old)
        old = later


def a3_watkins_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    if terminated:
        delta, goes_on = r - q[s, a], False
    else:
        delta = r + gamma * q[s_next].max() - q[s, a]
        goes_on = q[s_next, a_next] == q[s_next].max()
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam if goes_on else 0


def a4_near_states(s, shape, is_circle):
    bins = list(np.unravel_index(s, shape))
    found = set()
    for i, n in enumerate(shape):
        for step in (-1, 1):
            b = bins[i] + step
            if is_circle[i]:
                b %= n
            if 0 <= b < n:
                near = [*bins[:i], b, *bins[i + 1 :]]
                found.add(int(np.ravel_multi_index(near, shape)))
    return sorted(found - {s})


def a4_bias_table(q, shape):
    whole = q.reshape(*shape, -1)
    n = len(shape)
    means = [
        np.broadcast_to(whole.mean(axis=i, keepdims=True), whole.shape)
        for i in range(n)
    ]
    return (sum(means) / n).reshape(q.shape)


def a4_period(states):
    for p in range(1, len(states) // 2 + 1):
        if states[-p:] == states[-2 * p : -p]:
            return p
    return 0


def a4_next_temperature(temperature, states, rewards, default):
    p = a4_period(states)
    if p > 0 and sum(rewards[-p:]) < 0:
        return min(50, temperature + len(states) / (4 * p))
    return default


def a5_park_reward(before, after):
    lasers = ("laser_front", "laser_front_left", "laser_front_right")
    if min(after[name] for name in lasers) < 0.05:
        return -10
    moved = math.hypot(after["x"] - before["x"], after["y"] - before["y"])
    if moved < 0.01 and 0.15 < after["laser_front"] <= 0.35:
        return 10
    is_nearer = before["laser_front"] - after["laser_front"] > 0.01
    return 1 if is_nearer and before["laser_front"] > 0.35 else 0


a5_inputs = "ADE"


def a5_value_of(rows, policy, n_states, gamma, sweeps):
    v = np.zeros(n_states)
    for _ in range(sweeps):
        new = np.zeros(n_states)
        for state in range(n_states):
            found = [
                r + gamma * v[s_next]
                for s, a, r, s_next in rows
                if s == state and a == policy[state]
            ]
            new[state] = np.mean(found) if found else 0
        v = new
    return v


def a5_interval(values, t):
    mean = np.mean(values)
    half = t * np.std(values, ddof=1) / math.sqrt(len(values))
    return [mean - half, mean + half]


def a5_verdict(first, second, t):
    low, high = a5_interval(np.asarray(first) - np.asarray(second), t)
    if low > 0:
        return "first"
    return "second" if high < 0 else "open"
