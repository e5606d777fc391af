"""The picture of one entry of the Q table."""

import re

import pytest
from rlrobot_edu.course.lesson_02.one_value import plot_one_value

import rlrobot_edu as rl


def test_the_curve_ends_where_the_agent_ends_and_settings_share_their_experience():
    task = rl.load_task("worked_example")
    figure = plot_one_value(task, 0, 0, {"slow": {"alpha": 0.02}, "one": {"alpha": 1.0}}, "a title", steps=400)
    slow, fast = (line.get_ydata() for line in figure.axes[0].lines)
    agent = rl.Agent(task, "Q+RANDOM", seed=0, alpha=0.02)
    rl.learn(agent, rl.make_env(task, seed=0), steps=400, progress=False)
    assert slow[-1] == agent.q[0, 0]
    moved = [(curve[1:] != curve[:-1]).nonzero()[0].tolist() for curve in (slow, fast)]
    assert set(moved[1]) <= set(moved[0]), "a value that jumps to its target may stay there, but not the other way"
    assert float(re.search(r"slow: ([\d.]+)", figure.alt)[1]) == pytest.approx(slow[-1], abs=0.06)
