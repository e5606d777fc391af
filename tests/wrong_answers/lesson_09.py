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


def preferences_no_hundred(q, shape, s, r_max, gamma):
    return (q[s] + bias(q, shape, s)) / (r_max / (1 - gamma))


def preferences_precedence(q, shape, s, r_max, gamma):
    return (q[s] + bias(q, shape, s)) * 100 / r_max / (1 - gamma)


def preferences_in_place(q, shape, s, r_max, gamma):
    x = q[s]
    x += bias(q, shape, s)
    return x * 100 * (1 - gamma) / r_max


def preferences_of_09(q, shape, s, r_max, gamma):
    return (q[s] + bias(q, shape, s)) * 100 * (1 - 0.9) / r_max


def preferences_of_the_table(q, shape, s, r_max, gamma):
    return (q + bias(q, shape, s)) * 100 * (1 - gamma) / r_max


def preferences_half_the_bias(q, shape, s, r_max, gamma):
    return (q[s] + bias(q, shape, s) / 2) * 100 * (1 - gamma) / r_max


def preferences_divide_again(q, shape, s, r_max, gamma):
    return (q[s] + bias(q, shape, s) / len(shape)) * 100 * (1 - gamma) / r_max


def choose_of_preferences(q, shape, s, temperature, r_max, gamma, u):
    return draw(right.preferences(q, shape, s, r_max, gamma), u)


def choose_best(q, shape, s, temperature, r_max, gamma, u):
    return np.argmax(right.preferences(q, shape, s, r_max, gamma))


def choose_without_temperature(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(right.preferences(q, shape, s, r_max, gamma), 1), u)


def choose_without_bias(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(preferences_no_bias(q, shape, s, r_max, gamma), temperature), u)


def choose_not_normalised(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(q[s] + bias(q, shape, s), temperature), u)


def choose_exchanged(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(right.preferences(q, shape, s, r_max, gamma), u), temperature)


def choose_bias_twice(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(right.preferences(q, shape, s, r_max, gamma) + bias(q, shape, s), temperature), u)


def choose_probabilities(q, shape, s, temperature, r_max, gamma, u):
    return softmax(right.preferences(q, shape, s, r_max, gamma), temperature)


def choose_of_shares(q, shape, s, temperature, r_max, gamma, u):
    x = right.preferences(q, shape, s, r_max, gamma) / temperature
    return draw(x / x.sum(), u)


def learn(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature):
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


def learn_and_evade(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, default):
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
UPDATE = "q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)"
SARSA = "q[s, a] += alpha * (r + gamma * (not terminated) * q[s_next, a_next] - q[s, a])"
ON = "s, a = s_next, a_next"
RENEWED = "states, rewards, temperature = [], [], default"


WRONG = {
    "preferences": [
        (preferences_no_bias, "bias is missing"),
        (preferences_bias_alone, "bias alone"),
        (preferences_not_normalised, "still has to be normalised"),
        (preferences_r_max, "not Rmax"),
        (preferences_no_brackets, "brackets"),
        (preferences_no_hundred, "factor 100"),
        (preferences_precedence, "divided by"),
        (preferences_in_place, "copy"),
        (preferences_of_09, "gamma"),
        (preferences_of_the_table, "whole table"),
        (preferences_half_the_bias, "in full"),
        (preferences_divide_again, "done its division"),
    ],
    "choose": [
        (choose_best, "not always taken"),
        (choose_without_temperature, "temperature plays no part"),
        (choose_without_bias, "does not know the bias"),
        (choose_not_normalised, "not normalised"),
        (choose_of_preferences, "softmax is missing"),
        (choose_exchanged, "changed places"),
        (choose_bias_twice, "once more"),
        (choose_probabilities, "Which action"),
        (choose_of_shares, "no probabilities"),
    ],
    "learn": [
        (changed(learn, "e[:], q_old = 0.0, 0.0", "pass"), "start afresh"),
        (changed(learn, "e[:], q_old = 0.0, 0.0", "q_old = 0.0"), "e is 0"),
        (changed(learn, FIRST, ""), "stands elsewhere"),
        (changed(learn, "q_old = true_online_update", "true_online_update"), "keep it"),
        (changed(learn, "if terminated or truncated:", "if terminated:"), "in two ways"),
        (changed(learn, "s, a = s_next, a_next", "s, a = s_next, " + ANEW), "taken next"),
        (changed(learn, "choose(q,", "choose_without_bias(q,"), "without the bias"),
        (changed(learn, "a_next, terminated, alpha", "a_next, terminated or truncated, alpha"), "run out of time"),
        (changed(learn, "a_next, terminated, alpha", "a_next, False, alpha"), "must be told"),
        (changed(learn, "            s = env.reset()\n", ""), "itself must be reset"),
        (changed(learn, "            s = env.reset()\n", "            env.reset()\n"), "tells the first state"),
        (changed(learn, UPDATE, SARSA), "this is SARSA"),
        (changed(learn, UPDATE, SARSA.replace("s_next, a_next]", "s_next].max()")), "this is Q-learning"),
        (changed(learn, ON, ON + "\n        e[:] = 0"), "only where an episode has ended"),
        (changed(learn, ON, "a = a_next"), "becomes s"),
        (changed(learn, UPDATE, ON + "\n        " + UPDATE), "overwritten"),
        (changed(learn, "a_next = " + ANEW, "a_next = " + ANEW.replace("s_next", "s")), "not in s"),
        (changed(learn, "alpha, gamma, lam)", "gamma, alpha, lam)"), "changed places"),
        (changed(learn, "alpha, gamma, lam)", "0.1, gamma, lam)"), "never looks at alpha"),
        (changed(learn, "rng.random()", "np.random.random()"), "never looks at rng"),
        (changed(learn, "range(steps)", "range(steps + 1)"), "too many"),
        (changed(learn, "e[:], q_old = 0.0, 0.0", "e[:], q_old, q[:] = 0, 0, 0"), "must stay"),
        (changed(learn, "np.prod(shape), n_actions", "np.prod(shape), 3"), "not always 3"),
        (changed(learn, "a_next, terminated, alpha", "a_next, truncated, alpha"), "not truncated"),
        (changed(learn, ON, ON + "\n        return q"), "inside the loop"),
        (changed(learn, ON, "s, a = env.reset(), a_next"), "after every step"),
        (changed(learn, "temperature, r_max", "temperature, 10"), "not always 10"),
        (changed(learn, "e, q_old = np.zeros_like(q), 0.0", "e, q_old = q, 0.0"), "under two names"),
        (changed(learn, "np.zeros_like(q)", "np.ones_like(q)"), "traces start at 0"),
        (changed(learn, ON, ON + "\n        q_old = 0.0"), "until the episode has ended"),
    ],
    "learn_and_evade": [
        (learn, "without loop evasion"),
        (changed(learn_and_evade, "np.prod(shape), n_actions", "np.prod(shape), 3"), "not always 3"),
        (changed(learn_and_evade, "temperature, r_max", "temperature, 10"), "not always 10"),
        (changed(learn_and_evade, "            " + RENEWED, "            pass"), "queue starts afresh"),
        (changed(learn_and_evade, "max(4, min(21, len(q) // 4))", "21"), "at most a quarter"),
        (changed(learn_and_evade, "if len(states) == length:", "if states:"), "not full yet"),
        (changed(learn_and_evade, "[*states, s_next]", "[*states, s]"), "led to"),
        (changed(learn_and_evade, "[-length:]", ""), "without end"),
        (changed(learn_and_evade, "new_temperature(temperature,", "new_temperature(default,"), "where it is"),
        (changed(learn_and_evade, "a_next, terminated, alpha", "a_next, terminated or truncated, alpha"), "run out"),
        (changed(learn_and_evade, "            s = env.reset()\n", ""), "itself must be reset"),
    ],
}
