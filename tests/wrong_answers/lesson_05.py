"""Typical wrong answers of lesson 05, written as learners write them, and words of the hint each must get."""

import numpy as np


def update_fades_first(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + gamma * q[s_next, a_next] * (not terminated) - q[s, a]
    e[s, a] = 1
    for x in range(len(q)):
        for b in range(len(q[x])):
            e[x, b] = gamma * lam * e[x, b]
            q[x, b] = q[x, b] + alpha * delta * e[x, b]


def update_book_order(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    target = r if terminated else r + gamma * q[s_next, a_next]
    delta = target - q[s, a]
    e[:] = gamma * lam * e
    e[s, a] = 1
    q[:] = q + alpha * delta * e


def update_unexplored_only(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    others = np.ones(e.shape, dtype=bool)
    others[s, a] = False
    e[others] *= gamma * lam


def update_trace_too_late(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    for x, b in np.argwhere(e > 0):
        q[x, b] += alpha * delta * e[x, b]
    e[s, a] = 1
    e *= gamma * lam


def update_new_e(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e = e * gamma * lam


def update_gamma_only(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma


def update_lam_only(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= lam


def update_accumulating(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = e[s, a] + 1
    q += alpha * delta * e
    e *= gamma * lam


def update_lesson_04_with_traces(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q[s, a] += alpha * delta * e[s, a]
    e *= gamma * lam


def update_without_e(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q[e > 0] += alpha * delta
    e *= gamma * lam


def update_past_the_end(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def update_max(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * max(q[s_next])) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def update_own_delta(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e[s, a] = 1
    target = r if terminated else r + gamma * q[s_next, a_next]
    for x in range(q.shape[0]):
        for b in range(q.shape[1]):
            q[x, b] += alpha * e[x, b] * (target - q[x, b])
    e *= gamma * lam


def update_moving_delta(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e[s, a] = 1
    for x in range(q.shape[0]):
        for b in range(q.shape[1]):
            delta = r - q[s, a] if terminated else r + gamma * q[s_next, a_next] - q[s, a]
            q[x, b] += alpha * delta * e[x, b]
            e[x, b] *= gamma * lam


def update_row(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, :] = 1
    q += alpha * delta * e
    e *= gamma * lam


def update_new_q(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q = q + alpha * delta * e
    e *= gamma * lam


def update_clears(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (1 - terminated) * gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    if terminated:
        e.fill(0)
    else:
        e *= gamma * lam


def update_new_q_and_e(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = 1
    q = q + alpha * delta * e
    e = e * gamma * lam


def update_no_alpha(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] = 1
    q += delta * e
    e *= gamma * lam


def update_drops_small_traces(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam
    e[e < 0.01] = 0


def update_clears_the_row(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, :] = 0
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def update_reuses_names(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e[s, a] = 1
    for s in range(len(q)):
        for a in range(len(q[s])):
            delta = r + gamma * (0 if terminated else q[s_next, a_next]) - q[s, a]
            q[s, a] += alpha * delta * e[s, a]
            e[s, a] *= gamma * lam


def update_fades_by_an_amount(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e -= gamma * lam


def update_twice(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] = 1
    q[s, a] += alpha * delta
    q += alpha * delta * e
    e *= gamma * lam


def update_hands_the_trace_on(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e[s_next, a_next] = lam * gamma


def update_lam_in_delta(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + lam * q[s_next, a_next] * (not terminated) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma


def update_sets_the_trace_last(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    q[s, a] += alpha * delta
    q += alpha * delta * e
    e[s, a] = 1
    e *= gamma * lam


def update_traces_of_delta(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e[s, a] = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    q += alpha * e
    e *= gamma * lam


def update_alpha_twice(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = alpha * (r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a])
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def return_from_one(r, v, n, gamma):
    g = 0
    for k in range(1, n + 1):
        g += gamma ** (k - 1) * r[k]
    return g + gamma**n * v[n]


def return_believes_all_along(r, v, n, gamma):
    return sum(gamma**k * (r[k] + gamma * v[k + 1]) for k in range(n))


WRONG = {
    "by_hand": [
        (1.0, "whose trace is 1"),
        (2 - 0.45, "one step only"),
        (2 - 0.81, "forgot λ"),
        (1.75, "forgot γ"),
        (2 - 10 * 0.2025, "forgot α"),
        (0.45**2, "the trace itself"),
        (2 + 0.45**2, "Q smaller"),
        (2 * 0.2025, "does not fade"),
        (2 - 10 * (0.1 * 0.45) ** 2, "enters once"),
    ],
    "sarsa_lambda_update": [
        (update_fades_first, "fade too soon"),
        (update_book_order, "handed on before"),
        (update_unexplored_only, "that of (s, a), too"),
        (update_trace_too_late, "before q learns"),
        (update_new_e, "e *="),
        (update_gamma_only, "forgot λ"),
        (update_lam_only, "forgot γ"),
        (update_accumulating, "accumulate"),
        (update_lesson_04_with_traces, "only the pair"),
        (update_without_e, "Multiply by the trace"),
        (update_past_the_end, "past the end"),
        (update_max, "Q-learning"),
        (update_own_delta, "δ of its own"),
        (update_moving_delta, "Compute it once"),
        (update_row, "all actions of s"),
        (update_new_q, "q +="),
        (update_new_q_and_e, "neither q nor"),
        (update_clears, "loop's work"),
        (update_no_alpha, "forgot α"),
        (update_drops_small_traces, "trick for speed"),
        (update_clears_the_row, "other actions of s"),
        (update_reuses_names, "loses the pair"),
        (update_fades_by_an_amount, "not by an amount"),
        (update_twice, "learns twice"),
        (update_sets_the_trace_last, "a trace already"),
        (update_traces_of_delta, "not a δ"),
        (update_alpha_twice, "α enters once"),
        (update_hands_the_trace_on, "in the next step"),
        (update_lam_in_delta, "stands γ alone"),
    ],
    "n_step_return": [
        (lambda r, v, n, gamma: sum(gamma**k * r[k] for k in range(n)), "value after the n rewards"),
        (lambda r, v, n, gamma: sum(r[:n]) + gamma**n * v[n], "not discounted"),
        (lambda r, v, n, gamma: sum(gamma**k * x for k, x in enumerate(r)), "to the end of the episode"),
        (lambda r, v, n, gamma: gamma ** np.arange(n) @ r[:n] + gamma * v[n], "γ once"),
        (lambda r, v, n, gamma: gamma ** np.arange(n) @ r[:n] + v[n], "discounted"),
        (lambda r, v, n, gamma: gamma ** np.arange(1, n + 1) @ r[:n] + gamma**n * v[n], "in full"),
        (lambda r, v, n, gamma: gamma ** np.arange(n) @ r[:n] + gamma**n * v[n - 1], "too early"),
        (return_from_one, "counts from 0"),
        (return_believes_all_along, "believed once"),
        (lambda r, v, n, gamma: gamma ** np.arange(n) @ r[:n] + gamma**n * v[-1], "last value"),
        (lambda r, v, n, gamma: gamma ** np.arange(n) @ r[:n] + gamma ** len(r) * v[len(r)], "end of the episode"),
        (lambda r, v, n, gamma: r[0] + gamma * sum(r[1:n]) + gamma * v[n], "γ everywhere"),
    ],
}
