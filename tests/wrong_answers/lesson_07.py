"""Typical wrong answers of lesson 07, written as learners write them, and a word of the hint each must get."""

import numpy as np


def family(shape, s, i):
    table = np.moveaxis(np.arange(np.prod(shape)).reshape(shape), i, -1)
    return next(row for row in table.reshape(-1, shape[i]) if s in row)


def siblings_without_s(shape, s, i):
    found = family(shape, s, i).tolist()
    found.remove(s)
    return found


def siblings_same_bin(shape, s, i):
    bins = np.array(np.unravel_index(np.arange(np.prod(shape)), shape))
    return np.flatnonzero(bins[i] == bins[i, s]).tolist()


def siblings_share_everything(shape, s, i):
    bins = np.array(np.unravel_index(np.arange(np.prod(shape)), shape)).T
    return np.flatnonzero((bins == bins[s]).all(axis=1)).tolist()


def siblings_any_one_input(shape, s, i):
    bins = np.array(np.unravel_index(np.arange(np.prod(shape)), shape)).T
    return np.flatnonzero((bins != bins[s]).sum(axis=1) <= 1).tolist()


def siblings_fortran(shape, s, i):
    return family(shape[::-1], s, len(shape) - 1 - i).tolist()


def siblings_upward(shape, s, i):
    step = int(np.prod(shape[i + 1 :]))
    return list(range(s, s + step * shape[i], step))


def siblings_next_numbers(shape, s, i):
    start = s // shape[i] * shape[i]
    return [start + k for k in range(shape[i])]


def siblings_s_first(shape, s, i):
    return [s] + [k for k in family(shape, s, i) if k != s]


def box(q, shape, s):
    return q.reshape(*shape, -1), np.unravel_index(s, shape)


def axis_mean(q, shape, s, i):
    values, bins = box(q, shape, s)
    return values.mean(axis=i)[tuple(np.delete(bins, i))]


def bias_without_s(q, shape, s):
    means = []
    for i, n in enumerate(shape):
        means.append((axis_mean(q, shape, s, i) * n - q[s]) / (n - 1))
    return sum(means) / len(means)


def bias_all_at_once(q, shape, s):
    bins = np.array(np.unravel_index(np.arange(len(q)), shape)).T
    return q[(bins != bins[s]).sum(axis=1) <= 1].mean(axis=0)


def bias_weighted(q, shape, s):
    return sum(n * axis_mean(q, shape, s, i) for i, n in enumerate(shape)) / sum(shape)


def bias_not_divided(q, shape, s):
    total = 0
    for i in range(len(shape)):
        total = total + axis_mean(q, shape, s, i)
    return total


def bias_of_sums(q, shape, s):
    return np.mean([n * axis_mean(q, shape, s, i) for i, n in enumerate(shape)], axis=0)


def bias_only_s(q, shape, s):
    values, bins = box(q, shape, s)
    return values[bins]


def bias_added(q, shape, s):
    return q[s] + np.mean([axis_mean(q, shape, s, i) for i in range(len(shape))], axis=0)


def bias_one_number(q, shape, s):
    return np.mean([axis_mean(q, shape, s, i) for i in range(len(shape))])


def bias_overwritten(q, shape, s):
    for i in range(len(shape)):
        mean = axis_mean(q, shape, s, i)
    return mean


def bias_fortran(q, shape, s):
    return np.mean([q[siblings_fortran(shape, s, i)].mean(axis=0) for i in range(len(shape))], axis=0)


def bias_writes(q, shape, s):
    b = np.mean([axis_mean(q, shape, s, i) for i in range(len(shape))], axis=0)
    q[s] = q[s] + b
    return b


def bias_in_the_row(q, shape, s):
    total = q[s]
    for i in range(len(shape)):
        total += axis_mean(q, shape, s, i)
    return total / len(shape)


def bias_always_four(q, shape, s):
    return sum(axis_mean(q, shape, s, i) for i in range(len(shape))) / 4


def bias_first_input(q, shape, s):
    for i in range(len(shape)):
        return axis_mean(q, shape, s, i)


def siblings_from_one(shape, s, i):
    return family(shape, s, i).tolist()[1:]


def siblings_next_bins(shape, s, i):
    table = np.arange(np.prod(shape)).reshape(shape)
    bins = list(np.unravel_index(s, shape))
    own, found = bins[i], []
    for k in (own - 1, own, own + 1):
        if 0 <= k < shape[i]:
            bins[i] = k
            found.append(table[tuple(bins)])
    return found


def siblings_one_too_far(shape, s, i):
    step = int(np.prod(shape[i:]))
    first = int(family(shape, s, i)[0])
    return [first + k * step for k in range(shape[i])]


def siblings_of_the_bins_before(shape, s, i):
    first, step = int(family(shape, s, i)[0]), int(np.prod(shape[:i]))
    return [first + k * step for k in range(shape[i])]


def bias_skips_what_is_new(q, shape, s):
    means = []
    for i in range(len(shape)):
        rows = [q[k] for k in family(shape, s, i) if q[k].any()]
        means.append(np.mean(rows or [q[s]], axis=0))
    return np.mean(means, axis=0)


def bias_begins_with_the_row(q, shape, s):
    total = q[s].copy()
    for i in range(len(shape)):
        total += axis_mean(q, shape, s, i)
    return total / len(shape)


def bias_of_the_others(q, shape, s):
    others = {int(k) for i in range(len(shape)) for k in family(shape, s, i)} - {s}
    return np.mean([q[k] for k in others], axis=0)


def siblings_of_24(shape, s, i):
    mine = np.delete(np.unravel_index(s, shape), i)
    found = []
    for k in range(24):
        other = np.delete(np.unravel_index(k, shape), i)
        if all(other == mine):
            found.append(k)
    return found


def siblings_one_apart(shape, s, i):
    own = np.unravel_index(s, shape)[i]
    return [int(s - own + k) for k in range(shape[i])]


def siblings_unlike(shape, s, i):
    bins = np.array(np.unravel_index(np.arange(np.prod(shape)), shape))
    return np.flatnonzero(bins[i] != bins[i, s]).tolist()


def bias_begins_anew(q, shape, s):
    for i in range(len(shape)):
        total = np.zeros(q.shape[1])
        total += axis_mean(q, shape, s, i)
    return total / len(shape)


def siblings_after_the_loop(shape, s, i):
    bins = list(np.unravel_index(s, shape))
    for k in range(shape[i]):
        bins[i] = k
    return [int(np.ravel_multi_index(bins, shape))]


def siblings_any(shape, s, i):
    me, found = np.unravel_index(s, shape), []
    for k in range(np.prod(shape)):
        other = np.unravel_index(k, shape)
        if any(other[j] == me[j] for j in range(len(shape)) if j != i):
            found.append(k)
    return found


def share_of_the_last(shape):
    share = 0
    for n in shape:
        share = 1 / n
    return share / len(shape)


WRONG = {
    "siblings": [
        (siblings_without_s, "s itself belongs"),
        (siblings_same_bin, "turned it round"),
        (siblings_share_everything, "s alone"),
        (siblings_any_one_input, "Only input i may differ"),
        (siblings_fortran, "counts fastest"),
        (siblings_upward, "upward from s"),
        (siblings_next_numbers, "neighbours in number"),
        (siblings_s_first, "not in order"),
        (siblings_from_one, "counted from 0"),
        (siblings_next_bins, "not only the next"),
        (siblings_one_too_far, "*after* i"),
        (lambda shape, s, i: {int(k) for k in family(shape, s, i)}, "no order"),
        (lambda shape, s, i: [str(k) for k in family(shape, s, i)], "text in it"),
        (lambda shape, s, i: len(family(shape, s, i)), "how many"),
        (siblings_of_the_bins_before, "not before it"),
        (siblings_of_24, "not always 24"),
        (siblings_one_apart, "1 apart only"),
        (siblings_unlike, "It is the others that count"),
        (siblings_after_the_loop, "after the loop"),
        (siblings_any, "one shared input is not enough"),
    ],
    "by_hand": [
        (7.5 + 3.5 + 6 - 1.5, "sum of the four means"),
        ((10 + 2 + (14 - 1) / 2 - 8) / 4, "left the state itself out"),
        ((5 + 10 + 2 + 14 - 1 - 8) / 6, "all six states"),
        (5 + 3.875, "bias alone"),
        ((4 * 5 + 10 + 2 + 14 - 1 - 8) / 9, "all nine members"),
        ((10 + 2 + 14 - 1 - 8) / 5, "five other states"),
        (4, "rounded too far"),
    ],
    "bias": [
        (bias_without_s, "missing from its sets"),
        (bias_all_at_once, "all the states at once"),
        (bias_weighted, "large sets must not count more"),
        (bias_not_divided, "sum of the means"),
        (bias_of_sums, "number of its members"),
        (bias_only_s, "Q(s) itself"),
        (bias_added, "the bias alone"),
        (bias_one_number, "one number for all actions"),
        (bias_overwritten, "last input only"),
        (bias_fortran, "first input fastest"),
        (bias_writes, "work on a copy"),
        (bias_in_the_row, "Begin with zeros"),
        (bias_always_four, "a fixed 4"),
        (bias_first_input, "inside the loop"),
        (bias_skips_what_is_new, "never visited"),
        (bias_begins_with_the_row, "in the sets already"),
        (bias_of_the_others, "other states"),
        (bias_begins_anew, "begins anew"),
    ],
    "own_share": [
        (lambda shape: np.sum(1 / np.array(shape)), "adds the shares up"),
        (lambda shape: 1 / np.prod(shape), "among all states"),
        (lambda shape: 1 / np.mean(shape), "one large set"),
        (lambda shape: 1 / len(shape), "not the only member"),
        (lambda shape: np.mean([1 - 1 / n for n in shape]), "share of the others"),
        (lambda shape: sum(1 // n for n in shape) / len(shape), "divide with /"),
        (lambda shape: 1 / shape[0], "first input"),
        (lambda shape: sum(1 / n for n in shape) / 4, "need not be four"),
        (lambda shape: [1 / n for n in shape], "one number, their mean"),
        (lambda shape: 1 + sum(1 / n for n in shape) / len(shape), "bias(s) alone"),
        (lambda shape: 1 / (sum(shape) - len(shape) + 1), "different states"),
        (share_of_the_last, "last share"),
    ],
}
