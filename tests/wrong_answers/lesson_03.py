"""Typical wrong answers of lesson 03, written as learners write them, and a word of the hint each must get."""

import numpy as np


def greedy_argmax(q_s, epsilon):
    p = [epsilon / len(q_s) for _ in q_s]
    p[int(q_s.argmax())] += 1 - epsilon
    return p


def greedy_all_of_it(q_s, epsilon):
    best = max(q_s)
    return np.array([epsilon / len(q_s) + (1 - epsilon if x == best else 0) for x in q_s])


def greedy_explores_the_rest(q_s, epsilon):
    p = np.zeros(len(q_s))
    best = np.flatnonzero(q_s == max(q_s))
    rest = np.flatnonzero(q_s != max(q_s))
    p[best] = (1 - epsilon) / len(best)
    p[rest] = epsilon / max(len(rest), 1)
    return p


def greedy_best_too_small(q_s, epsilon):
    p = np.ones(len(q_s)) * epsilon / len(q_s)
    best = np.flatnonzero(q_s == np.max(q_s))
    p[best] = (1 - epsilon) / len(best)
    return p


def greedy_turned_round(q_s, epsilon):
    p = np.ones(len(q_s)) * (1 - epsilon) / len(q_s)
    best = np.flatnonzero(q_s == np.max(q_s))
    p[best] += epsilon / len(best)
    return p


def greedy_action(q_s, epsilon):
    return q_s.argmax()


def greedy_uniform(q_s, epsilon):
    return [epsilon / len(q_s)] * len(q_s)


def draw_single(p, u):
    for a in range(len(p)):
        if u < p[a]:
            return a


def draw_most_probable(p, u):
    return list(p).index(max(p))


def draw_border(p, u):
    total = 0
    for a, share in enumerate(p):
        total += share
        if u <= total:
            return a


def draw_early(p, u):
    total = p[0]
    a = 0
    while u >= total:
        a += 1
        total += p[a]
    return max(a - 1, 0)


def draw_uniform(p, u):
    return int(np.floor(len(p) * u))


def draw_probability(p, u):
    total = 0
    for share in p:
        total += share
        if u < total:
            return share


def draw_late(p, u):
    a, total = 0, 0.0
    while total <= u:
        total += p[a]
        a += 1
    return a


@np.errstate(all="ignore")
def softmax_overflows(x, temperature):
    return [np.exp(v / temperature) / sum(np.exp(x / temperature)) for v in x]


@np.errstate(all="ignore")
def softmax_brackets(x, temperature):
    e = np.exp(x - max(x) / temperature)
    return e / e.sum()


def softmax_forgets_temperature(x, temperature):
    e = np.exp(x - max(x))
    return e / sum(e)


def softmax_times(x, temperature):
    e = np.exp(temperature * (x - np.max(x)))
    return e / np.sum(e)


def softmax_without_exponential(x, temperature):
    return [v / sum(x) if sum(x) else 0 for v in x]


def softmax_without_sum(x, temperature):
    return [np.exp((v - max(x)) / temperature) for v in x]


@np.errstate(all="ignore")
def softmax_relative(x, temperature):
    e = np.exp(x / np.max(x) / temperature)
    return e / e.sum()


def softmax_no_return(x, temperature):
    e = np.exp((x - max(x)) / temperature)
    e = e / sum(e)


def greedy_last(q_s, epsilon):
    best = max(range(len(q_s)), key=lambda a: (q_s[a], a))
    return np.array([epsilon / len(q_s) + (1 - epsilon) * (a == best) for a in range(len(q_s))])


def greedy_nearly(q_s, epsilon):
    best = np.abs(q_s - q_s.max()) < 0.01
    return epsilon / len(q_s) + (1 - epsilon) * best / best.sum()


def draw_count(p, u):
    return sum(c > u for c in np.cumsum(p))


def draw_turned_round(p, u):
    total = 0
    for a in range(len(p)):
        total += p[a]
        if total < u:
            return a


def draw_compares_first(p, u):
    for a in range(len(p)):
        if sum(p[:a]) > u:
            return a


def draw_equal_shares(p, u):
    for share, total in zip(p, np.cumsum(p), strict=True):
        if u < total:
            return list(p).index(share)


def softmax_mean(x, temperature):
    e = np.exp((x - np.mean(x)) / temperature)
    return e / e.sum()


def softmax_in_place(x, temperature):
    x -= x.max()
    e = np.exp(x / temperature)
    return e / e.sum()


def softmax_rounded(x, temperature):
    e = np.exp((x - x.max()) / temperature)
    return np.round(e / e.sum(), 3)


def softmax_to_the_base_2(x, temperature):
    e = 2 ** ((x - x.max()) / temperature)
    return e / e.sum()


WRONG = {
    "by_hand": [
        ((0.8, 0.1, 0.1), "favour the first"),
        ((0.8, 0.1, 0.8), "more than 1"),
        ((0.5, 0, 0.5), "never explores"),
        ((0.35, 0.3, 0.35), "any action"),
        (np.array([0.35, 0.1, 0.35]), "less than 1"),
    ],
    "epsilon_greedy": [
        (greedy_argmax, "only the first"),
        (greedy_all_of_it, "more than 1"),
        (greedy_explores_the_rest, "any action"),
        (greedy_best_too_small, "below 1"),
        (greedy_turned_round, "changed places"),
        (greedy_action, "this is an action"),
        (greedy_uniform, "still lack"),
        (greedy_last, "only the last"),
        (greedy_nearly, "nearly as good"),
    ],
    "draw": [
        (draw_single, "alone"),
        (draw_most_probable, "most probable"),
        (draw_border, "exactly on a border"),
        (draw_early, "too early"),
        (draw_late, "too late"),
        (draw_uniform, "equally probable"),
        (draw_probability, "its number"),
        (draw_count, "the first of them"),
        (draw_turned_round, "wrong way round"),
        (draw_compares_first, "Add first"),
        (draw_equal_shares, "two may have the same"),
    ],
    "softmax": [
        (softmax_overflows, "not a number"),
        (softmax_brackets, "brackets"),
        (softmax_forgets_temperature, "no effect"),
        (softmax_times, "do not multiply"),
        (softmax_without_exponential, "exponential is missing"),
        (softmax_without_sum, "sum to 1"),
        (softmax_relative, "dividing by it"),
        (softmax_no_return, "returns nothing"),
        (softmax_mean, "not the mean"),
        (softmax_in_place, "work on a copy"),
        (softmax_rounded, "rounded to 3 digits"),
        (softmax_to_the_base_2, "not of 2"),
    ],
}
