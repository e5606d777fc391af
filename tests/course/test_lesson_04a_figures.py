"""Lesson 04a's figures, and the curves of a learner's own runs: what they draw is what was learned."""

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_04a.figures import learn_in_units, plot_ends, plot_side_by_side, plot_temperature
from rlrobot_course.lesson_04a.ties import count_visits, plot_visits
from rlrobot_course.runs import plot_runs
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions


def test_visits_are_counted_where_steps_end_and_the_map_names_the_cells():
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)  # action 0 is left, 1 is down
    left, down = count_visits(lake, np.argmax, episodes=2), count_visits(lake, lambda q_s: 1, episodes=3)
    assert left[0] == left.sum() == 2 * 100, "into the wall until time is up"
    assert [down[s] for s in (4, 8, 12)] == [3, 3, 3] and down.sum() == 9, "three steps down into the hole"
    figure = plot_visits(lake, {"left": left, "down": down}, "title")
    texts = [text.get_text() for text in figure.axes[1].texts]
    assert texts[0] == "start\nnever" and texts[12] == "hole\n33.3 %" and len(texts) == 16


def test_the_bars_show_the_softmax_and_the_curves_end_at_greedy_and_at_random():
    figure = plot_temperature([2.0, 0.0, 1.0], 2.0)
    heights = [bar.get_height() for bar in figure.axes[1].patches]
    assert sum(heights) == pytest.approx(1)
    assert heights[0] / heights[1] == pytest.approx(np.e), "two apart at a temperature of two"
    curves = np.array([line.get_ydata() for line in figure.axes[0].lines[:3]])
    assert np.allclose(curves[:, 0], [1, 0, 0], atol=1e-4) and np.allclose(curves[:, -1], 1 / 3, atol=1e-3)


@pytest.mark.parametrize("normalised", [True, False])
@pytest.mark.parametrize("factor", [1 / 8, 64])  # powers of two, which lose nothing in rounding
def test_other_units_are_a_largest_reward_that_the_agent_is_told_wrong_or_nothing_at_all(factor, normalised):
    """Oracle: an agent in the task's own units, which is told the largest reward `factor` times too small, or right."""
    task = rl.load_task("wander_simple")
    (in_units,) = learn_in_units(task, factor, normalised, repetitions=1, steps=200, seed=3)
    twin = rl.Agent(task, "Q+SR", seed=3, loop_evasion=False, r_max=max(task.rewards) / (1 if normalised else factor))
    rewards = rl.learn(twin, rl.make_env(task, seed=3), 200, progress=False).rewards
    assert np.array_equal(in_units.rewards, rewards) and np.array_equal(in_units.q, twin.q * factor)


def history(rewards: list[float]) -> History:
    """A history of these rewards, in one state with one action."""
    n = len(rewards)
    transitions = Transitions.empty(n)._replace(r=np.array(rewards))
    learned = Learned.of(np.zeros((1, 1)), np.full((1, 1), n))
    return History("m", transitions, learned, 0.0, Size((1,), 1))


def test_each_panel_has_its_curves():
    groups = [[history([0.0, 2 * end])] for end in (1.5, -2.5)]
    figure = plot_side_by_side({"one": groups, "two": groups[::-1], "three": groups}, ["A", "B"], "title", columns=3)
    assert [ax.get_title() for ax in figure.axes] == ["one", "two", "three"]
    assert [line.get_ydata()[-1] for line in figure.axes[1].lines] == [-2.5, 1.5]
    with pytest.raises(ValueError, match="2 curves"):
        plot_side_by_side({"one": groups}, ["A"], "title", columns=1)


def test_a_dot_a_robot_and_a_bar_for_their_mean():
    groups = [[history([1.0] * 300 + [end] * 200) for end in (2.0, 4.0)], [history([0.0] * 500)]]
    ax = plot_ends({"one": groups, "two": groups}, ["A", "B"], "title").axes[0]
    assert [list(line.get_ydata()) for line in ax.lines] == [[2.0, 4.0], [3.0, 3.0], [0.0], [0.0, 0.0]]


def test_the_curve_of_a_run_is_the_mean_of_its_rewards_so_far():
    figure = plot_runs({"yours": [0.0, 2.0, 4.0], "the library's": [3.0, 3.0, 3.0]}, "title")
    assert [list(line.get_ydata()) for line in figure.axes[0].lines] == [[0.0, 1.0, 2.0], [3.0, 3.0, 3.0]]
