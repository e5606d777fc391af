"""Solutions of appendix 15a, as a learner writes them."""


def learn_from(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        best = 0 if terminated else max(q[s_next])
        q[s, a] = q[s, a] + alpha * (r + gamma * best - q[s, a])


two_targets = (10 + 0.9 * 40, 10 + 0.9 * 5)

last_action = "C"
