"""Typical wrong answers of assignment 3, written as learners write them, and a word of the hint each must get."""

import numpy as np

from rlrobot_edu.course.assignment_3.solutions import trace_after


def n_steps_past_the_end(rewards, values, t, n, gamma):
    g = 0
    for k, r in enumerate(rewards[t : t + n]):
        g += gamma**k * r
    return g + gamma**n * values[min(t + n, len(values) - 1)]


def n_steps_without_a_value(rewards, values, t, n, gamma):
    return sum(gamma**k * r for k, r in enumerate(rewards[t : t + n]))


def n_steps_exactly(rewards, values, t, n, gamma):
    g = sum(gamma**k * r for k, r in enumerate(rewards[t : t + n]))
    return g + gamma**n * values[t + n] if t + n < len(values) else g


def n_steps_value_in_full(rewards, values, t, n, gamma):
    g = sum(gamma**k * r for k, r in enumerate(rewards[t : t + n]))
    return g + values[t + n] if t + n < len(rewards) else g


def n_steps_from_the_start(rewards, values, t, n, gamma):
    g = sum(gamma**k * rewards[k] for k in range(t, min(t + n, len(rewards))))
    return g + gamma**n * values[t + n] if t + n < len(rewards) else g


def traces_fade_late(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        if kind == "replacing":
            e[s] = 1
        else:
            e[s] += 1
        e = e * decay
    return e


def traces_accumulate(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e = e * decay
        e[s] += 1
    return e


def traces_replace(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e = e * decay
        e[s] = 1
    return e


def traces_count(path, n_states, decay, kind):
    return np.array([path.count(s) for s in range(n_states)], dtype=float)


def traces_fade_alone(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e[s] = decay * e[s] + 1 if kind == "accumulating" else 1
    return e


def episode_with(v, path, rewards, alpha, gamma, lam, kind, past_the_end=False, fading=None, alone=False):
    for t, r in enumerate(rewards):
        e = trace_after(path[: t + 1], len(v), gamma * lam if fading is None else fading(gamma, lam), kind)
        follows = v[path[t + 1]] if past_the_end or t + 1 < len(rewards) else 0
        delta = r + gamma * follows - v[path[t]]
        if alone:
            v[path[t]] += alpha * delta
        else:
            v += alpha * delta * e


def episode_past_the_end(v, path, rewards, alpha, gamma, lam, kind):
    episode_with(v, path, rewards, alpha, gamma, lam, kind, past_the_end=True)


def episode_fades_by_lambda(v, path, rewards, alpha, gamma, lam, kind):
    episode_with(v, path, rewards, alpha, gamma, lam, kind, fading=lambda gamma, lam: lam)


def episode_does_not_fade(v, path, rewards, alpha, gamma, lam, kind):
    episode_with(v, path, rewards, alpha, gamma, lam, kind, fading=lambda gamma, lam: 1.0)


def episode_of_one_state(v, path, rewards, alpha, gamma, lam, kind):
    episode_with(v, path, rewards, alpha, gamma, lam, kind, alone=True)


def episode_accumulates(v, path, rewards, alpha, gamma, lam, kind):
    episode_with(v, path, rewards, alpha, gamma, lam, "accumulating")


def online(v, path, rewards, alpha, gamma, lam, visit=None, second=1.0, first=True, old="next"):
    e, v_old = np.zeros(len(v)), 0.0
    for t, r in enumerate(rewards):
        s = path[t]
        v_s, v_next = v[s], v[path[t + 1]] if t + 1 < len(rewards) else 0.0
        e *= gamma * lam
        e[s] = visit(e[s]) if visit else e[s] * (1 - alpha) + 1
        v += alpha * (r + gamma * v_next - (v_old if first else v_s)) * e
        v[s] -= second * alpha * (v_s - v_old)
        v_old = v_next if old == "next" else v[path[t + 1]] if old == "late" else 0.0


def online_accumulating(v, path, rewards, alpha, gamma, lam):
    online(v, path, rewards, alpha, gamma, lam, visit=lambda e: e + 1)


def online_replacing(v, path, rewards, alpha, gamma, lam):
    online(v, path, rewards, alpha, gamma, lam, visit=lambda e: 1)


def online_without_second(v, path, rewards, alpha, gamma, lam):
    online(v, path, rewards, alpha, gamma, lam, second=0.0)


def online_without_first(v, path, rewards, alpha, gamma, lam):
    online(v, path, rewards, alpha, gamma, lam, first=False)


def online_forgets(v, path, rewards, alpha, gamma, lam):
    online(v, path, rewards, alpha, gamma, lam, old="never")


def watkins_never_cuts(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = 0 if terminated else q[s_next].max()
    delta = r + gamma * best - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= 0 if terminated else gamma * lam


def watkins_keeps_at_ends(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = 0 if terminated else q[s_next].max()
    explores = not terminated and q[s_next, a_next] < best
    delta = r + gamma * best - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= 0 if explores else gamma * lam


def watkins_by_argmax(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = q[s_next].argmax()
    delta = r + (0 if terminated else gamma * q[s_next, best]) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    if a_next != best or terminated:
        e[:] = 0
    e *= gamma * lam


def watkins_asks_late(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r + (0 if terminated else gamma * q[s_next].max()) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    if q[s_next, a_next] != q[s_next].max() or terminated:
        e[:] = 0
    e *= gamma * lam


def watkins_like_sarsa(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    greedy = not terminated and q[s_next, a_next] == q[s_next].max()
    delta = r + (0 if terminated else gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam * greedy


def watkins_accumulates(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e[s, a] = e[s, a] + 1
    greedy = not terminated and q[s_next, a_next] == q[s_next].max()
    q += alpha * (r + (0 if terminated else gamma * q[s_next].max()) - q[s, a]) * e
    e *= gamma * lam * greedy


WRONG = {
    "n_step_return": [
        (n_steps_past_the_end, "has an end"),
        (n_steps_without_a_value, "value at step t + n is missing"),
        (n_steps_exactly, "exactly"),
        (n_steps_value_in_full, "yours counts in full"),
        (n_steps_from_the_start, "count the power from t on"),
    ],
    "trace_after": [
        (traces_fade_late, "after the last visit"),
        (traces_accumulate, "both kinds accumulate"),
        (traces_replace, "both kinds replace"),
        (traces_count, "visits are counted"),
        (traces_fade_alone, "only the visited trace fades"),
    ],
    "td_episode": [
        (episode_past_the_end, "past the end"),
        (episode_fades_by_lambda, "by γ · λ"),
        (episode_does_not_fade, "do not fade"),
        (episode_of_one_state, "only the state of this step"),
        (episode_accumulates, "both kinds accumulate"),
    ],
    "true_online_episode": [
        (online_accumulating, "accumulating trace"),
        (online_replacing, "replacing trace"),
        (online_without_second, "second line is missing"),
        (online_without_first, "not δ alone"),
        (online_forgets, "handed on"),
    ],
    "watkins_update": [
        (watkins_never_cuts, "never cut"),
        (watkins_keeps_at_ends, "after a terminated step"),
        (watkins_by_argmax, "argmax"),
        (watkins_asks_late, "before the update"),
        (watkins_like_sarsa, "SARSA's target"),
        (watkins_accumulates, "accumulating trace"),
    ],
}
