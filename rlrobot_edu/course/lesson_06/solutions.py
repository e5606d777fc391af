"""Solutions of lesson 06, as a learner writes them."""


def dutch(e, alpha):
    return (1 - alpha) * e + 1


by_hand = 6 + 0.25 * ((10 + 0.9 * 10 - 6) + 6 - 4) * (0.75 * 0.6 + 1) - 0.25 * (6 - 4)


def true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa = q[s, a]
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    e[s, a] = dutch(e[s, a], alpha)
    q += alpha * (delta + q_sa - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next
