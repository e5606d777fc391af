"""Further wrong answers of lesson 03: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it
# ruff: noqa: F821

import numpy as np


def greedy_one_best_by_list_index(q_s, epsilon):
    p = [epsilon / len(q_s)] * len(q_s)
    p[q_s.index(max(q_s))] += 1 - epsilon
    return p


def greedy_values_not_marks(q_s, epsilon):
    best = q_s[q_s == q_s.max()]
    return epsilon / len(q_s) + (1 - epsilon) * best / len(best)


def greedy_proportional(q_s, epsilon):
    return epsilon / len(q_s) + (1 - epsilon) * q_s / q_s.sum()


def greedy_counts_true_with_len(q_s, epsilon):
    best = q_s == q_s.max()
    return epsilon / len(q_s) + (1 - epsilon) * best / len(best)


def greedy_for(q_s, epsilon):
    best = q_s >= q_s.mean()
    return epsilon / len(q_s) + (1 - epsilon) * best / best.sum()


def greedy_best_by_is(q_s, epsilon):
    p = np.full(len(q_s), epsilon / len(q_s))
    for a in range(len(q_s)):
        if q_s[a] == max(q_s):
            p[a] = 1 - epsilon
    return p / p.sum()


def greedy_returns_dict(q_s, epsilon):
    return {a: epsilon / len(q_s) for a in range(len(q_s))}


def draw_loops_over_probabilities(p, u):
    total = 0
    for i in p:
        total += p[i]
        if u < total:
            return i


def draw_while_one_too_many(p, u):
    total, a = 0, 0
    while total < u:
        total += p[a]
        a += 1
    return a


def draw_counts_p_0_twice(p, u):
    total = p[0]
    for a in range(len(p)):
        total += p[a]
        if u < total:
            return a


def draw_argmax_of_p_above_u(p, u):
    return int(np.argmax(p > u))


def draw_total_reset_inside(p, u):
    for a in range(len(p)):
        total = 0
        total += p[a]
        if u < total:
            return a
    return len(p) - 1


def draw_enumerates_the_wrong_way(p, u):
    total = 0
    for pa, a in enumerate(p):
        total += pa
        if u < total:
            return a


def draw_while_index_beyond(p, u):
    a = 0
    total = 0
    while u > total:
        total += p[a]
        a = a + 1
    return a - 1


def draw_break_and_return_outside(p, u):
    total = 0
    for a in range(len(p)):
        total += p[a]
        if u < total:
            break
        return a


def softmax_2_718(x, temperature):
    powers = 2.718 ** ((x - x.max()) / temperature)
    return powers / powers.sum()


def softmax_e(x, temperature):
    powers = e ** ((x - x.max()) / temperature)
    return powers / powers.sum()


def softmax_t_lacks_below(x, temperature):
    return np.exp((x - x.max()) / temperature) / np.exp(x - x.max()).sum()


def softmax_shifts_numerator_only(x, temperature):
    return np.exp((x - x.max()) / temperature) / np.exp(x / temperature).sum()


def softmax_max_after_division_by_sum(x, temperature):
    x = x / temperature
    x = x - x.max()
    return x / x.sum()


def softmax_temperature_as_power_base(x, temperature):
    powers = temperature ** (x - x.max())
    return powers / powers.sum()


WRONG = {
    "by_hand": [
        ([0.4, 0.2, 0.4], "action 1 gets its ε"),
        ([0.55, 0.1, 0.35], "the two best are"),
        ([1, 0, 0], "this never explores, and"),
    ],
    "epsilon_greedy": [
        (greedy_one_best_by_list_index, "an array has nothing"),
        (greedy_values_not_marks, "q_s[q_s == q_s.max()] takes"),
        (greedy_proportional, "Q does not grade"),
        (greedy_counts_true_with_len, "divide by the number"),
        (greedy_for, "better than the mean"),
        (greedy_best_by_is, "the best get 1 −"),
        (greedy_returns_dict, "the p is a"),
    ],
    "draw": [
        (draw_loops_over_probabilities, "i is 0.2, and an"),
        (draw_while_one_too_many, "a has already moved"),
        (draw_counts_p_0_twice, "p[0] is counted twice: total"),
        (draw_argmax_of_p_above_u, "p > u compares"),
        (draw_total_reset_inside, "total = 0 stands inside"),
        (draw_enumerates_the_wrong_way, "enumerate gives the number"),
        (draw_while_index_beyond, "u = 0 finds no"),
        (draw_break_and_return_outside, "the loop ends in"),
    ],
    "softmax": [
        (softmax_2_718, "nearly: e is 2.71828…, with"),
        (softmax_e, "e is one of"),
        (softmax_t_lacks_below, "below the line stand"),
        (softmax_shifts_numerator_only, "the largest x is"),
        (softmax_max_after_division_by_sum, "the exponential is missing"),
        (softmax_temperature_as_power_base, "powers of e, not"),
    ],
}
