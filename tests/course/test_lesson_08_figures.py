"""Lesson 08's forward view and figures: against the project's own oracle, and in closed form."""

import numpy as np
import pytest
from oracles import online_lambda_return as oracle
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_course.lesson_08.figures import (
    plot_credit,
    weights,
)
from rlrobot_course.lesson_08.forward_view import TRACES, online_lambda_return, replay
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
    # a new reward counts by the trace, which grows towards 1/(1 − 0.81), or for dutch ones 1/(1 − 0.5 · 0.81)
    kept = {"accumulating": 0.81, "replacing": 0}.get(name, 0.5 * 0.81)
    newest = [sum(kept**n for n in range(visits)) for visits in range(1, 10)]
    np.testing.assert_allclose(np.diag(shown), 0.5 * np.array(newest))


def test_the_map_of_true_online_sarsa_is_that_of_the_ideal():
    np.testing.assert_allclose(
        weights("dutch", DRIVE, 0.5), weights("ideal", DRIVE, 0.5), atol=1e-12
    )
    picture = plot_credit(DRIVE, "accumulating", "dutch", "ideal", alpha=0.5)
    assert len(picture.axes[0].patches) == 9 * 10 // 2
