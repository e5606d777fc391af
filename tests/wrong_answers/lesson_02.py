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


def target_inverted(q, r, s_next, terminated, gamma):
    return r + gamma * max(q[s_next]) if terminated else r


def target_column(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * q[:, s_next].max()


def target_sum(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * sum(q[s_next])


def target_not_below_zero(q, r, s_next, terminated, gamma):
    best = 0
    for value in q[s_next]:
        best = max(best, value)
    return r + gamma * best * (1 - terminated)


def target_own_gamma(q, r, s_next, terminated, gamma):
    return r + (0 if terminated else 0.9 * np.max(q[s_next]))


def target_spoils(q, r, s_next, terminated, gamma):
    row = q[s_next]
    row *= gamma
    return r if terminated else r + row.max()


def update_downwards(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] -= alpha * (r + gamma * max(q[s_next]) * (1 - terminated) - q[s, a])


def update_own_alpha(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += 0.1 * (r + gamma * max(q[s_next]) * (1 - terminated) - q[s, a])


def update_whole_row_alike(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s] += alpha * (r + gamma * max(q[s_next]) * (1 - terminated) - q[s, a])


def learn_does_not_take_the_reset_state(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        if terminated or truncated:
            env.reset()
        s = s2


def learn_takes_the_best(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = int(np.argmax(q[s]))
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        s = env.reset() if terminated or truncated else s2


def update_in_two_lines(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = (1 - alpha) * q[s, a]
    q[s, a] += alpha * (r if terminated else r + gamma * max(q[s_next]))


def learn_chooses_too_early(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, terminated, truncated = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, terminated)
        s, a = (s2, a2) if not (terminated or truncated) else ((new := env.reset()), choose(q, new))


def learn_five_values(env, q, choose, update, steps):
    _s, _info = env.reset()


def learn_chooses_the_wrong_way_round(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        env.step(choose(s, q))


WRONG = {
    "by_hand": [
        (15.4, "a fifth of the way"),
        (6.4, "forgot γ"),
        (7.08, "minus the old"),
        (11.4, "TD error"),
        (5.866, "not 3.7"),
        (6.3, "rounded too far"),
        (6.08, "counts in full"),
        ("6.28", "quotation marks"),
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
        (target_inverted, "wrong way round"),
        (target_column, "is a column"),
        (target_sum, "not sum"),
        (target_not_below_zero, "may be negative"),
        (target_own_gamma, "in place of the number"),
        (target_spoils, "work on a copy"),
    ],
    "update": [
        (update_past_the_end, "past the end"),
        (update_without_gamma, "forgot γ"),
        (update_adds_target, "not taken off"),
        (update_replaces, "+= instead of ="),
        (update_row, "whole row"),
        (update_old_action, "old action"),
        (update_returns_it, "to return it"),
        (update_downwards, "away from the target"),
        (update_own_alpha, "in place of the number"),
        (update_whole_row_alike, "whole row"),
        (update_in_two_lines, "has changed before"),
    ],
    "learn": [
        (learn_never_resets, "must be reset"),
        (learn_stays, "s = s_next"),
        (learn_truncated, "time is up"),
        (learn_breaks, "until all steps are done"),
        (learn_only_between, "update first, then reset"),
        (learn_does_not_take_the_reset_state, "not what reset returned"),
        (learn_takes_the_best, "for choose to say"),
        (learn_chooses_too_early, "chosen before the update"),
        (learn_five_values, "to the right one int"),
        (learn_chooses_the_wrong_way_round, "in this order"),
    ],
}
