"""Lesson 16a's rulers say what the library reckons."""

from itertools import pairwise

import numpy as np

import rlrobot_edu as rl
from rlrobot_course.lesson_16a import exercises
from rlrobot_course.lesson_16a.rulers import edges_of, plot_heirs, plot_rulers
from rlrobot_edu.tools.transfer.bins import overlap


def test_shares_of_bins_are_those_of_the_library():
    tasks = [rl.load_task(name) for name in ("wander_1k", "wander_12k", "giraff_wander_1k")]
    for target in tasks:
        for source in tasks:
            ends, edges = edges_of(target.name), edges_of(source.name)
            mine = [exercises.overlaps(left, right, edges) for left, right in pairwise(ends)]
            assert np.allclose(mine, overlap(target.inputs[0], source.inputs[0]).toarray())


def test_rulers_and_heirs_show_what_they_are_given():
    rulers = plot_rulers([0, 1, 2], [0, 2], [[1.0], [1.0]], ("new", "old"))
    assert "bin 0: 1.00 in 0; bin 1: 1.00 in 0" in rulers.alt
    heirs = plot_heirs({"task": {"new": np.ones((3, 40)), "heir": np.full((3, 40), 2.0)}})
    assert "task, new: ends at 1.0; task, heir: ends at 2.0" in heirs.alt
