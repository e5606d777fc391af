"""Other right answers to the assignments, written unlike the solutions."""

import math

import numpy as np
from scipy.special import softmax

from rlrobot_edu.widgets.kernels import bias_of


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
        q[s, a] = (1 - alpha) * q[s, a] + alpha * (
            r + (not terminated) * gamma * np.max(q[s_next])
        )


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
            q[s, a] = (1 - alpha) * q[s, a] + alpha * (
                r + (0 if terminated else gamma * np.max(q[s_next]))
            )
            sums[i] += r
            if terminated or truncated:
                break
            s = s_next
    return sums


def policy_value(q_s, temperature):
    return softmax(q_s / temperature) @ q_s


def double_update(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    """Each case written out."""
    if heads:
        follows = 0.0 if terminated else q2[s_next, np.argmax(q1[s_next])]
        q1[s, a] = (1 - alpha) * q1[s, a] + alpha * (r + gamma * follows)
    else:
        follows = 0.0 if terminated else q1[s_next, np.argmax(q2[s_next])]
        q2[s, a] = (1 - alpha) * q2[s, a] + alpha * (r + gamma * follows)


def double_learn(env, q1, q2, choose, toss, episodes, alpha, gamma):
    """It chooses by the mean of the tables, which is as good as their sum."""
    while episodes > 0:
        s = env.reset()
        while True:
            a = choose((q1 + q2) / 2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            if terminated or truncated:
                break
            s = s_next
        episodes -= 1


def return_over_n(rewards, values, t, n, gamma):
    """By the returns of fewer steps, from the far end on."""
    last = min(t + n, len(rewards))
    g = values[last] if last < len(rewards) else 0.0
    for k in range(last - 1, t - 1, -1):
        g = rewards[k] + gamma * g
    return g


def trace_after(path, n_states, decay, kind):
    """From the ages of all visits."""
    visits = [
        [decay ** (len(path) - 1 - i) for i, s in enumerate(path) if s == state]
        for state in range(n_states)
    ]
    return np.array(
        [(sum if kind == "accumulating" else max)([*ages, 0.0]) for ages in visits]
    )


def td_episode(v, path, rewards, alpha, gamma, lam, kind):
    """The traces made anew in each step, by their definition."""
    for t, r in enumerate(rewards):
        e = trace_after(path[: t + 1], len(v), gamma * lam, kind)
        follows = v[path[t + 1]] if t + 1 < len(rewards) else 0.0
        v += alpha * (r + gamma * follows - v[path[t]]) * e


def true_online_episode(v, path, rewards, alpha, gamma, lam):
    """The online λ-return algorithm, of which the exercise's is the fast form: after each step, all targets anew."""
    first, seen = v.copy(), []  # seen: what each s' was worth when the robot came there
    for h in range(1, len(rewards) + 1):
        seen.append(v[path[h]] if h < len(rewards) else 0.0)
        new = first.copy()
        for k in range(h):
            g = rewards[h - 1] + gamma * seen[h - 1]
            for j in range(h - 2, k - 1, -1):
                g = rewards[j] + gamma * ((1 - lam) * seen[j] + lam * g)
            new[path[k]] += alpha * (g - new[path[k]])
        v[:] = new


def watkins_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    worth = 0.0 if terminated else np.max(q[s_next])
    goes_on = not terminated and a_next in np.flatnonzero(q[s_next] == worth)
    e[s, a] = 1.0
    q[:] = q + e * alpha * (r + gamma * worth - q[s, a])
    e[:] = e * gamma * lam if goes_on else 0.0


def near_states(s, shape, is_circle):
    """All states are looked at: which differ by one bin in one input?"""

    def apart(a, b, n, circle):
        return min((a - b) % n, (b - a) % n) if circle else abs(a - b)

    here = np.unravel_index(s, shape)
    return [
        other
        for other, there in enumerate(np.ndindex(*shape))
        if sum(
            apart(a, b, n, c)
            for a, b, n, c in zip(here, there, shape, is_circle, strict=True)
        )
        == 1
    ]


def bias_table(q, shape):
    """State by state, with the library's own bias."""
    return np.array([bias_of(q, shape, s) for s in range(len(q))])


def period(states):
    n = len(states)
    for p in range(1, n // 2 + 1):
        if all(states[n - 1 - i] == states[n - 1 - i - p] for i in range(p)):
            return p
    return 0


def next_temperature(temperature, states, rewards, default):
    p = period(states)
    stuck = p > 0 and np.mean(rewards[len(rewards) - p :]) < 0
    return min(50.0, temperature + len(states) / p / 4) if stuck else default


def drive(env, q, shape, us, alpha, gamma, scale, default):
    """The queues are cut when they are looked at, and the state's own bias alone is computed."""
    s, seen, paid, temperature, earned, heat = env.reset(), [], [], default, [], []
    for u in us:
        p = softmax(scale * (q[s] + bias_of(q, shape, s)) / temperature)
        a = int(np.searchsorted(np.cumsum(p), u, side="right").clip(max=len(p) - 1))
        s_next, r, terminated, truncated = env.step(a)
        q[s, a] = (1 - alpha) * q[s, a] + alpha * (
            r + (not terminated) * gamma * max(q[s_next])
        )
        earned += [r]
        heat += [temperature]
        seen += [s_next]
        paid += [r]
        temperature = next_temperature(temperature, seen[-8:], paid[-8:], default)
        s = s_next
        if terminated or truncated:
            s, seen, paid, temperature = env.reset(), [], [], default
    return np.array([earned, heat])


def park_reward(before, after):
    """Other numbers, and the coming nearer is paid by its length."""
    ahead, sides = (
        after["laser_front"],
        (after["laser_front_left"], after["laser_front_right"]),
    )
    if ahead < 0.05 or min(sides) < 0.05:
        return -5
    way = math.dist((before["x"], before["y"]), (after["x"], after["y"]))
    if ahead <= 0.35:
        return 3.0 * (ahead > 0.15 and way < 0.01)
    return max(0.0, before["laser_front"] - ahead)


def value_of(rows, policy, n_states, gamma, sweeps):
    """With the mean rewards and the probabilities of what follows, as matrices."""
    t, r = np.zeros((n_states, n_states)), np.zeros(n_states)
    for s in range(n_states):
        mine = [row for row in rows if row[0] == s and row[1] == policy[s]]
        for _, _, reward, s_next in mine:
            t[s, s_next] += 1 / len(mine)
            r[s] += reward / len(mine)
    v = np.zeros(n_states)
    for _ in range(sweeps):
        v = r + gamma * t @ v
    return v


def interval(values, t):
    n = len(values)
    mean = sum(values) / n
    spread = math.sqrt(sum((x - mean) ** 2 for x in values) / (n - 1))
    return np.array([mean - t * spread / n**0.5, mean + t * spread / n**0.5])


def verdict(first, second, t):
    low, high = interval(np.subtract(second, first), t)
    return "open" if low <= 0 <= high else "second" if low > 0 else "first"


ASSIGNMENTS = {
    "assignment_1": {
        "state_of": lambda cell, voltage, cuts: (
            (1 + len(cuts)) * cell + int(np.searchsorted(cuts, voltage))
        ),
        "returns": returns,
        "replay": replay,
        "greedy": greedy,
        "train": train,
    },
    "assignment_2": {
        "epsilon_at": lambda t, start, end, half_life: (
            (start - end) / 2 ** (t / half_life) + end
        ),
        "policy_value": policy_value,
        "who": (3, 2, 1, 0),
        "double_update": double_update,
        "double_learn": double_learn,
    },
    "assignment_3": {
        "return_over_n": return_over_n,
        "trace_after": trace_after,
        "td_episode": td_episode,
        "true_online_episode": true_online_episode,
        "watkins_update": watkins_update,
    },
    "assignment_4": {
        "near_states": near_states,
        "bias_table": bias_table,
        "period": period,
        "next_temperature": next_temperature,
        "drive": drive,
    },
    "assignment_5": {
        "park_reward": park_reward,
        "inputs": ["E", "A", "D"],
        "value_of": value_of,
        "interval": interval,
        "verdict": verdict,
    },
}
