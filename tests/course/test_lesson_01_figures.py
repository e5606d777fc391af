"""Lesson 01's figure: bins as the task itself has them."""

import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_01.figures import plot_bins

INPUTS = rl.load_task("wander_1k").inputs
READINGS = {
    variable.name: reading
    for variable, reading in zip(INPUTS, (0.1, 0.27, 0.6, 0.8, 4.9), strict=True)
}


def test_every_row_names_the_bin_of_its_reading():
    ax = plot_bins(INPUTS, READINGS).axes[0]
    words = [text.get_text() for text in ax.texts if "→" in text.get_text()]
    assert [int(word.split()[-1]) for word in words] == [0, 0, 2, 2, 3]
    assert [label.get_text() for label in ax.get_yticklabels()] == [
        variable.name for variable in INPUTS
    ]


def test_a_bar_ends_in_the_bin_that_its_row_names():
    ax = plot_bins(INPUTS, READINGS).axes[0]
    bars = [bar for bar in ax.patches if bar.get_height() < 0.5]
    assert [bar.get_width() for bar in bars] == [
        0.1,
        0.27,
        0.6,
        0.8,
        1.6,
    ]  # the last is cut off at the edge


def test_an_input_without_cut_points_is_refused():
    with pytest.raises(ValueError, match="'theta' has no cut points"):
        plot_bins([rl.InputVariable("theta", sectors=8)], {"theta": 0})
