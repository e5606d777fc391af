"""The picture of the similar states: every pose is that of a state which shares all inputs but one."""

import numpy as np
import pytest
from rlrobot_edu.course.lesson_07.similar_states import plot_similar_states

import rlrobot_edu as rl

STATES = rl.load_task("worked_example").states


def pose(ax) -> tuple:
    """Bins of what a small map shows: the coloured cell, the direction of its bar, and how thick that is."""
    (cell,) = [p for p in ax.patches if p.get_facecolor() != (1, 1, 1, 1)]
    x, y = (round(float(at) + 0.5) for at in cell.get_xy())
    bar = ax.lines[0]
    ahead = np.mean(bar.get_xydata(), axis=0) - (x, y)
    theta = {(1, 0): 0, (0, 1): 1, (0, -1): 2}[tuple(np.sign(ahead.round(6)).astype(int))]
    return x, y, theta, int(bar.get_linewidth() > 2)


@pytest.mark.parametrize("s", [0, 13, 21])
def test_the_first_map_is_the_state_and_the_others_differ_from_it_in_one_input(s):
    figure = plot_similar_states(s)
    mine, *others = [pose(ax) for ax in figure.axes]
    assert mine == STATES.bins(s)
    assert len(set(others)) == 1 + 1 + 2 + 1
    for bins in others:
        assert sum(a != b for a, b in zip(bins, mine, strict=True)) == 1
        assert f"state {STATES.number(bins)} (" in figure.alt


def test_a_state_that_does_not_exist_is_named():
    with pytest.raises(ValueError, match="state 24 does not exist"):
        plot_similar_states(24)
