"""Lesson 07's figures: traces as the agent has them, and how far a reward has spread."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_07.figures import paid_by, plot_corridor, plot_paid, plot_trace, trace_curve
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.size import Size


@pytest.mark.parametrize("accumulating", [False, True])
def test_the_curve_of_a_trace_is_the_agents_own(accumulating):
    visits, gamma, lam = [2, 5, 6, 7, 20], 0.9, 0.8
    agent = Agent(Size((2,), 1), "SL+GREEDY", gamma=gamma, lam=lam, traces="full", accumulating=accumulating)
    agent.begin_episode(1)
    curve = trace_curve(visits, 30, gamma, lam, accumulating)
    for t in range(30):
        agent.learn_step(0 if t in visits else 1, 0, 0.0, 1, False)
        assert agent.e[0, 0] == pytest.approx(curve[t] * gamma * lam)  # the agent's has faded by then


def test_the_picture_of_a_trace_draws_both_kinds():
    picture = plot_trace([1, 3], steps=10, gamma=0.9, lam=0.5)
    accumulating, replacing, visits = (line.get_ydata() for line in picture.axes[0].lines)
    assert replacing.max() == 1.0
    assert accumulating.max() == pytest.approx(1 + 0.45**2)
    assert len(visits) == 2


def test_the_picture_of_the_corridor_shows_every_value_and_says_how_far_it_got():
    table = np.array([[0.0, 0.0, 9.0], [0.0, 8.1, 9.0]])
    picture = plot_corridor({"SARSA": table, "SARSA(λ)": table + 1}, "A title")
    assert [len(ax.texts) for ax in picture.axes] == [6, 6]


@pytest.mark.parametrize("lam", [0.0, 0.5, 0.9])
def test_what_all_steps_have_paid_together_is_q(lam):
    agent = rl.Agent("worked_example", "SL+SR", lam=lam, seed=0, loop_evasion=False)
    steps = list(rl.steps(agent, rl.make_env("worked_example", seed=0), 30))
    paid = sum(paid_by(steps, t, "worked_example", lam) for t in range(30))
    np.testing.assert_allclose(paid, agent.q, atol=1e-12)


def test_the_map_of_who_was_paid_has_a_row_for_each_state_that_the_reward_reached():
    agent = rl.Agent("worked_example", "SL+SR", seed=0, loop_evasion=False)
    steps = list(rl.steps(agent, rl.make_env("worked_example", seed=0), 30))
    picture = plot_paid(steps, 19, "worked_example", (0, 0.9))
    reached = np.flatnonzero(paid_by(steps, 19, "worked_example", 0.9).any(axis=1))
    assert [int(label.get_text()) for label in picture.axes[0].get_yticklabels()] == reached.tolist()
