"""Values that grow without end are said when it happens, and nothing is written that cannot be read again."""

import math
from dataclasses import replace

import gymnasium
import numpy as np
import pytest
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_edu.learning.history import History

# Legal, and too much for traces that add up.
TOO_MUCH = {
    "accumulating": True,
    "alpha": 1.0,
    "lam": 1.0,
    "gamma": 0.999,
    "traces": "full",
}
SAID = r"Q has diverged: after [\d,]+ steps of SL\+EG .*take a smaller alpha"


def learn_compiled(agent, model):
    rl.learn(agent, rl.make_env(model, seed=0), 20_000, progress=False)


def learn_plainly(agent, model):
    env = gymnasium.Wrapper(rl.make_env(model, seed=0))
    rl.learn(agent, env, 20_000, progress=False)


def step_by_step(agent, model):
    for _ in rl.steps(agent, rl.make_env(model, seed=0), 20_000):
        pass


def record(agent, model):
    rl.record(agent, rl.make_env(model, seed=0), 20_000)


@pytest.mark.parametrize("drive", [learn_compiled, learn_plainly, step_by_step, record])
def test_values_without_end_are_said_when_it_happens(drive, wander_model):
    agent = rl.Agent(wander_model, "SL+EG", seed=0, **TOO_MUCH)
    with pytest.raises(ValueError, match=SAID):
        drive(agent, wander_model)
    # The plain loop notices it long before there are no numbers left.
    assert drive in (learn_compiled, record) or np.isfinite(agent.q).all()
    agent.q[0, 0] = math.nan
    with pytest.raises(ValueError, match="diverged"):
        rl.evaluate(agent, rl.make_env(wander_model), 10, progress=False)


def test_an_experiment_that_diverges_leaves_a_store_that_can_be_read(
    wander_model, tmp_path
):
    methods = {"sound": {"method": "Q+EG"}, "wild": {"method": "SL+EG", **TOO_MUCH}}
    with pytest.raises(ValueError, match=SAID):
        rl.compare(
            wander_model, methods, 1, steps=20_000, n_jobs=1, store=tmp_path, progress=False
        )  # fmt: skip
    assert list(rl.Comparison.load(tmp_path)) == ["sound"]


@pytest.mark.parametrize("world", ["wander_simple", "model", "random"])
@pytest.mark.parametrize(
    "method", ["Q+EG", "SARSA+SR", "ESARSA+GREEDY", "SL+SR", "SL+EG", "TOSL+QBIASSR"]
)
@pytest.mark.parametrize("alpha", [0.1, 1.0])
def test_sound_values_are_never_said_to_diverge(world, method, alpha, wander_model):
    named = {"model": wander_model, "wander_simple": "wander_simple"}
    env = rl.make_env(named[world], seed=0) if world in named else RandomWorld()
    agent = rl.Agent(env, method, alpha=alpha, seed=0)
    agent.q[:] = -50  # what was learned before, or is hoped for
    assert len(rl.learn(agent, env, 400, progress=False)) == 400


def history():
    env = RandomWorld()
    agent = rl.Agent(env, "Q+EG", seed=0)
    return rl.learn(agent, env, 20, keep=True, progress=False)


def with_column(name, number):
    """A history in which one number of a column is another one."""

    def changed(whole):
        part = "transitions" if name in whole.transitions._fields else "learned"
        column = getattr(getattr(whole, part), name).copy()
        column[1] = number
        its_part = getattr(whole, part)._replace(**{name: column})
        return replace(whole, **{part: its_part})

    return changed


UNREADABLE = {
    "a value that is no number": with_column("q", math.nan),
    "an endless value": with_column("q", -math.inf),
    "an endless reward": with_column("r", math.inf),
    "no such state": with_column("s", 10**6),
    "a negative action": with_column("a", -1),
    "no such pair": with_column("pair", 10**6),
    "no time": lambda whole: replace(whole, seconds=math.nan),
    "a method without a name": lambda whole: replace(whole, method=None),
    "an origin without a name": lambda whole: replace(whole, origin=7),
}


@pytest.mark.parametrize("change", UNREADABLE.values(), ids=UNREADABLE)
def test_a_history_that_could_not_be_read_is_not_written(change, tmp_path):
    path = tmp_path / "h.npz"
    with pytest.raises(ValueError, match=r"could not be read again; nothing was saved"):
        change(history()).save(path)
    assert not path.exists()
    history().save(path)
    assert len(History.load(path)) == 20
