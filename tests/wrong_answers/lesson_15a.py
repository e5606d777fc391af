"""Typical wrong answers of appendix 15a, written as learners write them, and a word of the hint each must get."""


def past_the_end(q, rows, alpha, gamma):
    for s, a, r, s_next, _ in rows:
        q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])


def one_row(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        target = r if terminated else r + gamma * q[s_next].max()
        q[s, a] += alpha * (target - q[s, a])
        return q


def until_the_end(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        target = r + gamma * q[s_next].max() * (1 - terminated)
        q[s, a] += alpha * (target - q[s, a])
        if terminated:
            return


def skips_the_end(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        if not terminated:
            q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])


def same_action(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        v = q[s_next][a] if not terminated else 0
        q[s, a] = (1 - alpha) * q[s, a] + alpha * (r + gamma * v)


WRONG = {
    "learn_from": [
        (past_the_end, "past the end"),
        (one_row, "only one row"),
        (until_the_end, "do not stop at terminated"),
        (skips_the_end, "Do not skip it"),
        (same_action, "only in SARSA"),
    ],
    "two_targets": [
        ((14.5, 46), "wrong order"),
        ((46, 46), "the teacher took next"),
        ((50, 15), "forgot γ"),
        ((36, 4.5), "reward of the step"),
    ],
    "last_action": [
        ("A", "the robot did not"),
        ("b", "no answer to its last state"),
        ("D", "Nobody knows"),
        (3, "in quotation marks"),
    ],
}
