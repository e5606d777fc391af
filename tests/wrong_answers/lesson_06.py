"""Typical wrong answers of lesson 06, written as learners write them, and a word of the hint each must get."""

import numpy as np


def n_step_returns(rewards, values, gamma):
    powers = gamma ** np.arange(len(rewards) + 1)
    return np.cumsum(powers[:-1] * rewards) + powers[1:] * values


def lambda_all_weights_alike(rewards, values, gamma, lam):
    return (1 - lam) * lam ** np.arange(len(rewards)) @ n_step_returns(rewards, values, gamma)


def lambda_longest(rewards, values, gamma, lam):
    g = values[-1]
    for r in reversed(rewards):
        g = r + gamma * g
    return g


def lambda_one_step(rewards, values, gamma, lam):
    return rewards[0] + gamma * values[0]


def lambda_starts_at_zero(rewards, values, gamma, lam):
    g = 0
    for r, v in zip(rewards[::-1], values[::-1], strict=True):
        g = r + gamma * ((1 - lam) * v + lam * g)
    return g


def lambda_without_values(rewards, values, gamma, lam):
    g = 0
    for r in rewards[::-1]:
        g = r + gamma * lam * g
    return g


def lambda_without_gamma(rewards, values, gamma, lam):
    g = values[-1]
    for r, v in zip(rewards[::-1], values[::-1], strict=True):
        g = r + (1 - lam) * v + lam * g
    return g


def lambda_value_one_gamma_short(rewards, values, gamma, lam):
    g = n_step_returns(rewards, np.array(values) / gamma, gamma)
    weights = (1 - lam) * lam ** np.arange(len(g))
    weights[-1] = 1 - weights[:-1].sum()
    return weights @ g


def dutch_replacing(e, alpha):
    e = 1
    return e


def dutch_accumulating(e, alpha):
    e += 1
    return e


def dutch_alpha_stays(e, alpha):
    return 1 + alpha * e


def dutch_forgets_the_visit(e, alpha):
    return e - alpha * e


def dutch_brackets(e, alpha):
    return (1 + e) * (1 - alpha)


def dutch_adds_alpha(e, alpha):
    return e + alpha * (1 - e)


def update_keeps_q_old_after(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    before = q[s, a]
    following = 0 if terminated else q[s_next, a_next]
    e[s, a] += 1 - alpha * e[s, a]
    q += alpha * (r + gamma * following - q_old) * e
    q[s, a] -= alpha * (before - q_old)
    e *= gamma * lam
    return 0 if terminated else q[s_next, a_next]


def update_without_second_term(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = (not terminated) * q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    e *= gamma * lam
    return q_next


def update_as_in_lesson_05(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * delta * e
    e *= gamma * lam
    return q_next


def update_with_replacing_traces(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    e[s, a] = 1
    q += alpha * (delta + q_sa - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_fades_too_soon(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    e *= gamma * lam
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    return q_next


def update_fades_at_the_start(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e *= gamma * lam
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    return q_next


def update_past_the_end(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_with_changed_q(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (delta + q[s, a] - q_old) * e
    q[s, a] -= alpha * (q[s, a] - q_old)
    e *= gamma * lam
    return q_next


def update_returns_nothing(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    update_with_changed_q(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)


def update_corrects_all(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (delta + q_sa - q_old) * e - alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def lambda_last_weight(rewards, values, gamma, lam):
    n, g, total = len(rewards), 0, 0
    for k in range(1, n + 1):
        g = sum(gamma**i * rewards[i] for i in range(k)) + gamma**k * values[k - 1]
        total += (1 - lam) * lam ** (k - 1) * g if k < n else lam**n * g
    return total


WRONG = {
    "lambda_return": [
        (lambda_all_weights_alike, "do not sum to 1"),
        (lambda_longest, "longest return alone"),
        (lambda_one_step, "one-step return alone"),
        (lambda_starts_at_zero, "not with 0"),
        (lambda_without_values, "values are missing"),
        (lambda_without_gamma, "γ is missing"),
        (lambda_last_weight, "not λⁿ"),
        (lambda_value_one_gamma_short, "one step further off"),
    ],
    "dutch": [
        (dutch_replacing, "replacing"),
        (dutch_accumulating, "accumulating"),
        (dutch_alpha_stays, "share that is lost"),
        (dutch_forgets_the_visit, "it adds 1"),
        (dutch_brackets, "afterwards"),
        (dutch_adds_alpha, "not α"),
    ],
    "by_hand": [
        (16.5, "stopped after the first line"),
        (14.1, "not δ alone"),
        (12.5, "trace of 1"),
        (18.5, "accumulating"),
        (10.25, "before this step"),
        (17.7, "with an accumulating trace"),
    ],
    "true_online_update": [
        (update_keeps_q_old_after, "before this step. Keep it in a variable before q changes"),
        (update_without_second_term, "second correction is missing"),
        (update_as_in_lesson_05, "two terms with Q_old"),
        (update_with_replacing_traces, "set to 1"),
        (update_fades_too_soon, "faded before q was changed"),
        (update_fades_at_the_start, "left faded"),
        (update_past_the_end, "past the end"),
        (update_with_changed_q, "in the second correction"),
        (update_returns_nothing, "returns nothing"),
        (update_corrects_all, "visited pair alone"),
    ],
    "largest_alpha": [
        (0.81, "share of a trace"),
        (1 / (1 - 0.81), "how high the trace climbs"),
        (0.1, "1 − λ"),
        (1, "climbs above 1"),
        (1 / 1.81, "two visits"),
        (1 / 4.47, "nine steps"),
        (1 / 4.263, "has faded"),
    ],
}
