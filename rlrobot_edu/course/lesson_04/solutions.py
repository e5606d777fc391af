"""Solutions of lesson 04, as a learner writes them."""

by_hand = -6 + 0.25 * (-2 + 0.5 * -40 - -6)

fall = 1 - (1 - 0.1 / 4) ** 11


def sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[s_next, a_next]
    delta = target - q[s, a]
    q[s, a] = q[s, a] + alpha * delta


def sarsa_learn(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(q, s_next)
        update(q, s, a, r, s_next, a_next, terminated)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)
