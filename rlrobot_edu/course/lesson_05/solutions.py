"""Solutions of lesson 05, as a learner writes them."""

by_hand = 2 + 0.1 * (-10) * (0.9 * 0.5) ** 2


def sarsa_lambda_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def n_step_return(r, v, n, gamma):
    g = gamma**n * v[n]
    for k in range(n):
        g += gamma**k * r[k]
    return g
