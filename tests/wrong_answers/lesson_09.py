"""Typical wrong answers of lesson 09, written as learners write them, and a word of the hint each must get."""

import inspect

import numpy as np

from rlrobot_edu.course.lesson_09 import solutions as right

bias, softmax, draw, choose = right.bias, right.softmax, right.draw, right.choose
new_temperature, true_online_update = right.new_temperature, right.true_online_update


def preferences_no_bias(q, shape, s, r_max, gamma):
    return 100 * q[s] / (r_max / (1 - gamma))


def preferences_bias_alone(q, shape, s, r_max, gamma):
    return 100 * bias(q, shape, s) / (r_max / (1 - gamma))


def preferences_not_normalised(q, shape, s, r_max, gamma):
    return bias(q, shape, s) + q[s]


def preferences_r_max(q, shape, s, r_max, gamma):
    return 100 / r_max * (bias(q, shape, s) + q[s])


def preferences_no_brackets(q, shape, s, r_max, gamma):
    return q[s] + bias(q, shape, s) * 100 / (r_max / (1 - gamma))


def choose_best(q, shape, s, temperature, r_max, gamma, u):
    return np.argmax(right.preferences(q, shape, s, r_max, gamma))


def choose_without_temperature(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(right.preferences(q, shape, s, r_max, gamma), 1), u)


def choose_without_bias(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(preferences_no_bias(q, shape, s, r_max, gamma), temperature), u)


def choose_not_normalised(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(q[s] + bias(q, shape, s), temperature), u)


def learn(env, shape, n_actions, r_max, steps, rng, alpha=0.1, gamma=0.9, lam=0.9, temperature=1.0):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0
    s = env.reset()
    a = choose(q, shape, s, temperature, r_max, gamma, rng.random())
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(q, shape, s_next, temperature, r_max, gamma, rng.random())
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            s = env.reset()
            a = choose(q, shape, s, temperature, r_max, gamma, rng.random())
    return q


def learn_and_evade(env, shape, n_actions, r_max, steps, rng, alpha=0.1, gamma=0.9, lam=0.9, default=1.0):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0
    length = max(4, min(21, len(q) // 4))
    states, rewards, temperature = [], [], default
    s = env.reset()
    a = choose(q, shape, s, temperature, r_max, gamma, rng.random())
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        states, rewards = [*states, s_next][-length:], [*rewards, r][-length:]
        if len(states) == length:
            temperature = new_temperature(temperature, states, rewards, s_next, default)
        a_next = choose(q, shape, s_next, temperature, r_max, gamma, rng.random())
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            states, rewards, temperature = [], [], default
            s = env.reset()
            a = choose(q, shape, s, temperature, r_max, gamma, rng.random())
    return q


def changed(function, old, new):
    """One of the two learners with one line changed."""
    source = inspect.getsource(function)
    assert old in source
    names = dict(globals())
    exec(source.replace(old, new), names)
    return names[function.__name__]


ANEW = "choose(q, shape, s_next, temperature, r_max, gamma, rng.random())"
FIRST = "            a = choose(q, shape, s, temperature, r_max, gamma, rng.random())\n"  # of a new episode
RENEWED = "states, rewards, temperature = [], [], default"


def p_value_smaller(observed, shuffled):
    return sum(f < observed for f in shuffled) / len(shuffled)


def p_value_larger(observed, shuffled):
    return sum(f > observed for f in shuffled) / len(shuffled)


def p_value_count(observed, shuffled):
    return len([f for f in shuffled if f >= observed])


def p_value_per_cent(observed, shuffled):
    return 100 * sum(f >= observed for f in shuffled) / len(shuffled)


def p_value_other_side(observed, shuffled):
    return sum(f <= observed for f in shuffled) / len(shuffled)


WRONG = {
    "preferences": [
        (preferences_no_bias, "bias is missing"),
        (preferences_bias_alone, "bias alone"),
        (preferences_not_normalised, "still has to be normalised"),
        (preferences_r_max, "not Rmax"),
        (preferences_no_brackets, "brackets"),
    ],
    "choose": [
        (choose_best, "not always taken"),
        (choose_without_temperature, "temperature plays no part"),
        (choose_without_bias, "does not know the bias"),
        (choose_not_normalised, "not normalised"),
    ],
    "learn": [
        (changed(learn, "e[:], q_old = 0.0, 0.0", "pass"), "start afresh"),
        (changed(learn, "e[:], q_old = 0.0, 0.0", "q_old = 0.0"), "e is 0"),
        (changed(learn, FIRST, ""), "stands elsewhere"),
        (changed(learn, "q_old = true_online_update", "true_online_update"), "keep it"),
        (changed(learn, "if terminated or truncated:", "if terminated:"), "reset the world"),
        (changed(learn, "s, a = s_next, a_next", "s, a = s_next, " + ANEW), "taken next"),
        (changed(learn, "choose(q,", "choose_without_bias(q,"), "without the bias"),
    ],
    "learn_and_evade": [
        (learn, "without loop evasion"),
        (changed(learn_and_evade, "            " + RENEWED, "            pass"), "queue starts afresh"),
        (changed(learn_and_evade, "max(4, min(21, len(q) // 4))", "21"), "at most a quarter"),
        (changed(learn_and_evade, "if len(states) == length:", "if states:"), "not full yet"),
        (changed(learn_and_evade, "[*states, s_next]", "[*states, s]"), "led to"),
    ],
    "p_value": [
        (p_value_smaller, "is smaller"),
        (p_value_larger, "equal the observed"),
        (p_value_count, "how many they are"),
        (p_value_other_side, "at most as large"),
        (p_value_per_cent, "between 0 and 1"),
    ],
}
