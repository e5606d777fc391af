"""Solutions of assignment 3, as a learner writes them."""

import numpy as np


def n_step_return(rewards, values, t, n, gamma):
    last = min(t + n, len(rewards))
    g = sum(gamma ** (k - t) * rewards[k] for k in range(t, last))
    if t + n < len(rewards):
        g += gamma**n * values[t + n]
    return g


def trace_after(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e *= decay
        e[s] = e[s] + 1 if kind == "accumulating" else 1
    return e


def td_episode(v, path, rewards, alpha, gamma, lam, kind):
    e = np.zeros(len(v))
    for t in range(len(rewards)):
        s, s_next = path[t], path[t + 1]
        v_next = v[s_next] if t + 1 < len(rewards) else 0
        delta = rewards[t] + gamma * v_next - v[s]
        e *= gamma * lam
        e[s] = e[s] + 1 if kind == "accumulating" else 1
        v += alpha * delta * e


def true_online_episode(v, path, rewards, alpha, gamma, lam):
    e, v_old = np.zeros(len(v)), 0
    for t in range(len(rewards)):
        s, s_next = path[t], path[t + 1]
        v_s, v_next = v[s], v[s_next] if t + 1 < len(rewards) else 0
        delta = rewards[t] + gamma * v_next - v_s
        e *= gamma * lam
        e[s] = (1 - alpha) * e[s] + 1
        v += alpha * (delta + v_s - v_old) * e
        v[s] -= alpha * (v_s - v_old)
        v_old = v_next


def watkins_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = 0 if terminated else max(q[s_next])
    greedy = not terminated and q[s_next, a_next] == best
    delta = r + gamma * best - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam if greedy else 0
