"""Solutions of lesson 02, as a learner writes them."""

by_hand = 4 + 0.2 * (10 + 0.9 * 6 - 4)
look_ahead = 0.5**0.1


def target(q, r, s_next, terminated, gamma):
    if terminated:
        return r
    return r + gamma * max(q[s_next])


def update(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] = q[s, a] + alpha * delta


def learn(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()
