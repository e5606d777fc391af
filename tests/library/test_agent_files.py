"""An agent that can be saved can be loaded, and goes on as if nothing had been; another one is refused when saved."""

import warnings
import zipfile
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu import files

METHODS = ("SL+SR", "TOSL+QBIASSR", "Q+EG", "SARSA+SR", "ESARSA+SR")
AS_GIVEN = (
    float,
    np.float32,
    np.longdouble,
    Fraction,
)  # kinds of numbers that a learner may have at hand
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
    return [array.tobytes() for array in (agent.q, agent.visits)]


def lived_anew(agent, steps):
    """After the beginning of an episode, also the traces and the last selection."""
    agent.begin_episode(0)
    return [
        *lived(agent, steps),
        agent.e.tobytes(),
        agent.probabilities.tobytes(),
        agent.rng.random(),
    ]


@pytest.mark.long
@given(st.sampled_from(METHODS), CHANGES, STEPS)
@example("Q+EG", {"alpha": Fraction(1, 3)}, [])
@example("TOSL+QBIASSR", {"alpha": 1.0}, [(0, 0, 1e100, 0, False)] * 12)
@settings(max_examples=60, deadline=None)
def test_a_saved_agent_comes_back_and_its_next_episode_is_the_same_bit_for_bit(
    tmp_path_factory, method, changes, steps
):
    path = tmp_path_factory.mktemp("agents") / "agent.npz"
    agent = rl.Agent("wander_simple", method, seed=0)
    try:
        agent.change(**changes)
    except ValueError as error:
        assert "\n" not in str(error)
    with np.errstate(all="ignore"):
        now = lived(agent, steps)
    try:
        agent.save(path)
    except ValueError as error:
        assert "nothing was saved" in str(error) and not path.exists()
        return
    loaded = rl.Agent.load(path)
    assert loaded.parameters == agent.parameters and lived(loaded, []) == now
    with np.errstate(all="ignore"):
        assert lived_anew(loaded, steps) == lived_anew(agent, steps)


def test_an_agent_too_large_for_a_file_keeps_the_file_that_it_had(
    tmp_path, monkeypatch
):
    agent, path = rl.Agent("wander_simple", seed=0), tmp_path / "agent.npz"
    agent.save(path)
    monkeypatch.setattr(files, "LARGEST", 5000)
    with pytest.raises(ValueError, match=r"agent\.npz: this agent is larger"):
        rl.Agent("wander_1k").save(path)
    monkeypatch.undo()
    assert rl.Agent.load(path).q.shape == agent.q.shape


def test_an_agent_whose_values_have_no_end_keeps_the_file_that_it_had(tmp_path):
    agent, path = (
        rl.Agent("wander_simple", "TOSL+SR", alpha=1, seed=0),
        tmp_path / "agent.npz",
    )
    agent.save(path)
    agent.q[0, 0] = 1e308
    with pytest.raises(
        ValueError,
        match="an action value is not finite or exceeds 1e300",
    ):
        agent.save(path)
    assert rl.Agent.load(path).visits.sum() == 0


@pytest.mark.parametrize("number", [Fraction(1, 3), np.longdouble("0.1"), "0.1", 1j])
def test_a_parameter_that_no_file_can_keep_is_refused_at_once(number):
    with pytest.raises(ValueError, match="alpha must be a number"):
        rl.Agent("wander_simple", alpha=number)


@pytest.mark.parametrize("packed", [True, False])
def test_a_file_that_would_be_too_large_to_read_is_not_written(
    tmp_path, monkeypatch, packed
):
    array, path = np.random.default_rng(0).random(50_000), tmp_path / "file.npz"
    monkeypatch.setattr(
        files, "LARGEST", array.nbytes + 300
    )  # room for the numbers, and for nothing around them
    with pytest.raises(ValueError, match="larger than a file may be"):
        files.save_arrays(path, "agent", {}, {"array": array}, packed)
    monkeypatch.setattr(files, "LARGEST", round(1.001 * array.nbytes) + 3000)
    files.save_arrays(path, "agent", {}, {"array": array}, packed)
    assert np.array_equal(
        files.load_arrays(path, "agent", lambda about, arrays: arrays["array"]), array
    )


def test_a_file_with_two_arrays_of_one_name_is_refused(tmp_path):
    """Else one of them would count, and nobody would know which."""
    one, other = tmp_path / "one.npz", tmp_path / "other.npz"
    agent = rl.Agent("worked_example", "Q+EG", seed=0)
    agent.save(one)
    agent.learn_step(0, 0, 1.0, 1, False)
    agent.save(other)
    with zipfile.ZipFile(other) as second, zipfile.ZipFile(one, "a") as first:
        for name in second.namelist():
            with warnings.catch_warnings(action="ignore"):  # zipfile's own
                first.writestr(name, second.read(name))
    with pytest.raises(ValueError, match="it holds two arrays of one name"):
        rl.Agent.load(one)


def test_a_method_may_be_given_by_its_name_and_another_one_is_told(tmp_path):
    path = tmp_path / "agent.npz"
    rl.Agent("wander_simple", "Q+SR").save(path)
    assert rl.Agent.load(path, "Q+SR").method.name == "Q+SR"
    with pytest.raises(ValueError, match="not the one that was given"):
        rl.Agent.load(path, "SARSA+SR")
    with pytest.raises(ValueError, match="unknown method 'Q\\+RS'"):
        rl.Agent.load(path, "Q+RS")


def test_a_frozen_copy_shares_nothing_and_is_not_saved(tmp_path):
    agent = rl.Agent("wander_simple", "Q+SR", planner="dyna", seed=0)
    agent.learn_step(0, 0, 1.0, 1, False)
    still = agent.frozen()
    still.learn_step(0, 0, -1.0, 1, False)
    assert still.experience is None and agent.experience.tries.sum() == 1
    assert agent.visits.sum() == 1 and np.array_equal(still.q, agent.q)
    path = tmp_path / "agent.npz"
    with pytest.raises(ValueError, match="save the agent itself"):
        still.save(path)
    assert not path.exists()
