"""Solutions of lesson 16, as a learner writes them."""

by_hand = 0.5 * 0.9 * (0.5 * 0.9 * 0.5)
two_biases = (((2 + 10) / 4 + 2 / 4) / 2, (3 * 2 + 1 * 10 + 3 * 2) / (3 + 1 + 3))


def dyna(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = s_next
        if terminated or truncated:
            s = env.reset()


def overlaps(left, right, edges):
    shares = []
    for i in range(len(edges) - 1):
        low, high = edges[i], edges[i + 1]
        common = min(right, high) - max(left, low)
        shares.append(max(0, common) / (right - left))
    return shares
