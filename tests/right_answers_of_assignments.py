"""Other right answers to the assignments, written unlike the solutions."""

import numpy as np


def returns(rewards, ends, gamma):
    """Each return by its definition, a sum."""
    g = []
    for t in range(len(rewards)):
        last = next((k for k in range(t, len(rewards)) if ends[k]), len(rewards) - 1)
        g.append(sum(gamma ** (k - t) * rewards[k] for k in range(t, last + 1)))
    return np.array(g)


def replay(q, log, alpha, gamma):
    for i in range(len(log)):
        s, a, r, s_next, terminated = log[-1 - i]
        q[s, a] = (1 - alpha) * q[s, a] + alpha * (r + (not terminated) * gamma * np.max(q[s_next]))


def greedy(q):
    policy = np.zeros(q.shape)
    for row, q_s in zip(policy, q, strict=True):
        best = np.flatnonzero(q_s == max(q_s))
        row[best] = 1 / len(best)
    return policy


def train(env, q, choose, episodes, alpha, gamma):
    sums = [0.0] * episodes
    for i in range(episodes):
        s = env.reset()
        while True:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            q[s, a] = (1 - alpha) * q[s, a] + alpha * (r + (0 if terminated else gamma * np.max(q[s_next])))
            sums[i] += r
            if terminated or truncated:
                break
            s = s_next
    return sums


ASSIGNMENTS = {
    "assignment_1": {
        "state_of": lambda cell, voltage, cuts: (1 + len(cuts)) * cell + int(np.searchsorted(cuts, voltage)),
        "returns": returns,
        "replay": replay,
        "greedy": greedy,
        "train": train,
    },
}
