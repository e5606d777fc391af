"""Typical wrong answers of lesson 16, written as learners write them, and a word of the hint each must get."""

from itertools import pairwise


def dyna_never_thinks(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        seen[(s, a)] = r, s2, terminated
        s = env.reset() if terminated or truncated else s2


def dyna_is_moved_in_thought(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for s, a in pick(seen):
            r, s_next, terminated = seen[s, a]
            update(q, s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()


def dyna_with_the_real_outcome(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        seen[s, a] = (r, s2, terminated)
        for x, b in pick(seen):
            update(q, x, b, r, s2, terminated)
        s = env.reset() if terminated or truncated else s2


def dyna_thinks_first(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        for pair in pick(seen):
            update(q, pair[0], pair[1], *seen[pair])
        seen[s, a] = (r, s2, terminated)
        s = env.reset() if terminated or truncated else s2


def dyna_keeps_the_first(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        if (s, a) not in seen:
            seen[s, a] = (r, s2, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = env.reset() if terminated or truncated else s2


def dyna_thinks_once(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        seen[s, a] = (r, s2, terminated)
        for pair in pick(seen)[:1]:
            update(q, *pair, *seen[pair])
        s = env.reset() if terminated or truncated else s2


def dyna_never_resets(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, _truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        seen[s, a] = (r, s2, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = s2


def dyna_remembers_ends(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s2, terminated)
        done = terminated or truncated
        seen[s, a] = (r, s2, done)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = env.reset() if done else s2


def common(left, right, low, high):
    return max(0.0, min(right, high) - max(left, low))


def overlaps_in_metres(left, right, edges):
    return [common(left, right, low, high) for low, high in pairwise(edges)]


def overlaps_of_the_source(left, right, edges):
    return [common(left, right, low, high) / (high - low) for low, high in pairwise(edges)]


def overlaps_below_zero(left, right, edges):
    return [(min(right, high) - max(left, low)) / (right - left) for low, high in pairwise(edges)]


def overlaps_all_or_nothing(left, right, edges):
    return [1.0 if common(left, right, low, high) > 0 else 0.0 for low, high in pairwise(edges)]


def overlaps_by_the_middle(left, right, edges):
    middle = (left + right) / 2
    return [float(low < middle <= high) for low, high in pairwise(edges)]


def overlaps_without_zeros(left, right, edges):
    shares = [common(left, right, low, high) / (right - left) for low, high in pairwise(edges)]
    return [share for share in shares if share > 0]


def overlaps_returns_early(left, right, edges):
    shares = []
    for low, high in pairwise(edges):
        shares.append(common(left, right, low, high) / (right - left))
        return shares


WRONG = {
    "by_hand": [
        (0, "once more"),
        (0.225, "after the second"),
        (0.2025, "one α"),
        (0.405, "both α"),
        (0.125, "both γ"),
        (0.5, "in thought"),
    ],
    "dyna": [
        (dyna_never_thinks, "nothing is learned from memory"),
        (dyna_is_moved_in_thought, "names of its own"),
        (dyna_with_the_real_outcome, "stands in seen[pair]"),
        (dyna_thinks_first, "before it remembers"),
        (dyna_keeps_the_first, "newest"),
        (dyna_thinks_once, "only the first"),
        (dyna_never_resets, "never reset"),
        (dyna_remembers_ends, "time is up"),
    ],
    "overlaps": [
        (overlaps_in_metres, "in metres"),
        (overlaps_of_the_source, "divide by right − left"),
        (overlaps_below_zero, "negative"),
        (overlaps_all_or_nothing, "in full"),
        (overlaps_by_the_middle, "middle"),
        (overlaps_without_zeros, "with a 0"),
        (overlaps_returns_early, "inside the loop"),
    ],
    "two_biases": [
        ((22 / 7, 1.75), "wrong order"),
        ((4.0, 22 / 7), "never visited"),
        ((1.75, 4.0), "twice"),
        ((1.75, 3.0), "mean of two means"),
        ((3.5, 22 / 7), "not their sum"),
    ],
}
