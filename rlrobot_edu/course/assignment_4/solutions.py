"""Solutions of assignment 4, as a learner writes them."""

import numpy as np

from rlrobot_edu.course.assignment_4.given import draw


def near_states(s, shape, is_circle):
    near, bins = set(), np.unravel_index(s, shape)
    for i in range(len(shape)):
        for step in (-1, 1):
            other = list(bins)
            other[i] += step
            if is_circle[i]:
                other[i] %= shape[i]
            if 0 <= other[i] < shape[i]:
                near.add(int(np.ravel_multi_index(other, shape)))
    return sorted(near - {s})


def bias_table(q, shape):
    table = q.reshape(*shape, q.shape[1])
    total = np.zeros(table.shape)
    for i in range(len(shape)):
        total += table.mean(axis=i, keepdims=True)
    return (total / len(shape)).reshape(q.shape)


def period(states):
    for p in range(1, len(states) // 2 + 1):
        if states[-p:] == states[-2 * p : -p]:
            return p
    return 0


def next_temperature(temperature, states, rewards, default):
    p = period(states)
    if p > 0 and sum(rewards[-p:]) < 0:
        return min(50, temperature + len(states) / (4 * p))
    return default


def drive(env, q, shape, us, alpha, gamma, scale, default):
    earned, heat, states, rewards, temperature = [], [], [], [], default
    s = env.reset()
    for u in us:
        x = scale * (q[s] + bias_table(q, shape)[s])
        a = draw(x, temperature, u)
        s_next, r, terminated, truncated = env.step(a)
        target = r if terminated else r + gamma * max(q[s_next])
        q[s, a] += alpha * (target - q[s, a])
        earned.append(r)
        heat.append(temperature)
        states, rewards = [*states, s_next][-8:], [*rewards, r][-8:]
        temperature = next_temperature(temperature, states, rewards, default)
        s = s_next
        if terminated or truncated:
            s, states, rewards, temperature = env.reset(), [], [], default
    return earned, heat
