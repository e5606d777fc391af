"""Lesson 08's forward view and figures: against the project's own oracle, and in closed form."""

import numpy as np
import pytest
from oracles import online_lambda_return as oracle
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_course.lesson_08.figures import (
    plot_credit,
    plot_one_pair,
    plot_over_alpha,
    plot_traces,
    trace_over_time,
    weights,
)
from rlrobot_course.lesson_08.forward_view import TRACES, online_lambda_return, replay
from rlrobot_course.lesson_08.q_old_figure import plot_q_old
from rlrobot_edu.learning.size import Size

DRIVE = [(0, 0, 10.0, 0, 0, False)] * 8 + [(0, 0, -2.0, 1, 0, False)]


def journey(seed):
    """A world, and one episode in it that ends in a terminal state."""
    world = RandomWorld(seed=seed, p_end=0.05)
    steps = []
    for x in rl.steps(rl.Agent(world, "Q+RANDOM", seed=seed), world, steps=500):
        steps.append((x.s, x.a, x.r, x.s_next, x.a_next or 0, x.terminated))
        if x.terminated:
            return world, steps[-40:]
    raise AssertionError("the episode never ended")


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("lam", [0.0, 0.7, 1.0])
def test_the_ideal_equals_the_projects_oracle_at_every_step(seed, lam):
    world, steps = journey(seed)
    mine = online_lambda_return(steps, np.zeros((world.n_states, 3)), 0.4, 0.9, lam)
    for q, q_oracle in zip(
        mine, oracle(steps, world.n_states, 3, 0.4, 0.9, lam), strict=True
    ):
        np.testing.assert_allclose(q, q_oracle, rtol=0, atol=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_only_true_online_sarsa_has_no_error(seed):
    world, steps = journey(seed)
    ideal = list(
        online_lambda_return(steps, np.zeros((world.n_states, 3)), 0.4, 0.9, 0.9)
    )

    def error(trace):
        agents = replay(trace, steps, world, alpha=0.4, traces="full")
        return max(
            np.abs(agent.q - q).max() for agent, q in zip(agents, ideal, strict=True)
        )

    worst = {trace: error(trace) for trace in TRACES}
    assert worst["dutch"] < 1e-12
    assert min(worst["accumulating"], worst["replacing"]) > 1e-3


@pytest.mark.parametrize("alpha", [0.1, 0.5])
def test_the_traces_of_a_pair_that_is_visited_at_every_step_climb_to_their_limits(
    alpha,
):
    limits = {
        "accumulating": 1 / (1 - 0.81),
        "replacing": 1.0,
        "dutch": 1 / (1 - (1 - alpha) * 0.81),
    }
    for trace, limit in limits.items():
        e = trace_over_time(trace, [True] * 100, alpha)
        assert e[0] == pytest.approx(1.0)
        assert e[-1] == pytest.approx(limit)
    left_alone = trace_over_time("dutch", [True, False, False], alpha)
    assert left_alone == pytest.approx([1, 0.81, 0.81**2])


def test_the_pictures_draw_what_was_computed():
    picture = plot_one_pair(DRIVE, "accumulating", "dutch", alpha=0.5)
    ideal, accumulating, dutch = (
        line.get_ydata() for line in picture.axes[0].lines[:3]
    )
    np.testing.assert_allclose(dutch, ideal, atol=1e-10)
    assert ideal[1] == pytest.approx(12.686, abs=1e-3)  # by hand in lesson 08
    assert accumulating[-1] < -90
    assert picture.finding == "Accumulating traces end at −95, the ideal at 10"


def test_the_picture_of_the_noted_value_has_the_numbers_of_the_lesson():
    picture = plot_q_old()
    texts = " ".join(text.get_text() for ax in picture.axes for text in ax.texts)
    for number in ("4.05", "4.5", "0.45", "5.00", "6.82", "5.18"):
        assert number in texts
    assert "5.18 in place of 6.82" in picture.finding


def test_the_picture_of_the_three_traces_draws_each_and_the_limit():
    accumulating, replacing, dutch, _, limit = (
        line.get_ydata() for line in plot_traces([True] * 9, 0.5).axes[0].lines
    )
    assert accumulating[-1] == pytest.approx(4.473, abs=1e-3) and replacing[
        -1
    ] == pytest.approx(1)
    assert max(dutch) < limit[0] == 2


def test_the_finding_names_the_traces_that_overshoot():
    seldom = [True] + [False] * 8
    assert plot_traces(seldom, 0.5).finding == "No trace makes α · e exceed 1"
    often = plot_traces([True] * 9, 0.5).finding
    assert often.startswith("Only accumulating traces make α · e exceed 1: up to 2.2")


def test_the_finding_names_the_best_and_the_worst_traces():
    rewards = {
        "accumulating": np.array([[5.0, 6.0], [1.0, 2.0]]),
        "dutch": np.array([[4.0, 5.0], [7.0, 8.0]]),
    }
    assert plot_over_alpha([0.1, 0.5], rewards).finding == (
        "At α = 0.5, true online traces earn most, 7.50 a step; accumulating ones 1.50"
    )


@pytest.mark.parametrize("trace", TRACES)
def test_the_traces_in_the_figures_are_the_agents_own(trace):
    visits, alpha, lam = [True, True, False, True, False, False, True], 0.3, 0.7
    agents = replay(
        trace,
        [(int(not there), 0, 0.0, 1, 0, False) for there in visits],
        Size((2,), 1),
        alpha=alpha,
        lam=lam,
        traces="full",
    )
    mine = trace_over_time(trace, visits, alpha, lam)
    assert mine == pytest.approx([agent.e[0, 0] / (0.9 * lam) for agent in agents])
    nearly_0 = trace_over_time(trace, visits, alpha, 1e-9)  # so λ = 0 is no other case
    assert trace_over_time(trace, visits, alpha, 0) == pytest.approx(nearly_0, abs=1e-8)


@pytest.mark.parametrize("name", [*TRACES, "ideal"])
def test_the_weights_of_the_rewards_make_up_the_value_after_each_step(name):
    shown, rewards = (
        weights(name, DRIVE, alpha=0.5),
        np.array([r for _, _, r, *_ in DRIVE]),
    )
    if name == "ideal":
        values = [
            q[0, 0]
            for q in online_lambda_return(DRIVE, np.zeros((2, 1)), 0.5, 0.9, 0.9)
        ]
    else:
        values = [
            agent.q[0, 0].item()
            for agent in replay(name, DRIVE, Size((2,), 1), alpha=0.5)
        ]
    np.testing.assert_allclose(shown @ rewards, values, atol=1e-12)
    assert not np.triu(shown, 1).any(), "nobody pays before it is paid"
    newest = trace_over_time(
        "dutch" if name == "ideal" else name, [True] * 9, alpha=0.5
    )
    np.testing.assert_allclose(np.diag(shown), 0.5 * newest)


def test_the_map_of_true_online_sarsa_is_that_of_the_ideal():
    np.testing.assert_allclose(
        weights("dutch", DRIVE, 0.5), weights("ideal", DRIVE, 0.5), atol=1e-12
    )
    picture = plot_credit(DRIVE, "accumulating", "dutch", "ideal", alpha=0.5)
    assert len(picture.axes[0].patches) == 9 * 10 // 2
