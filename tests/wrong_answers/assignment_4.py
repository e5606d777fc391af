"""Typical wrong answers of assignment 4, written as learners write them, and a word of the hint each must get."""

import numpy as np

from rlrobot_edu.course.assignment_4.given import draw
from rlrobot_edu.course.assignment_4.solutions import bias_table, next_temperature, period


def near(s, shape, is_circle, steps=(-1, 1), inputs=None, itself=False):
    found = {s} if itself else set()
    for i in range(len(shape)) if inputs is None else inputs(shape):
        for step in steps:
            bins = list(np.unravel_index(s, shape))
            bins[i] = (bins[i] + step) % shape[i] if is_circle[i] else bins[i] + step
            if 0 <= bins[i] < shape[i] and (itself or tuple(bins) != tuple(np.unravel_index(s, shape))):
                found.add(int(np.ravel_multi_index(bins, shape)))
    return sorted(found)


def near_on_lines(s, shape, is_circle):
    return near(s, shape, [False] * len(shape))


def near_on_circles(s, shape, is_circle):
    return near(s, shape, [True] * len(shape))


def near_itself(s, shape, is_circle):
    return near(s, shape, is_circle, itself=True)


def near_and_far(s, shape, is_circle):
    return near(s, shape, is_circle, steps=range(-9, 10))


def near_above(s, shape, is_circle):
    return near(s, shape, is_circle, steps=(1,))


def bias_summed(q, shape):
    return len(shape) * bias_table(q, shape)


def bias_of_all(q, shape):
    return np.ones_like(q) * q.mean(axis=0)


def bias_and_q(q, shape):
    return q + bias_table(q, shape)


def bias_of_the_first(q, shape):
    table = q.reshape(*shape, -1)
    return (table.mean(axis=0, keepdims=True) + np.zeros(table.shape)).reshape(q.shape)


def bias_of_the_others(q, shape):
    table = q.reshape(*shape, -1)
    inputs = range(len(shape))
    parts = [table.mean(axis=tuple({*inputs} - {i}), keepdims=True) + np.zeros(table.shape) for i in inputs]
    return np.mean(parts, axis=0).reshape(q.shape)


def period_longest(states):
    found = [p for p in range(1, len(states) // 2 + 1) if states[-p:] == states[-2 * p : -p]]
    return max(found, default=0)


def period_of_the_oldest(states):
    return next((p for p in range(1, len(states) // 2 + 1) if states[:p] == states[p : 2 * p]), 0)


def period_of_one_state(states):
    return next((p for p in range(1, len(states) // 2 + 1) if states[-1 - p] == states[-1]), 0)


def period_too_short(states):
    return next((p for p in range(1, len(states) // 2) if states[-p:] == states[-2 * p : -p]), 0)


def period_in_any_order(states):
    return next((p for p in range(1, len(states) // 2 + 1) if sorted(states[-p:]) == sorted(states[-2 * p : -p])), 0)


def hot_in_any_circle(temperature, states, rewards, default):
    p = period(states)
    return min(50, temperature + len(states) / (4 * p)) if p else default


def hot_by_all_rewards(temperature, states, rewards, default):
    p = period(states)
    return min(50, temperature + len(states) / (4 * p)) if p and sum(rewards) < 0 else default


def hot_without_end(temperature, states, rewards, default):
    p = period(states)
    return temperature + len(states) / (4 * p) if p and sum(rewards[-p:]) < 0 else default


def hot_for_ever(temperature, states, rewards, default):
    p = period(states)
    return min(50, temperature + len(states) / (4 * p)) if p and sum(rewards[-p:]) < 0 else temperature


def hot_by_brackets(temperature, states, rewards, default):
    p = period(states)
    return min(50, temperature + len(states) / 4 * p) if p and sum(rewards[-p:]) < 0 else default


def driven(env, q, shape, us, alpha, gamma, scale, default, biased=True, past=False, heats=True, clears=True, keeps=8):
    earned, heat, states, rewards, temperature, s = [], [], [], [], default, env.reset()
    for u in us:
        x = q[s] + bias_table(q, shape)[s] if biased else q[s]
        a = draw(scale * x, temperature, u)
        s_next, r, terminated, truncated = env.step(a)
        follows = gamma * max(q[s_next]) if past or not terminated else 0
        q[s, a] += alpha * (r + follows - q[s, a])
        earned.append(r)
        heat.append(temperature)
        states, rewards = [*states, s_next][-keeps:], [*rewards, r][-keeps:]
        if heats:
            temperature = next_temperature(temperature, states, rewards, default)
        s = s_next
        if terminated or truncated:
            s = env.reset()
            if clears:
                states, rewards, temperature = [], [], default
    return earned, heat


def drive_without_advice(env, q, shape, us, alpha, gamma, scale, default):
    return driven(env, q, shape, us, alpha, gamma, scale, default, biased=False)


def drive_past_the_end(env, q, shape, us, alpha, gamma, scale, default):
    return driven(env, q, shape, us, alpha, gamma, scale, default, past=True)


def drive_cool(env, q, shape, us, alpha, gamma, scale, default):
    return driven(env, q, shape, us, alpha, gamma, scale, default, heats=False)


def drive_remembers(env, q, shape, us, alpha, gamma, scale, default):
    return driven(env, q, shape, us, alpha, gamma, scale, default, clears=False)


def drive_never_forgets(env, q, shape, us, alpha, gamma, scale, default):
    return driven(env, q, shape, us, alpha, gamma, scale, default, keeps=1000)


WRONG = {
    "near_states": [
        (near_on_lines, "circle has no ends"),
        (near_on_circles, "only an input that is a circle"),
        (near_itself, "not beside itself"),
        (near_and_far, "single bin only"),
        (near_above, "beside a bin lie two"),
    ],
    "bias_table": [
        (bias_summed, "sum over the inputs"),
        (bias_of_all, "mean of all states"),
        (bias_and_q, "Q itself is added"),
        (bias_of_the_first, "only the first input"),
        (bias_of_the_others, "Only input i"),
    ],
    "period": [
        (period_longest, "longest"),
        (period_of_the_oldest, "newest"),
        (period_of_one_state, "not yet a circle"),
        (period_too_short, "half the list's length"),
        (period_in_any_order, "order"),
    ],
    "next_temperature": [
        (hot_in_any_circle, "no trap"),
        (hot_by_all_rewards, "last round"),
        (hot_without_end, "hotter than 50"),
        (hot_for_ever, "back to default"),
        (hot_by_brackets, "brackets"),
    ],
    "drive": [
        (drive_without_advice, "bias plays no part"),
        (drive_past_the_end, "past the end"),
        (drive_cool, "never changes"),
        (drive_remembers, "stands elsewhere"),
        (drive_never_forgets, "too long"),
    ],
}
