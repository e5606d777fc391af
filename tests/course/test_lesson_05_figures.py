"""Lesson 05's figures: similar states differ in one input alone."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_05.figures import plot_similar_states
from rlrobot_edu.widgets.kernels import bias_of

TASK = rl.load_task("worked_example")
STATES = TASK.states


# The paper's example in section 3.3, state (1, 1, 90°, T): of each input, the states whose Q it averages, as bins.
PAPERS_STATE = STATES.number((1, 1, 1, 1))
PAPERS_SETS = {
    "X": [(0, 1, 1, 1), (1, 1, 1, 1)],
    "Y": [(1, 0, 1, 1), (1, 1, 1, 1)],
    "theta": [(1, 1, 0, 1), (1, 1, 1, 1), (1, 1, 2, 1)],
    "d": [(1, 1, 1, 0), (1, 1, 1, 1)],
}


def test_the_sets_of_the_papers_state_are_the_papers():
    sets = STATES.siblings(PAPERS_STATE)
    for name, bins in PAPERS_SETS.items():
        assert [STATES.bins(int(k)) for k in sets[name]] == bins


@pytest.mark.parametrize("a", [0, 1, 2])
def test_the_bias_of_the_papers_state_is_the_mean_of_four_means(a):
    q = np.random.default_rng(3).normal(0, 5, (24, 3))
    means = [
        np.mean([q[STATES.number(bins), a] for bins in states])
        for states in PAPERS_SETS.values()
    ]
    found = bias_of(q, STATES.shape, PAPERS_STATE)[a]
    assert found == pytest.approx(np.mean(means))


def pose(ax) -> tuple:
    """Bins of what a small map shows: the coloured cell, the direction of its bar, and how thick that is."""
    (cell,) = [p for p in ax.patches if p.get_facecolor() != (1, 1, 1, 1)]
    x, y = (round(float(at) + 0.5) for at in cell.get_xy())
    bar = ax.lines[0]
    ahead = np.mean(bar.get_xydata(), axis=0) - (x, y)
    theta = {(1, 0): 0, (0, 1): 1, (0, -1): 2}[
        tuple(np.sign(ahead.round(6)).astype(int))
    ]
    return x, y, theta, int(bar.get_linewidth() > 2)


@pytest.mark.parametrize("s", [0, 13, 21])
def test_each_row_of_maps_is_a_set_and_the_state_itself_is_in_each(s):
    maps = np.array(plot_similar_states(s).axes).reshape(4, 3)
    for i, (row, states) in enumerate(
        zip(maps, STATES.siblings(s).values(), strict=True)
    ):
        shown = [ax for ax in row if ax.patches]
        assert [int(ax.get_title().split("state ")[1]) for ax in shown] == list(states)
        assert [pose(ax) for ax in shown] == [STATES.bins(k) for k in states]
        assert [pose(ax)[i] for ax in shown] == list(range(len(states))) and s in states
        assert [ax.title.get_weight() == "bold" for ax in shown] == [
            k == s for k in states
        ]


def test_the_finding_counts_the_similar_states_without_the_state_itself():
    finding = plot_similar_states(1).finding
    assert finding == "Change one input alone, and you get 5 similar states"


def test_a_state_that_does_not_exist_is_named():
    with pytest.raises(ValueError, match="there is no state 24"):
        plot_similar_states(24)
