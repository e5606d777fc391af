"""Solutions of lesson 06, as a learner writes them."""


def lambda_return(rewards, values, gamma, lam):
    n, total, mean = len(rewards), 0.0, 0.0
    for k in range(1, n + 1):
        total += gamma ** (k - 1) * rewards[k - 1]
        g = total + gamma**k * values[k - 1]  # the k-step return
        weight = lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1)
        mean += weight * g
    return mean


def dutch(e, alpha):
    return (1 - alpha) * e + 1


by_hand = 6 + 0.5 * ((10 + 0.9 * 10 - 6) + 6 - 4) * 1.4 - 0.5 * (6 - 4)


def true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa = q[s, a]
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    e[s, a] = dutch(e[s, a], alpha)
    q += alpha * (delta + q_sa - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


largest_alpha = 1 - 0.9 * 0.9
