"""`rl.watch`: the view stands in the cell that runs it, and the agent learns as ever."""

import math
import sys
import time

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets import watching

pytest.importorskip("rlrobot_edu.show.in3d.visualizer", reason="needs meshcat")


def learner():
    return rl.Agent("wander_simple", "TOSL+SR", seed=0), rl.make_env(
        "wander_simple", seed=0
    )


@pytest.mark.parametrize("somebody_looks_on", [True, False])
def test_the_view_is_shown_while_it_learns_and_the_agent_learns_as_by_learn(
    monkeypatch, somebody_looks_on
):
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", str(int(somebody_looks_on)))
    agent, env = learner()
    shown = []
    monkeypatch.setattr(
        watching, "display", lambda view: shown.append((view, agent.visits.sum()))
    )
    film = rl.watch(agent, env, steps=150, speed=1000)
    alike, its_env = learner()
    rl.learn(alike, its_env, steps=150, progress=False)
    np.testing.assert_array_equal(agent.q, alike.q)
    view = rl.meshcat(env)
    assert (
        shown == [(view, 0 if somebody_looks_on else agent.visits.sum())]
        and len(film.rewards) == 100
    )
    assert (
        view.window.rewards[-100:] == film.rewards and len(view.window.rewards) == 150
    )


def test_it_goes_as_fast_as_it_is_told_and_waits_for_nobody(monkeypatch):
    monkeypatch.setattr(watching, "display", lambda view: None)
    monkeypatch.delenv("RLROBOT_EDU_PROGRESS", raising=False)
    start = time.monotonic()
    rl.watch(*learner(), steps=150, speed=1000)
    assert time.monotonic() - start > 0.149
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    start = time.monotonic()
    rl.watch(*learner(), steps=100, speed=1)
    assert time.monotonic() - start < 99


def test_it_refuses_what_cannot_be_watched():
    for wrong in (
        {"steps": 0},
        *({"steps": 5, "speed": speed} for speed in (0, -1, math.nan)),
    ):
        with pytest.raises(ValueError, match=r"steps must|speed must be above 0"):
            rl.watch(*learner(), **wrong)
    with pytest.raises(ValueError, match="no robot to look at"):
        rl.watch(rl.Agent("wander_simple"), gymnasium.make("FrozenLake-v1"), steps=5)


def test_where_nothing_can_be_served_the_steps_are_shown_once_they_are_done(
    monkeypatch,
):
    shown = []
    monkeypatch.setattr(watching, "display", shown.append)
    monkeypatch.setattr(sys, "platform", "emscripten")
    film = rl.watch(*learner(), steps=20)
    assert repr(shown[0]).startswith("Replay of 20 steps") and len(film.rewards) == 20
