"""Solutions of lesson 09. The functions of the lessons before are taken from there, as a learner takes them."""

import numpy as np

from rlrobot_edu.course.lesson_03.solutions import draw, softmax
from rlrobot_edu.course.lesson_06.solutions import true_online_update
from rlrobot_edu.course.lesson_07.solutions import bias
from rlrobot_edu.course.lesson_08.solutions import new_temperature


def preferences(q, shape, s, r_max, gamma):
    q_max = r_max / (1 - gamma)
    return (q[s] + bias(q, shape, s)) * 100 / q_max


def choose(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)


def learn(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0

    def act(s):
        return choose(q, shape, s, temperature, r_max, gamma, rng.random())

    s = env.reset()
    a = act(s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = act(s_next)
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            s = env.reset()
            a = act(s)
    return q


def learn_and_evade(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, default):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0
    length = max(4, min(21, len(q) // 4))
    states, rewards, temperature = [], [], default

    def act(s):
        return choose(q, shape, s, temperature, r_max, gamma, rng.random())

    s = env.reset()
    a = act(s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        states, rewards = [*states, s_next][-length:], [*rewards, r][-length:]
        if len(states) == length:
            temperature = new_temperature(temperature, states, rewards, s_next, default)
        a_next = act(s_next)
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            states, rewards, temperature = [], [], default
            s = env.reset()
            a = act(s)
    return q
