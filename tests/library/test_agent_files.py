"""An agent that can be saved can be loaded, and goes on as if nothing had been; another one is refused when saved."""

from contextlib import suppress
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu import files
from rlrobot_edu.learning import agent as agents
from rlrobot_edu.learning.planning import experience as experiences
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.validation import changing

METHODS = ("SL+SR", "TOSL+QBIASSR", "Q+EG", "SARSA+SR", "ESARSA+SR")
AS_GIVEN = (float, np.float32, np.longdouble, Fraction)  # kinds of numbers that a learner may have at hand
NUMBERS = {
    "alpha": st.floats(0.01, 1.5), "temperature": st.floats(-1, 60), "epsilon": st.floats(0, 1.5),
    "r_max": st.floats(-1, 100),
}  # fmt: skip
CHANGES = st.fixed_dictionaries(
    {},
    optional={name: st.builds(lambda x, kind: kind(x), numbers, st.sampled_from(AS_GIVEN))
              for name, numbers in NUMBERS.items()}
    | {"accumulating": st.booleans(), "loop_evasion": st.booleans(), "planning_steps": st.integers(-1, 5)},
)  # fmt: skip
STATES = st.integers(0, 3)  # four states and four actions
REWARDS = st.one_of(st.floats(-10, 10), st.sampled_from([1e99, -1e100, 1e100]))
STEPS = st.lists(st.tuples(STATES, STATES, REWARDS, STATES, st.booleans()), max_size=12)


def lived(agent, steps):
    for s, a, r, s_next, terminated in steps:
        agent.learn_step(s, a, r, s_next, terminated)
    return {name: array.tobytes() for name, array in changing(agent.memory).items()}


@pytest.mark.long
@given(st.sampled_from(METHODS), st.sampled_from([None, "dyna"]), CHANGES, STEPS)
@example("Q+EG", None, {"alpha": Fraction(1, 3)}, [])
@example("TOSL+QBIASSR", None, {"alpha": 1.0}, [(0, 0, 1e100, 0, False)] * 12)
@settings(max_examples=60, deadline=None)
def test_what_can_be_saved_comes_back_and_goes_on_bit_for_bit(tmp_path_factory, method, planner, changes, steps):
    path = tmp_path_factory.mktemp("agents") / "agent.npz"
    agent = rl.Agent("wander_simple", method, planner=planner, seed=0)
    try:
        agent.change(**changes)
    except ValueError as error:
        assert "\n" not in str(error)
    with np.errstate(all="ignore"):
        now = lived(agent, steps)
    try:
        agent.save(path)
    except ValueError as error:
        assert "could not be read again" in str(error) and not path.exists()
        return
    loaded = rl.Agent.load(path)
    assert loaded.parameters == agent.parameters and lived(loaded, []) == now
    with np.errstate(all="ignore"):
        assert lived(loaded, steps) == lived(agent, steps)


@pytest.mark.long
@given(st.integers(1, 4000), st.integers(1, 3), st.booleans(), st.floats(0.9, 0.9999), st.sampled_from([None, "dyna"]))
@settings(max_examples=60, deadline=None)
def test_an_agent_that_can_be_made_can_be_saved_whatever_it_learns(
    tmp_path_factory, states, actions, full, gamma, planner
):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(files, "LARGEST", 2**20 + 120_000)
        for module in (agents, experiences):
            patch.setattr(module, "MOST_OUTCOMES", 1000)
        settings = {"traces": "full" if full else "reduced", "gamma": gamma, "lam": 1.0, "planner": planner}
        try:
            agent = rl.Agent(Size((states,), actions), "TOSL+SR", **settings, planning_steps=1, seed=0)
        except ValueError as error:
            assert "no file would hold an agent of" in str(error) and 33_000 + 20 * states * actions > 80_000
            return
        rng = np.random.default_rng(0)
        with suppress(ValueError):  # a planner knows as much as it can
            for _ in range(1200):
                s, s_next = rng.integers(states, size=2).tolist()
                agent.learn_step(s, int(rng.integers(actions)), rng.normal(), s_next, False)
        assert agent.visits.sum() == (1000 if planner else 1200)
        path = tmp_path_factory.mktemp("agents") / "agent.npz"
        agent.save(path)
        assert np.array_equal(rl.Agent.load(path).q, agent.q)


@pytest.mark.parametrize(("shape", "planner"), [((10**7,), None), ((2_500_000,), "dyna")])
def test_an_agent_too_large_for_a_file_is_refused_before_it_learns(shape, planner):
    with pytest.raises(ValueError, match=r"no file would hold an agent of [\d,]+ pairs"):
        rl.Agent(Size(shape, 10**7 // shape[0]), planner=planner)


def test_an_agent_whose_values_have_no_end_keeps_the_file_that_it_had(tmp_path):
    agent, path = rl.Agent("wander_simple", "TOSL+SR", alpha=1, seed=0), tmp_path / "agent.npz"
    agent.save(path)
    agent.q[0, 0] = 1e308
    with pytest.raises(ValueError, match="q of this agent is out of range, so it could not be read again"):
        agent.save(path)
    assert rl.Agent.load(path).visits.sum() == 0


@pytest.mark.parametrize("number", [Fraction(1, 3), np.longdouble("0.1"), "0.1", 1j])
def test_a_parameter_that_no_file_can_keep_is_refused_at_once(number):
    with pytest.raises(ValueError, match="alpha must be a number"):
        rl.Agent("wander_simple", alpha=number)


@pytest.mark.parametrize("packed", [True, False])
def test_a_file_that_would_be_too_large_to_read_is_not_written(tmp_path, monkeypatch, packed):
    array, path = np.random.default_rng(0).random(50_000), tmp_path / "file.npz"
    monkeypatch.setattr(files, "LARGEST", array.nbytes + 300)  # room for the numbers, and for nothing around them
    with pytest.raises(ValueError, match="would not be read again"):
        files.save_arrays(path, "agent", {}, {"array": array}, packed)
    monkeypatch.setattr(files, "LARGEST", round(1.001 * array.nbytes) + 3000)
    files.save_arrays(path, "agent", {}, {"array": array}, packed)
    assert np.array_equal(files.load_arrays(path, "agent", lambda about, arrays: arrays["array"]), array)
