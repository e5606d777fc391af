"""Typical wrong answers of assignment 1, written as learners write them, and a word of the hint each must get."""

import numpy as np


def state_too_few(cell, voltage, cuts):
    b = len([c for c in cuts if c < voltage])
    return len(cuts) * cell + b


def state_edge(cell, voltage, cuts):
    b = len([c for c in cuts if c <= voltage])
    return (len(cuts) + 1) * cell + b


def state_bin_first(cell, voltage, cuts):
    b = int(np.searchsorted(cuts, voltage))
    return b * (len(cuts) + 1) + cell


def state_added(cell, voltage, cuts):
    return cell + int(np.searchsorted(cuts, voltage))


def state_from_one(cell, voltage, cuts):
    return cell * (1 + len(cuts)) + 1 + int(np.searchsorted(cuts, voltage))


def returns_of_one_day(rewards, ends, gamma):
    g = list(rewards)
    for t in range(len(g) - 2, -1, -1):
        g[t] += gamma * g[t + 1]
    return g


def returns_undiscounted(rewards, ends, gamma):
    g = []
    for t in range(len(rewards)):
        total = 0.0
        for k in range(t, len(rewards)):
            total += rewards[k]
            if ends[k]:
                break
        g.append(total)
    return g


def returns_one_ahead(rewards, ends, gamma):
    g = []
    for t in range(len(rewards)):
        follows = rewards[t + 1] if t + 1 < len(rewards) and not ends[t] else 0
        g.append(rewards[t] + gamma * follows)
    return g


def returns_nothing_at_ends(rewards, ends, gamma):
    g = [0.0] * len(rewards)
    for t in reversed(range(len(rewards))):
        if not ends[t]:
            g[t] = rewards[t] + gamma * (g[t + 1] if t + 1 < len(rewards) else 0)
    return g


def returns_discounts_the_reward(rewards, ends, gamma):
    g = [0.0] * (len(rewards) + 1)
    for t in reversed(range(len(rewards))):
        g[t] = gamma * (rewards[t] + (0 if ends[t] else g[t + 1]))
    return g[:-1]


def replay_forward(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in log:
        best = 0 if terminated else q[s_next].max()
        q[s, a] = (1 - alpha) * q[s, a] + alpha * (r + gamma * best)


def replay_past_the_end(q, log, alpha, gamma):
    for s, a, r, s_next, _ in log[::-1]:
        q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])


def replay_adds_the_target(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in log[::-1]:
        q[s, a] += alpha * (r + (0 if terminated else gamma * q[s_next].max()))


def replay_without_gamma(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in log[::-1]:
        q[s, a] += alpha * (r + (not terminated) * q[s_next].max() - q[s, a])


def replay_leaves_ends_out(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in log[::-1]:
        if not terminated:
            q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])


def greedy_first(q):
    policy = np.zeros(q.shape)
    for s in range(len(q)):
        policy[s, q[s].argmax()] = 1
    return policy


def greedy_unshared(q):
    policy = np.zeros(q.shape)
    for s in range(len(q)):
        policy[s][q[s] == max(q[s])] = 1
    return policy


def greedy_worst(q):
    policy = (q == q.min(axis=1)[:, None]) * 1.0
    return policy / policy.sum(axis=1)[:, None]


def greedy_in_all(q):
    policy = q == q.max(axis=1)[:, None]
    return policy / np.sum(policy)


def greedy_soft(q):
    powers = np.exp(q)
    return powers / powers.sum(axis=1)[:, None]


def train_past_the_end(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s = env.reset()
        sums.append(0)
        while True:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])
            sums[-1] += r
            s = s_next
            if terminated or truncated:
                break
    return sums


def train_cut_short(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s = env.reset()
        sums.append(0)
        over = False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            over = terminated or truncated
            q[s, a] += alpha * (r + (0 if over else gamma * q[s_next].max()) - q[s, a])
            sums[-1] += r
            s = s_next
    return sums


def train_one_sum(env, q, choose, episodes, alpha, gamma):
    sums, total = [], 0
    for _ in range(episodes):
        s, over = env.reset(), False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            q[s, a] += alpha * (r + (0 if terminated else gamma * q[s_next].max()) - q[s, a])
            total += r
            s, over = s_next, terminated or truncated
        sums.append(total)
    return sums


def train_stands_still(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s, over, total = env.reset(), False, 0
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            q[s, a] += alpha * (r + (0 if terminated else gamma * q[s_next].max()) - q[s, a])
            total += r
            over = terminated or truncated
        sums.append(total)
    return sums


def train_last_sum(env, q, choose, episodes, alpha, gamma):
    for _ in range(episodes):
        s, over, total = env.reset(), False, 0
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            q[s, a] += alpha * (r + (0 if terminated else gamma * q[s_next].max()) - q[s, a])
            total += r
            s, over = s_next, terminated or truncated
    return total


WRONG = {
    "state_of": [
        (state_too_few, "k + 1 bins"),
        (state_edge, "On a cut".lower()),
        (state_bin_first, "bin counts most"),
        (state_added, "only added"),
        (state_from_one, "numbered from 0"),
    ],
    "returns": [
        (returns_of_one_day, "several episodes"),
        (returns_undiscounted, "γ is missing"),
        (returns_one_ahead, "only the next reward"),
        (returns_nothing_at_ends, "at which an episode ends counts in full"),
        (returns_discounts_the_reward, "counts in full"),
    ],
    "replay": [
        (replay_forward, "begins with the first"),
        (replay_past_the_end, "past the end"),
        (replay_adds_the_target, "minus the old"),
        (replay_without_gamma, "γ is missing"),
        (replay_leaves_ends_out, "has a target, too"),
    ],
    "greedy": [
        (greedy_first, "argmax"),
        (greedy_unshared, "share 1"),
        (greedy_worst, "worst"),
        (greedy_in_all, "sum to 1 in each row"),
        (greedy_soft, "probability 0"),
    ],
    "train": [
        (train_past_the_end, "past the end"),
        (train_cut_short, "only run out of time"),
        (train_one_sum, "its own sum"),
        (train_stands_still, "go on from s_next"),
        (train_last_sum, "last sum alone"),
    ],
}
