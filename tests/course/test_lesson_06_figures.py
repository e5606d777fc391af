"""Lesson 06's cliff and figures: a model that is the environment, ways and returns that are those of the agents."""

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_06.figures import (
    WAYS,
    falls_in_words,
    falls_of,
    first_returns,
    plot_paths,
    plot_returns,
    way_of,
)
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.widgets.playground.cliff import (
    CLIFF,
    GOAL,
    SHORTEST,
    START,
    cliff_model,
    greedy_path,
)

UP, RIGHT, DOWN, LEFT = range(4)


def q_of(first_row: int) -> np.ndarray:
    """Q of an agent that climbs to a row, goes right and comes down to the goal."""
    best = np.full((4, 12), RIGHT)
    best[first_row + 1 :, 0] = UP
    best[first_row:, 11] = DOWN
    return np.eye(4)[best.ravel()]


def history(q: np.ndarray, returns=(-13.0,)) -> History:
    """A history that ends with `q`, its episodes one step long."""
    over, no_states = np.ones(len(returns), dtype=bool), np.zeros(0, dtype=int)
    transitions = Transitions(
        *[np.zeros(len(returns), dtype=int)] * 2,
        np.array(returns),
        no_states,
        over,
        ~over,
    )
    learned = Learned.of(q, np.zeros((48, 4), dtype=int))
    return History("Q+EG", transitions, learned, 0.0, Size((48,), 4, 1.0))


def test_the_model_answers_as_the_environment_does():
    env, model = gymnasium.make("CliffWalking-v1"), cliff_model()
    env.reset()
    for s in (s for s in range(GOAL) if s not in CLIFF):
        for a in range(4):
            env.unwrapped.s = s
            s_next, r, terminated, _, _ = env.step(a)
            assert model.outcomes(s, a) == [(s_next, r, terminated, 1)]


def test_the_greedy_path_is_the_walk_that_q_prescribes():
    path = greedy_path(q_of(first_row=2))
    assert path == (START, *range(24, 36), GOAL)
    assert len(path) - 1 == -SHORTEST
    assert len(greedy_path(q_of(first_row=0))) - 1 == -SHORTEST + 4


def test_a_path_that_comes_back_ends_where_it_does():
    assert greedy_path(np.eye(4)[np.full(48, DOWN)]) == (START, START)


def counted(histories):
    """How many agents keep to the edge of the cliff, leave it, or are lost, when they no longer explore."""
    ways = [way_of(history) for history in histories]
    edge, lost = ways.count(WAYS[2]), ways.count("lost")
    return {"edge": edge, "off": len(ways) - edge - lost, "lost": lost}


def test_the_picture_counts_the_ways():
    mixed = [
        history(q_of(2)),
        history(q_of(1)),
        history(q_of(0)),
        history(np.eye(4)[np.full(48, DOWN)]),
    ]
    assert counted(mixed) == {"edge": 1, "off": 2, "lost": 1}
    picture = plot_paths({"mixed": mixed})
    widths = [line.get_linewidth() for line in picture.axes[0].lines]
    assert max(widths) > min(widths)


def test_the_finding_names_the_way_that_most_agents_go():
    groups = {
        "first": [history(q_of(2)), history(q_of(2)), history(q_of(0))],
        "second": [history(q_of(1))],
    }
    finding = plot_paths(groups).finding
    assert finding == "First: 2 of 3 along the edge; second: 1 of 1 up to row 1"


def test_one_fall_is_no_falls():
    assert falls_in_words(np.zeros(10)) == ""
    assert falls_in_words(np.full(10, 0.1)) == "1 fall each"
    assert falls_in_words(np.full(10, 1.1)) == "11 falls each"


def test_falls_are_counted_in_the_cell_that_was_stepped_into():
    steps = [
        (START, RIGHT, -100.0),
        (25, DOWN, -100.0),
        (25, RIGHT, -1.0),
        (34, DOWN, -100.0),
    ]
    s, a, r = (np.array(column) for column in zip(*steps, strict=True))
    over = np.zeros(4, dtype=bool)
    transitions = Transitions(s, a, r, s, over, over)
    learned = Learned.of(np.zeros((48, 4)), np.zeros((48, 4), dtype=int))
    one = History("Q+EG", transitions, learned, 0.0, Size((48,), 4, 1.0))
    assert list(falls_of([one, one])) == [2, *[0] * 8, 1] and list(
        falls_of([one], steps=2)
    ) == [*[0] * 9, 1]


def test_returns_are_averaged_over_windows_of_episodes():
    runs = [
        history(q_of(2), [-100.0, -20.0, -13.0, -13.0, -7.0]),
        history(q_of(2), [-60.0, -20.0, -15.0, -15.0, -7.0]),
    ]
    picture = plot_returns({"some": runs}, episodes=4, window=2)
    curve = picture.axes[0].lines[-1]
    np.testing.assert_allclose(curve.get_xdata(), [1, 3])
    np.testing.assert_allclose(curve.get_ydata(), [-50, -14])
    assert picture.finding == "Some ends at −14 an episode"
    with pytest.raises(ValueError, match="5 finished episodes, 6 are needed"):
        first_returns(runs, 6)


@pytest.mark.parametrize(("method", "wanted"), [("Q+EG", "edge"), ("SARSA+EG", "off")])
def test_q_learning_takes_the_edge_and_sarsa_does_not(method, wanted):
    runs = rl.repeat(
        cliff_model(), method, repetitions=10, episodes=1000, seed=7, n_jobs=1, r_max=1
    )
    assert counted(runs)[wanted] >= 8
