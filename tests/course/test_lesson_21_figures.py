"""Lesson 21's rulers say what the library reckons."""

from itertools import pairwise

import numpy as np

import rlrobot_edu as rl
from rlrobot_course.lesson_21 import exercises
from rlrobot_course.lesson_21.bins import overlap
from rlrobot_course.lesson_21.rulers import edges_of, rulers_finding


def test_shares_of_bins_are_those_of_the_library():
    tasks = [
        rl.load_task(name) for name in ("wander_1k", "wander_12k", "giraff_wander_1k")
    ]
    for target in tasks:
        for source in tasks:
            ends, edges = edges_of(target.name), edges_of(source.name)
            mine = [
                exercises.overlaps(left, right, edges) for left, right in pairwise(ends)
            ]
            assert np.allclose(mine, overlap(target.inputs[0], source.inputs[0]))


def test_the_title_of_the_rulers_counts_bins():
    said = rulers_finding([[1.0, 0.0], [0.3, 0.7], [0.0, 1.0]])
    assert said == "2 of the 3 new bins lie in one old bin each, 1 in several"
    assert rulers_finding([[1.0]]).startswith("Each of the 1 new bins")
