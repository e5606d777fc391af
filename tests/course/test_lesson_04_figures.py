"""Lesson 04's figures, and the curves of a learner's own runs: what they draw is what was learned."""

import numpy as np
import pytest
from matplotlib.colors import to_hex

import rlrobot_edu as rl
from rlrobot_course.figures.runs import mean_and_half, plot_runs
from rlrobot_course.figures.words import as_sentence
from rlrobot_course.lesson_04.figures import (
    how_far_apart,
    how_much_more,
    learn_in_units,
    plot_draw,
    plot_earned,
    plot_ends,
    plot_rules,
    plot_side_by_side,
    sharpest_and_dullest,
    who_earns_most,
)
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.show.palette import BLUE


def test_the_segment_under_the_point_is_the_action_that_is_sampled():
    for u in (0.0, 0.49, 0.5, 0.99):
        figure = plot_draw([0.0, 0.5, 0.5], u)
        strong = [
            bar for bar in figure.axes[0].patches if to_hex(bar.get_facecolor()) == BLUE
        ]
        assert (
            len(strong) == 1
            and strong[0].get_x() <= u < strong[0].get_x() + strong[0].get_width()
        )


def test_the_pieces_of_a_rule_are_its_probabilities():
    rules = {"even": np.array([0.5, 0.5]), "greedy": np.array([1.0, 0.0])}
    (ax,) = plot_rules([2.0, 0.0], rules).axes
    pieces = [(piece.get_x(), piece.get_width()) for piece in ax.patches]
    assert pieces == [(0.0, 0.5), (0.5, 0.5), (0.0, 1.0), (1.0, 0.0)]


@pytest.mark.parametrize("normalised", [True, False])
@pytest.mark.parametrize(
    "factor", [1 / 8, 64]
)  # powers of two, which lose nothing in rounding
def test_other_units_are_a_largest_reward_that_the_agent_is_told_wrong_or_nothing_at_all(
    factor, normalised
):
    """Oracle: an agent in the task's own units, which is told the largest reward `factor` times too small, or right."""
    task = rl.load_task("wander_simple")
    (in_units,) = learn_in_units(task, factor, normalised, repetitions=1, steps=200)
    twin = rl.Agent(
        task,
        "Q+SR",
        seed=0,
        loop_evasion=False,
        r_max=max(task.rewards) / (1 if normalised else factor),
    )
    rewards = rl.learn(twin, rl.make_env(task, seed=0), 200, progress=False).rewards
    assert np.array_equal(in_units.rewards, rewards) and np.array_equal(
        in_units.q, twin.q * factor
    )


def history(rewards: list[float]) -> History:
    """A history of these rewards, in one state with one action."""
    n = len(rewards)
    transitions = Transitions.empty(n)._replace(r=np.array(rewards))
    learned = Learned.of(np.zeros((1, 1)), np.full((1, 1), n))
    return History("m", transitions, learned, 0.0, Size((1,), 1))


def test_each_panel_has_its_curves():
    groups = [[history([0.0, 2 * end])] for end in (1.5, -2.5)]
    figure = plot_side_by_side({"one": groups, "two": groups[::-1]}, ["A", "B"])
    assert [ax.get_title() for ax in figure.axes] == ["one", "two"]
    assert [line.get_ydata()[-1] for line in figure.axes[1].lines] == [-2.5, 1.5]
    with pytest.raises(ValueError, match="2 curves"):
        plot_side_by_side({"one": groups, "two": groups}, ["A"])


def test_a_dot_a_robot_and_a_bar_for_their_mean():
    ends = {"A": (2.0, 4.0), "B": (0.0, 0.0)}
    groups = {
        name: [history([1.0] * 300 + [end] * 200) for end in pair]
        for name, pair in ends.items()
    }
    ax = plot_ends({"one": groups, "two": groups}).axes[0]
    assert [list(line.get_ydata()) for line in ax.lines] == [
        [2.0, 4.0],
        [3.0, 3.0],
        [0.0, 0.0],
        [0.0, 0.0],
    ]


def test_the_difference_of_two_rules_has_its_interval():
    even = np.array([0.0, 1.0, 2.0])
    halves = np.hypot(*[mean_and_half(each)[1] for each in (even, even + 9)])
    said = how_much_more({"greedy": even, "softmax": even + 9})
    assert said == f"Softmax earns 9.00 ± {halves:.2f} more than greedy"
    close = how_much_more({"greedy": even + 0.5, "softmax": even})
    assert close.startswith("Greedy earns 0.50") and close.endswith("may be chance")


def test_what_robots_earn_by_two_rules_is_a_dot_for_each():
    figure = plot_earned({"A": (1.0, 3.0), "B": (0.0, 8.0)})
    assert [list(line.get_ydata()) for line in figure.axes[0].lines] == [
        [1.0, 3.0],
        [2.0, 2.0],
        [0.0, 8.0],
        [4.0, 4.0],
    ]
    assert "from 0.00 to 8.00" in figure.alt


def test_the_curve_of_a_run_is_the_mean_of_its_rewards_so_far():
    figure = plot_runs(
        {"yours": [0.0, 2.0, 4.0], "the library's": [3.0, 3.0, 3.0]}, "title"
    )
    assert [list(line.get_ydata()) for line in figure.axes[0].lines] == [
        [0.0, 1.0, 2.0],
        [3.0, 3.0, 3.0],
    ]


def test_the_finding_says_which_rules_are_sure_and_which_are_not():
    rules = {"even": np.array([0.5, 0.5]), "sure": np.array([0.1, 0.9])}
    assert sharpest_and_dullest([1.0, 4.0], rules) == (
        "The best action is taken in 90 % by sure, and in 50 % by even"
    )


def test_the_finding_says_where_the_curves_end_together():
    ends = {"not normalised (3 repetitions)": [1.0, 2.5], "normalised": [1.001, 1.0]}
    assert how_far_apart(ends) == (
        "Not normalised: 1.00 to 2.50 a step; normalised: all end at 1.00"
    )


def test_the_finding_names_a_best_rule_only_where_the_intervals_are_apart():
    clear = {"ε-greedy": np.array([1.0, 1.1]), "softmax": np.array([9.0, 9.1])}
    close = {"ε-greedy": np.array([1.0, 9.0]), "softmax": np.array([2.0, 9.0])}
    assert who_earns_most({"arena, 2 robots": clear, "cells": close}) == (
        "Softmax earns most in the arena (9.05), too close to tell in the cells"
    )


def test_a_symbol_at_the_beginning_of_a_sentence_stays_small():
    assert as_sentence("ε-greedy earns most") == "ε-greedy earns most"
    assert as_sentence("greedy earns most") == "Greedy earns most"


def test_a_name_has_the_colour_of_its_curve_whichever_is_the_highest():
    low, high = ([history(r)] for r in ([1.0, 0.0, 0.0], [1.0, 2.0, 3.0]))
    figure = plot_side_by_side({"one": [low, high], "two": [high, low]}, ["A", "B"])
    for ax in figure.axes:
        colours = [line.get_color() for line in ax.lines]
        assert len(set(colours)) == 2
        names = {text.get_text()[0]: text.get_color() for text in ax.texts}
        assert names == dict(zip("AB", colours, strict=True))
