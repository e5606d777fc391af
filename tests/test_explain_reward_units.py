"""The same task with its rewards in other units."""

import numpy as np
from rlrobot_edu.course.lesson_03.reward_units import learn_in_units, plot_units

import rlrobot_edu as rl


def test_units_change_nothing_once_values_are_normalised_and_much_if_not():
    task = rl.load_task("wander_simple")

    def rewards(factor, normalised):
        return learn_in_units(task, factor, normalised, repetitions=1, steps=200, seed=0)[0].rewards

    assert np.allclose(rewards(1, True), rewards(100, True))
    assert not np.allclose(rewards(1, False), rewards(100, False))


def test_the_picture_tells_where_each_curve_ends():
    figure = plot_units(rl.load_task("worked_example"), [1, 10], repetitions=2, steps=20)
    assert figure.alt.count("rewards × 10") == 2 and "; normalised (2 repetitions)" in figure.alt
