"""Lesson 09's figures say what the numbers say."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_09.figures import (
    plot_escape,
    plot_pull,
    plot_worth,
    probability_of_best,
)
from rlrobot_course.play.challenge import Score


def test_the_best_action_is_certain_when_cold_and_one_of_many_when_hot():
    x = np.array([5.0, 0.0, 1.0])
    cold, one, hot = probability_of_best(x, np.array([1e-3, 1.0, 1e9]))
    assert (cold, hot) == pytest.approx((1, 1 / 3))
    assert one == pytest.approx(np.exp(5) / np.exp(x).sum())


def test_the_bars_of_the_pull_are_q_and_bias():
    q_s, bias = np.array([-0.2, 0.0, 0.3]), np.array([2.7, 0.1, 0.0])
    picture = plot_pull(q_s, bias, ["ahead", "left", "right"], q_max=100)
    heights = [bar.get_height() for bar in picture.axes[0].patches]
    assert np.allclose(heights, [-0.2, 0.3, 2.7, 0, 2.5, 0.3]), (
        "of the best two actions Q, bias and their sum"
    )


def test_the_escape_shows_the_temperatures_and_marks_the_rewards():
    agent = rl.Agent("worked_example", seed=0)
    steps = list(rl.steps(agent, rl.make_env("worked_example", seed=0), 60))
    picture = plot_escape(steps, default=1.0)
    above, below = picture.axes
    assert np.allclose(below.lines[0].get_ydata(), [step.temperature for step in steps])
    low, high = (line.get_xdata() for line in above.lines)
    assert sorted([*low, *high]) == list(range(1, 61))
    assert all(steps[t - 1].r > 0 for t in high) and all(
        steps[t - 1].r <= 0 for t in low
    )


def test_each_kind_of_robot_has_two_bars():
    pairs = {
        "cold": (Score(1.0, 0.2), Score(2.0, 0.3)),
        "warm": (Score(4.0, 0.1), Score(3.9, 0.1)),
    }
    without, evading = (
        c
        for c in plot_worth(pairs, "a title").axes[0].containers
        if hasattr(c, "patches")
    )
    assert [bar.get_height() for bar in without] == [1, 4] and [
        bar.get_height() for bar in evading
    ] == [2, 3.9]
