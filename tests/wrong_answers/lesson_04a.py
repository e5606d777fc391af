"""Typical wrong answers of lesson 04a, written as learners write them, and a word of the hint each must get."""

import numpy as np


def expected_past_the_end(q, p, r, s_next, terminated, gamma):
    return r + gamma * np.dot(p, q[s_next])


def expected_max(q, p, r, s_next, terminated, gamma):
    return r + gamma * np.max(q[s_next]) * (1 - terminated)


def expected_unweighted(q, p, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * sum(q[s_next]) / len(p)


def expected_array(q, p, r, s_next, terminated, gamma):
    if terminated:
        return r
    return r + gamma * p * q[s_next]


def expected_likeliest(q, p, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * q[s_next][np.argmax(p)]


def expected_averaged_twice(q, p, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * np.mean(p * q[s_next])


WRONG = {
    "expected_target": [
        (expected_past_the_end, "past the end"),
        (expected_max, "as if it were certain. Weight"),
        (expected_unweighted, "count alike"),
        (expected_array, "single number"),
        (expected_likeliest, "likeliest action"),
        (expected_averaged_twice, "weighted twice"),
    ],
}
