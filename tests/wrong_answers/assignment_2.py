"""Typical wrong answers of assignment 2, written as learners write them, and a word of the hint each must get."""

import math

import numpy as np

from rlrobot_edu.course.assignment_2.solutions import double_update


def epsilon_to_nothing(t, start, end, half_life):
    return start / 2 ** (t / half_life)


def epsilon_too_high(t, start, end, half_life):
    return start / 2 ** (t / half_life) + end


def epsilon_by_e(t, start, end, half_life):
    return end + (start - end) * math.exp(-t / half_life)


def epsilon_in_steps(t, start, end, half_life):
    gap = start - end
    for _ in range(t // half_life):
        gap /= 2
    return end + gap


def epsilon_each_step(t, start, end, half_life):
    return end + (start - end) / 2**t


def value_overflows(q_s, temperature):
    p = np.exp(q_s / temperature)
    return p @ q_s / p.sum()


def value_of_the_best(q_s, temperature):
    return max(q_s)


def value_without_weights(q_s, temperature):
    return np.mean(q_s)


def value_times_temperature(q_s, temperature):
    p = np.exp(temperature * (q_s - max(q_s)))
    return p @ q_s / p.sum()


def value_not_divided(q_s, temperature):
    p = np.exp((q_s - max(q_s)) / temperature)
    return (p * q_s).sum()


def double_in_one(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    q = q1 if heads else q2
    q[s, a] += alpha * (r + (0 if terminated else gamma * q[s_next].max()) - q[s, a])


def double_swapped(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    q, other = (q1, q2) if heads else (q2, q1)
    follows = 0 if terminated else q[s_next, np.argmax(other[s_next])]
    q[s, a] += alpha * (r + gamma * follows - q[s, a])


def double_other_max(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    q, other = (q1, q2) if heads else (q2, q1)
    q[s, a] += alpha * (r + (0 if terminated else gamma * max(other[s_next])) - q[s, a])


def double_past_the_end(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    q, other = (q1, q2) if heads else (q2, q1)
    q[s, a] += alpha * (r + gamma * other[s_next, q[s_next].argmax()] - q[s, a])


def double_tails(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    double_update(q2, q1, s, a, r, s_next, terminated, heads, alpha, gamma)


def learn_by_one(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s = env.reset()
        while True:
            a = choose(q1, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s = s_next
            if terminated or truncated:
                break


def learn_without_a_coin(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s = env.reset()
        while True:
            a = choose(q1 + q2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss, alpha, gamma)
            s = s_next
            if terminated or truncated:
                break


def learn_one_toss(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, coin = env.reset(), toss()
        while True:
            a = choose(q1 + q2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, coin, alpha, gamma)
            s = s_next
            if terminated or truncated:
                break


def learn_stands_still(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s = env.reset()
        while True:
            a = choose(q1 + q2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            if terminated or truncated:
                break


def learn_too_long(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, terminated = env.reset(), False
        while not terminated:
            a = choose(q1 + q2, s)
            s_next, r, terminated, _ = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s = s_next


WRONG = {
    "epsilon_at": [
        (epsilon_to_nothing, "goes to 0"),
        (epsilon_too_high, "must be start"),
        (epsilon_by_e, "37 %"),
        (epsilon_in_steps, "whole half-lives"),
        (epsilon_each_step, "in each step"),
    ],
    "policy_value": [
        (value_overflows, "too large for a computer"),
        (value_of_the_best, "best action is worth"),
        (value_without_weights, "plain mean"),
        (value_times_temperature, "divides the values"),
        (value_not_divided, "sum to 1"),
    ],
    "who": [
        ([1, 2, 1, 0], "A went to 2.35"),
        ([3, 1, 1, 0], "B stayed"),
        ([3, 2, 3, 0], "C went to 2.5"),
        ([3, 2, 1, 1], "D's step"),
        ([1, 1, 1, 1], "only to show"),
    ],
    "double_update": [
        (double_in_one, "Q-learning in one table"),
        (double_swapped, "changed places"),
        (double_other_max, "picks and judges"),
        (double_past_the_end, "past the end"),
        (double_tails, "wrong way round"),
    ],
    "double_learn": [
        (learn_by_one, "only q1 chooses"),
        (learn_without_a_coin, "always falls the same way"),
        (learn_one_toss, "whole episode"),
        (learn_stands_still, "go on from s_next"),
        (learn_too_long, "truncated, too"),
    ],
}
