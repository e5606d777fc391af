"""What is learned along a path, step by step; a page runs these functions as JavaScript.

All of them fill tables whose row t is what holds after step t, and whose row 0 is 0. Step t leaves cell `cells[t - 1]`,
is paid `rewards[t - 1]` and leads to `cells[t]`. A cell has one action, and so one pair. No step is terminal.
"""


def sarsa_lambda(q, e, delta, cells, rewards, alpha, gamma, lam, accumulating):
    """SARSA(λ).

    q, e: tables (n + 1, n_cells): values, and traces as the step uses them, before they fade; delta: TD errors (n + 1,)
    accumulating: 1, or 0 for replacing traces
    """
    for t in range(1, q.shape[0]):
        s = cells[t - 1]
        s_next = cells[t]
        delta[t] = rewards[t - 1] + gamma * q[t - 1, s_next] - q[t - 1, s]
        for x in range(q.shape[1]):
            e[t, x] = gamma * lam * e[t - 1, x]
        e[t, s] = accumulating * e[t, s] + 1.0
        for x in range(q.shape[1]):
            q[t, x] = q[t - 1, x] + alpha * delta[t] * e[t, x]


def true_online(q, e, delta, q_old, cells, rewards, alpha, gamma, lam, first, second):
    """True online SARSA(λ), whose two terms with Q_old can be left out.

    q, e, delta: see `sarsa_lambda`; q_old: array (n + 1,), Q_old as step t uses it
    first, second: 1, or 0 to leave out the term of the first or the second line
    """
    noted = 0.0
    for t in range(1, q.shape[0]):
        s = cells[t - 1]
        q_sa = q[t - 1, s]
        q_next = q[t - 1, cells[t]]
        delta[t] = rewards[t - 1] + gamma * q_next - q_sa
        q_old[t] = noted
        for x in range(q.shape[1]):
            e[t, x] = gamma * lam * e[t - 1, x]
        e[t, s] = (1.0 - alpha) * e[t, s] + 1.0
        for x in range(q.shape[1]):
            change = delta[t] + first * (q_sa - noted)
            q[t, x] = q[t - 1, x] + alpha * change * e[t, x]
        q[t, s] -= second * alpha * (q_sa - noted)
        noted = q_next


def online_lambda_return(q, cells, rewards, alpha, gamma, lam):
    """The ideal: after each step the whole path is learned again, each visit towards its λ-return as known by now.

    q: table (n + 1, n_cells), as of `sarsa_lambda`. Source: Sutton & Barto, section 12.4.
    """
    for h in range(1, q.shape[0]):
        for t in range(h):
            g = q[h - 1, cells[h]]
            for back in range(h - t):
                k = h - 1 - back  # from the last reward to that of this visit
                g = rewards[k] + gamma * ((1.0 - lam) * q[k, cells[k + 1]] + lam * g)
            s = cells[t]
            q[h, s] += alpha * (g - q[h, s])
