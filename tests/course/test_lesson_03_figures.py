"""Lesson 03's figures: each curve is plain Q-learning over the same recorded steps."""

import numpy as np

import rlrobot_edu as rl
from rlrobot_course.lesson_03.figures import (
    plot_one_value,
    plot_run_back,
    plot_towards,
    who_rests,
)


def test_every_curve_is_q_learning_over_the_same_steps():
    """Oracle: the equation in plain NumPy, over steps that an agent took that does not look at its values."""
    task = rl.load_task("worked_example")
    rates = {"slow": 0.02, "jumps": 1.0}
    s_shown, a_shown = 0, 2
    settings = {label: {"alpha": alpha} for label, alpha in rates.items()}
    figure = plot_one_value(task, s_shown, a_shown, settings, steps=400)
    walk = list(
        rl.steps(rl.Agent(task, "Q+RANDOM", seed=0), rl.make_env(task, seed=0), 400)
    )
    for line, alpha in zip(figure.axes[0].lines, rates.values(), strict=True):
        q, values = np.zeros((24, 3)), []
        for x in walk:
            target = x.r + (0.0 if x.terminated else 0.9 * q[x.s_next].max())
            q[x.s, x.a] += alpha * (target - q[x.s, x.a])
            values.append(q[s_shown, a_shown])
        assert np.allclose(line.get_ydata(), values) and len(set(values)) > 2


def test_a_value_moves_towards_its_target_by_a_share_of_the_gap():
    (line,) = (
        line
        for line in plot_towards(10.0, 0.5, steps=3).axes[0].lines
        if len(line.get_ydata()) == 4
    )
    assert list(line.get_ydata()) == [0, 5, 7.5, 8.75]


def test_the_finding_names_the_wildest_and_the_calmest_curve():
    lasts = {"α = 1": np.array([3.0, 41.0]), "α = 0.1": np.array([5.0, 7.0])}
    assert who_rests(lasts, None) == (
        "With α = 1 Q leaps between 3 and 41; with α = 0.1 it is smooth"
    )
    assert who_rests(lasts, true=10.0).endswith("4 below the true value")
    assert who_rests(lasts, true=2.0).endswith("4 above the true value")


def test_the_finding_says_which_share_of_the_gap_a_step_closes():
    assert "closes 25 % of the gap" in plot_towards(8.0, 0.25).finding


def test_the_finding_counts_the_cells_that_know_of_the_reward():
    figure = plot_run_back(np.array([0.0, 0.0, 2.5, 5.0]))
    assert figure.finding == "2 of 4 cells know of the reward"
    assert [bar.get_height() for bar in figure.axes[0].patches] == [0, 0, 2.5, 5]
    assert "2.5, 5.0" in figure.alt
