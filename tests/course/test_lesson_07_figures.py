"""Lesson 07's figures: traces as the agent has them, and how far a reward has spread."""

import numpy as np
import pytest

from rlrobot_course.lesson_07.figures import plot_corridor, plot_trace, trace_curve
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.size import Size


@pytest.mark.parametrize("accumulating", [False, True])
def test_the_curve_of_a_trace_is_the_agents_own(accumulating):
    visits, gamma, lam = [2, 5, 6, 7, 20], 0.9, 0.8
    agent = Agent(
        Size((2,), 1),
        "SL+GREEDY",
        gamma=gamma,
        lam=lam,
        traces="full",
        accumulating=accumulating,
    )
    agent.begin_episode(1)
    curve = trace_curve(visits, 30, gamma, lam, accumulating)
    for t in range(30):
        agent.learn_step(0 if t in visits else 1, 0, 0.0, 1, False)
        assert agent.e[0, 0] == pytest.approx(
            curve[t] * gamma * lam
        )  # the agent's has faded by then


def test_the_picture_of_a_trace_draws_both_kinds():
    picture = plot_trace([1, 3], steps=10, gamma=0.9, lam=0.5)
    accumulating, replacing, visits = (
        line.get_ydata() for line in picture.axes[0].lines
    )
    assert replacing.max() == 1.0
    assert accumulating.max() == pytest.approx(1 + 0.45**2)
    assert len(visits) == 2
    assert picture.finding == "Replacing stops at 1, accumulating adds up to 1.20"


def test_the_picture_of_the_corridor_shows_every_value_and_says_how_far_it_got():
    table = np.array([[0.0, 0.0, 9.0], [0.0, 8.1, 9.0]])
    picture = plot_corridor({"SARSA": table, "SARSA(λ)": table + 1})
    assert picture.finding == (
        "The reward reaches the first cell with SARSA not in 2 drives, with SARSA(λ) in 1 drive"
    )
    table[1, 0] = 7.0
    assert plot_corridor({"SARSA": table}).finding.endswith("with SARSA in 2 drives")
    assert [len(ax.texts) for ax in picture.axes] == [6, 6]
