"""Lesson 09's figures say what the numbers say."""

import numpy as np
import pytest
from matplotlib.text import Annotation

import rlrobot_edu as rl
from rlrobot_course.lesson_09.figures import (
    how_often_paid,
    plot_pull,
    plot_rut,
    plot_worth,
    probability_of_best,
)
from rlrobot_course.play.challenge import Score


def test_the_best_action_is_certain_when_cold_and_one_of_many_when_hot():
    x = np.array([5.0, 0.0, 1.0])
    cold, one, hot = probability_of_best(x, np.array([1e-3, 1.0, 1e9]))
    assert (cold, hot) == pytest.approx((1, 1 / 3))
    assert one == pytest.approx(np.exp(5) / np.exp(x).sum())


def test_the_arrows_of_the_pull_lead_from_q_to_the_sum():
    q_s, bias = np.array([-0.2, 0.0, 0.3]), np.array([2.7, 0.1, 0.0])
    picture = plot_pull(q_s, bias, ["ahead", "left", "right"], q_max=100)
    arrows = [
        (text.xyann[0], text.xy[0])
        for text in picture.axes[0].texts
        if isinstance(text, Annotation)
    ]
    assert np.allclose(arrows, [(-0.2, 2.5), (0.3, 0.3)]), "of the best two actions"
    assert "lifts the best action from −0.20 to 2.50" in picture.finding


def test_the_rut_counts_the_steps_since_the_reward_last_changed():
    env = rl.make_env("worked_example", seed=0)
    agent = rl.Agent("worked_example", seed=0)
    history = rl.learn(agent, env, 20, progress=False)
    history.rewards[:15], history.rewards[15:] = 10.0, -2.0
    picture = plot_rut(env.unwrapped.robot.scene(), history)
    assert picture.finding.startswith("For 5 steps")
    assert "−2.00" in picture.finding


def test_the_first_finding_says_how_often_the_robot_is_paid():
    env = rl.make_env("worked_example", seed=0)
    agent = rl.Agent("worked_example", seed=0)
    history = rl.learn(agent, env, 20, progress=False)
    history.rewards[:5], history.rewards[5:] = 10.0, -2.0
    assert how_often_paid(history) == (
        "In its first 20 steps the robot earns 1.00 a step: 10 in 25 % of them"
    )


def test_each_kind_of_robot_has_two_means():
    pairs = {
        "cold": (Score(1.0, 0.2), Score(2.0, 0.3)),
        "warm": (Score(4.0, 0.1), Score(3.9, 0.1)),
    }
    picture = plot_worth(pairs)
    dots = [line for line in picture.axes[0].lines if line.get_marker() == "o"]
    assert [float(dot.get_xdata()[0]) for dot in dots] == [1, 4, 2, 3.9]
    assert picture.finding == (
        "Loop evasion adds 1.00 for cold; nothing that shows for warm"
    )


def test_a_reader_who_subtracts_the_means_finds_the_gain():
    pairs = {"cold": (Score(2.535, 0.1), Score(4.104, 0.1))}
    without, evading = (f"{score.mean:.2f}" for score in pairs["cold"])
    gain = float(evading) - float(without)
    assert f"{gain:.2f} for cold" in plot_worth(pairs).finding
