"""Solutions of appendix 06a, as a learner writes them."""


def lambda_return(rewards, values, gamma, lam):
    n, total, mean = len(rewards), 0.0, 0.0
    for k in range(1, n + 1):
        total += gamma ** (k - 1) * rewards[k - 1]
        g = total + gamma**k * values[k - 1]  # the k-step return
        weight = lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1)
        mean += weight * g
    return mean


largest_alpha = 1 - 0.9 * 0.9
