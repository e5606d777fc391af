"""Lesson 09a's figure shows each robot's longest time without a reward."""

import itertools

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_09a.figures import longest_dry_spell, plot_dry_spells


@pytest.mark.parametrize("seed", range(5))
def test_the_longest_dry_spell_is_the_one_that_counting_finds(seed):
    rewards = np.random.default_rng(seed).choice([-2.0, -0.02, 0.0, 10.0], 60)
    dry = [len(list(group)) for paid, group in itertools.groupby(rewards > 0) if not paid]
    assert longest_dry_spell(rewards) == max(dry)
    assert longest_dry_spell(rewards[rewards > 0]) == 0
    assert longest_dry_spell(rewards[rewards <= 0]) == (rewards <= 0).sum()


def test_there_is_a_dot_for_every_robot():
    groups = {
        name: rl.repeat("wander_simple", repetitions=3, steps=200, seed=seed, n_jobs=1)
        for seed, name in enumerate("ab")
    }
    picture = plot_dry_spells(groups, "Two settings")
    dots = [line.get_xdata() for line in picture.axes[0].lines if line.get_marker() == "o"]
    assert [list(x) for x in dots] == [sorted(longest_dry_spell(h.rewards) for h in g) for g in groups.values()]
