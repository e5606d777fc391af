"""Solutions of assignment 1, as a learner writes them."""

import numpy as np


def state_of(cell, voltage, cuts):
    charge = sum(voltage > cut for cut in cuts)
    return cell * (len(cuts) + 1) + charge


def returns(rewards, ends, gamma):
    g, follows = [0.0] * len(rewards), 0.0
    for t in range(len(rewards) - 1, -1, -1):
        if ends[t]:
            follows = 0.0
        g[t] = rewards[t] + gamma * follows
        follows = g[t]
    return g


def replay(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in reversed(log):
        target = r if terminated else r + gamma * max(q[s_next])
        q[s, a] += alpha * (target - q[s, a])


def greedy(q):
    best = q == np.max(q, axis=1, keepdims=True)
    return best / best.sum(axis=1, keepdims=True)


def train(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s, total, over = env.reset(), 0.0, False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            target = r if terminated else r + gamma * max(q[s_next])
            q[s, a] += alpha * (target - q[s, a])
            s, total, over = s_next, total + r, terminated or truncated
        sums.append(total)
    return sums
