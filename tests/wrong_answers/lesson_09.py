"""Typical wrong answers of lesson 09, written as learners write them, and a word of the hint each must get."""

import inspect

import numpy as np
from solutions import lesson_09 as right

bias, softmax, draw = right.bias, right.softmax, right.draw


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


def changed(function, old, new):
    """The right answer with one line changed, as a slip would change it."""
    source = inspect.getsource(function)
    assert old in source
    names = {**vars(right), "choose_without_bias": choose_without_bias}
    exec(source.replace(old, new), names)
    return names[function.__name__]


LEARN, EVADE = right.learn, right.learn_and_evade
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
        (changed(LEARN, "e[:], q_old = 0.0, 0.0", "pass"), "start afresh"),
        (changed(LEARN, "e[:], q_old = 0.0, 0.0", "q_old = 0.0"), "e is 0"),
        (changed(LEARN, FIRST, ""), "stands elsewhere"),
        (changed(LEARN, "q_old = true_online_update", "true_online_update"), "keep it"),
        (changed(LEARN, "if terminated or truncated:", "if terminated:"), "reset the world"),
        (changed(LEARN, "s, a = s_next, a_next", "s, a = s_next, " + ANEW), "taken next"),
        (changed(LEARN, "choose(q,", "choose_without_bias(q,"), "without the bias"),
    ],
    "learn_and_evade": [
        (LEARN, "without loop evasion"),
        (changed(EVADE, "            " + RENEWED, "            pass"), "queue starts afresh"),
        (changed(EVADE, "max(4, min(21, len(q) // 4))", "21"), "at most a quarter"),
        (changed(EVADE, "if len(states) == length:", "if states:"), "not full yet"),
        (changed(EVADE, "[*states, s_next]", "[*states, s]"), "led to"),
    ],
    "p_value": [
        (p_value_smaller, "is smaller"),
        (p_value_larger, "equal the observed"),
        (p_value_count, "how many they are"),
        (p_value_other_side, "at most as large"),
        (p_value_per_cent, "between 0 and 1"),
    ],
}
