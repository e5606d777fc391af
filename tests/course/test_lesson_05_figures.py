"""Lesson 05's figures: similar states differ in one input, and the bias helps and misleads as the figures say."""

import numpy as np
import pytest
from oracles import numpy_bias

import rlrobot_edu as rl
from rlrobot_course.lesson_05.arrivals import GROUPS, mean_by_visits, quality, share_of_bias, watch_arrivals
from rlrobot_course.lesson_05.figures import plot_bias_ageing, plot_misleading_bias, plot_similar_states

TASK = rl.load_task("worked_example")
STATES = TASK.states


def pose(ax) -> tuple:
    """Bins of what a small map shows: the coloured cell, the direction of its bar, and how thick that is."""
    (cell,) = [p for p in ax.patches if p.get_facecolor() != (1, 1, 1, 1)]
    x, y = (round(float(at) + 0.5) for at in cell.get_xy())
    bar = ax.lines[0]
    ahead = np.mean(bar.get_xydata(), axis=0) - (x, y)
    theta = {(1, 0): 0, (0, 1): 1, (0, -1): 2}[tuple(np.sign(ahead.round(6)).astype(int))]
    return x, y, theta, int(bar.get_linewidth() > 2)


@pytest.mark.parametrize("s", [0, 13, 21])
def test_each_row_of_maps_is_a_set_and_the_state_itself_is_in_each(s):
    maps = np.array(plot_similar_states(s).axes).reshape(4, 3)
    for i, (row, states) in enumerate(zip(maps, STATES.siblings(s).values(), strict=True)):
        shown = [ax for ax in row if ax.patches]
        assert [int(ax.get_title().split("state ")[1]) for ax in shown] == list(states)
        assert [pose(ax) for ax in shown] == [STATES.bins(k) for k in states]
        assert [pose(ax)[i] for ax in shown] == list(range(len(states))) and s in states
        assert [ax.title.get_weight() == "bold" for ax in shown] == [k == s for k in states]


def test_a_state_that_does_not_exist_is_named():
    with pytest.raises(ValueError, match="state 24 does not exist"):
        plot_similar_states(24)


def test_the_quality_of_an_action_is_1_for_the_best_and_0_for_a_guess():
    q_best, s = np.array([[1.0, 2.0, 6.0], [4.0, 4.0, 4.0]]), np.array([0, 0, 0, 1])
    values = quality(q_best, s, np.array([[0.0, 0, 1], [0, 0, 0], [1, 0, 0], [1, 0, 0]]))
    assert np.allclose(values[:3], [1, 0, -2 / 3]) and np.isnan(values[3])
    assert np.allclose(share_of_bias(np.array([[0.0, 3], [0, 0]]), np.array([[1.0, 2], [5, 0]])), [0.25, 1])


def test_arrivals_hold_what_the_agent_knew_before_it_acted_there():
    agent, env = rl.Agent(TASK, seed=0), rl.make_env(TASK, seed=0)
    seen = watch_arrivals(agent, env, 50)
    twin = rl.Agent(TASK, seed=0)
    for step in rl.steps(twin, rl.make_env(TASK, seed=0), 50):
        assert (seen.s[step.t], seen.visits[step.t]) == (step.s_next, twin.visits[step.s_next].sum())
        assert np.array_equal(seen.q[step.t], twin.q[step.s_next])
        assert np.allclose(seen.bias[step.t], numpy_bias(twin.q, STATES.shape, step.s_next))


def test_means_by_visits_leave_out_what_is_unknown():
    means = mean_by_visits(np.array([0, 2, 3, 3, 100]), np.array([1.0, 2.0, 4.0, np.nan, 5.0]))
    assert np.allclose(means[[0, 2, -1]], [1, 3, 5]) and np.isnan(means[[1, 3]]).all() and len(means) == len(GROUPS)


@pytest.fixture(scope="module")
def model():
    return rl.SampleModel.from_recording(rl.read_recording("worked_example"))


def test_the_bias_helps_where_the_agent_has_not_been_before(model):
    figure = plot_bias_ageing(model, repetitions=20)
    left, right = figure.axes
    (alone, biased), (share,) = left.lines[:1] + left.lines[3:4], right.lines[:1]
    assert alone.get_ydata()[0] == 0 and biased.get_ydata()[0] > 0.05
    assert np.isclose(share.get_ydata()[0], 100) and 25 < share.get_ydata()[-1] < 50


def test_a_misled_agent_starts_below_a_guess_and_learns_all_the_same(model):
    figure = plot_misleading_bias(TASK, model, 13, repetitions=8)
    curve = {c.get_label(): c.lines[0].get_ydata() for c in figure.axes[1].containers}
    assert np.isclose(curve["TOSL+SR"][0], 100 / 3) and curve["TOSL+QBIASSR"][0] < 30
    assert min(curve["TOSL+SR"][-1], curve["TOSL+QBIASSR"][-1]) > 80
