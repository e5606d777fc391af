"""Further wrong answers of lesson 04a: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it


def expected_loop_over_p(q, p, r, s_next, terminated, gamma):
    total = 0
    for a in p:
        total += p[a] * q[s_next, a]
    return r if terminated else r + gamma * total


WRONG = {
    "expected_target": [
        (expected_loop_over_p, "a is 0.8, and an"),
    ],
}
