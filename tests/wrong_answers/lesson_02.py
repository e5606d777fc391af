"""Typical wrong answers of lesson 02, written as learners write them, and a word of the hint each must get."""

import numpy as np


def target_past_the_end(q, r, s_next, terminated, gamma):
    return r + gamma * np.max(q[s_next])


def target_without_gamma(q, r, s_next, terminated, gamma):
    return r if terminated else r + max(q[s_next])


def target_argmax(q, r, s_next, terminated, gamma):
    return r + gamma * np.argmax(q[s_next]) * (not terminated)


def target_action_0(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * q[s_next][0]


def target_no_return(q, r, s_next, terminated, gamma):
    r + gamma * max(q[s_next])


def update_past_the_end(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = (1 - alpha) * q[s, a] + alpha * (r + gamma * max(q[s_next]))


def update_without_gamma(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + max(q[s_next]) * (1 - terminated) - q[s, a])


def update_adds_target(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * max(q[s_next]) * (1 - terminated))


def update_replaces(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = alpha * (r + gamma * max(q[s_next]) * (1 - terminated) - q[s, a])


def update_row(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, :] += alpha * (r + gamma * max(q[s_next]) * (1 - terminated) - q[s, :])


def update_old_action(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * q[s_next, a] * (1 - terminated) - q[s, a])


def update_returns_it(q, s, a, r, s_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * np.max(q[s_next])
    return (1 - alpha) * q[s, a] + alpha * target


def learn_never_resets(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, _ = env.step(a)
        update(q, s, a, r, s2, terminated)
        s = s2


def learn_stays(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        if terminated or truncated:
            s = env.reset()


def learn_truncated(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        done = terminated or truncated
        update(q, s, a, r, s2, done)
        s = env.reset() if done else s2


def learn_breaks(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        if terminated or truncated:
            return
        s = s2


def learn_only_between(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        if terminated or truncated:
            s = env.reset()
            continue
        update(q, s, a, r, s2, terminated)
        s = s2


WRONG = {
    "by_hand": [
        (14.5, "a tenth of the way"),
        (5.1, "forgot γ"),
        (5.45, "minus the old"),
        (10.5, "TD error"),
        (4.933, "not 3.7"),
    ],
    "look_ahead": [
        (0.5, "every step"),
        (0.05, "multiplies"),
        (0.95, "takes 0.05 off"),
        (1 / 1024, "tenth root"),
        (0.93, "three digits"),
    ],
    "target": [
        (target_past_the_end, "past the end"),
        (target_without_gamma, "forgot γ"),
        (target_argmax, "argmax"),
        (target_action_0, "action 0"),
        (target_no_return, "returns nothing"),
    ],
    "update": [
        (update_past_the_end, "past the end"),
        (update_without_gamma, "forgot γ"),
        (update_adds_target, "not taken off"),
        (update_replaces, "+= instead of ="),
        (update_row, "whole row"),
        (update_old_action, "old action"),
        (update_returns_it, "to return it"),
    ],
    "learn": [
        (learn_never_resets, "must be reset"),
        (learn_stays, "s = s_next"),
        (learn_truncated, "time is up"),
        (learn_breaks, "until all steps are done"),
        (learn_only_between, "update first, then reset"),
    ],
}
