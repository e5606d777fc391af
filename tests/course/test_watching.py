"""`rl.watch`: the view stands in the cell that runs it, and the agent learns as ever."""

import sys

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets import watching

pytest.importorskip("rlrobot_edu.show.in3d.views", reason="needs the extra view3d")


def learner():
    return rl.Agent("wander_simple", "TOSL+SR", seed=0), rl.make_env("wander_simple", seed=0)


def test_the_view_is_shown_before_the_first_step_and_the_agent_learns_as_by_learn(monkeypatch):
    shown = []
    agent, env = learner()

    def display(view):
        assert agent.visits.sum() == 0
        shown.append(view)

    monkeypatch.setattr(watching, "display", display)
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    film = rl.watch(agent, env, steps=150, speed=1000)
    alike, its_env = learner()
    rl.learn(alike, its_env, steps=150, progress=False)
    np.testing.assert_array_equal(agent.q, alike.q)
    assert [type(view).__name__ for view in shown] == ["LiveView"] and len(film.rewards) == 100
    watching.open_views.pop().close()


def test_one_view_at_a_time_is_open(monkeypatch):
    shown = []
    monkeypatch.setattr(watching, "display", shown.append)
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    for _ in range(2):
        rl.watch(*learner(), steps=3)
    shown[1].update(learner()[1].unwrapped.robot.scene())
    with pytest.raises(RuntimeError, match="this live view is closed"):
        shown[0].update(learner()[1].unwrapped.robot.scene())
    for wrong in ({"steps": 0}, {"steps": 5, "speed": 0}):
        with pytest.raises(ValueError, match=r"steps must|speed must"):
            rl.watch(*learner(), **wrong)
    watching.open_views.pop().close()


def test_where_nothing_can_be_served_the_steps_are_shown_once_they_are_done(monkeypatch):
    shown = []
    monkeypatch.setattr(watching, "display", shown.append)
    monkeypatch.setattr(sys, "platform", "emscripten")
    film = rl.watch(*learner(), steps=20)
    assert repr(shown[0]).startswith("Replay of 20 steps") and len(film.rewards) == 20
