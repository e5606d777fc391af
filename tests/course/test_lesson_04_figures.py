"""Lesson 04's figures, and the curves of a learner's own runs: what they draw is what was learned."""

import numpy as np
from matplotlib.colors import to_hex

from rlrobot_course.figures.runs import plot_runs
from rlrobot_course.figures.words import as_sentence
from rlrobot_course.lesson_04.figures import (
    plot_draw,
    plot_ends,
    plot_rules,
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


def history(rewards: list[float]) -> History:
    """A history of these rewards, in one state with one action."""
    n = len(rewards)
    transitions = Transitions.empty(n)._replace(r=np.array(rewards))
    learned = Learned.of(np.zeros((1, 1)), np.full((1, 1), n))
    return History("m", transitions, learned, 0.0, Size((1,), 1))


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


def test_the_finding_names_a_best_rule_only_where_the_intervals_are_apart():
    clear = {"ε-greedy": np.array([1.0, 1.1]), "softmax": np.array([9.0, 9.1])}
    close = {"ε-greedy": np.array([1.0, 9.0]), "softmax": np.array([2.0, 9.0])}
    assert who_earns_most({"arena, 2 robots": clear, "cells": close}) == (
        "Softmax earns most in the arena (9.05), too close to tell in the cells"
    )


def test_a_symbol_at_the_beginning_of_a_sentence_stays_small():
    assert as_sentence("ε-greedy earns most") == "ε-greedy earns most"
    assert as_sentence("greedy earns most") == "Greedy earns most"
