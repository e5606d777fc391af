"""Typical wrong answers of lesson 06, written as learners write them, and a word of the hint each must get."""


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


def dutch(e, alpha):
    return (1 - alpha) * e + 1


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


def dutch_larger(e, alpha):
    return max(e, 1)


def dutch_fades(e, alpha):
    return ((1 - alpha) * e + 1) * 0.9 * 0.9


def update_makes_a_new_table(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q = q + alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_fades_by_lambda(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= lam
    return q_next


def update_with_a_constant(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + 0.9 * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= 0.9 * lam
    return q_next


def update_without_alpha(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_greedy(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else max(q[s_next])
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_returns_delta(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return r + gamma * q_next - q_sa


def update_forgets_q_old_too_soon(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    q_old = q_next
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_old


def update_renews_every_trace(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[:] = (1 - alpha) * e + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_corrects_with_what_follows(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_next - q_old)
    e *= gamma * lam
    return q_next


def update_corrects_with_delta(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (r + gamma * q_next - q_old)
    e *= gamma * lam
    return q_next


def update_alone_at_the_end(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    if terminated:
        q[s, a] = (1 - alpha) * q[s, a] + alpha * r
        return 0
    q_sa, q_next = q[s, a], q[s_next, a_next]
    e[s, a] = dutch(e[s, a], alpha)
    q += alpha * (r + gamma * q_next - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


def update_without_brackets(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * (r + gamma * q_next - q_sa) * e + alpha * q_sa - q_old
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


WRONG = {
    "dutch": [
        (dutch_replacing, "replacing"),
        (dutch_accumulating, "accumulating"),
        (dutch_alpha_stays, "share that is lost"),
        (dutch_forgets_the_visit, "it adds 1"),
        (dutch_brackets, "afterwards"),
        (dutch_adds_alpha, "not α"),
        (dutch_larger, "larger one"),
        (dutch_fades, "not this function's job"),
    ],
    "by_hand": [
        (11.4375, "stopped after the first line"),
        (10.2125, "not δ alone"),
        (9.25, "trace of 1"),
        (11.5, "accumulating"),
        (9.578, "before this step"),
        (11.2, "with an accumulating trace"),
        (9.8125, "keeps the share α"),
        (4.9375, "change alone"),
        (6 + 0.25 * 15 * (0.6 + 0.25) - 0.5, "not added to the trace"),
        (11, "rounded too far"),
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
        (update_makes_a_new_table, "makes a new table"),
        (update_fades_by_lambda, "by λ alone"),
        (update_with_a_constant, "never looks at gamma"),
        (update_without_alpha, "α is missing in the first line"),
        (update_greedy, "best action in s'"),
        (update_returns_delta, "you return δ"),
        (update_forgets_q_old_too_soon, "need the old one"),
        (update_renews_every_trace, "all traces grow"),
        (update_corrects_with_what_follows, "not (s', a')"),
        (update_corrects_with_delta, "without δ"),
        (update_without_brackets, "brackets are missing in the first"),
        (update_alone_at_the_end, "at the end, too, every pair"),
    ],
}
