"""Value iteration for any discount rate: against exact solutions, and in Gymnasium's own tables."""

import itertools

import gymnasium
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_edu.models.sample_model import UNSEEN
from rlrobot_edu.models.value_iteration import expected_outcomes

NEAR_1 = [0.99, 0.9999, 0.999999, 1 - 1e-9]


def random_model(seed, unseen, p_end, rows=20):
    rng = np.random.default_rng(seed)
    columns = (
        rng.integers(6, size=rows),
        rng.integers(2, size=rows),
        rng.choice([-1.0, 0.0, 5.0], rows),
    )
    s_next, end = rng.integers(6, size=rows), rng.random(rows) < p_end
    return rl.SampleModel.from_recording(
        recording_of(list(zip(*columns, s_next, end, strict=True))), unseen=unseen
    )


def best_of_all_policies(model, gamma):
    """V* as the largest value that any of the deterministic policies has, each solved for exactly."""
    expected, n, m = expected_outcomes(model), model.n_states, model.n_actions
    dense = expected.transitions.toarray() + expected.anywhere[:, None] / n
    values = []
    for policy in itertools.product(range(m), repeat=n):
        pairs = np.arange(n) * m + policy
        values.append(
            np.linalg.solve(np.eye(n) - gamma * dense[pairs], expected.reward[pairs])
        )
    return np.max(values, axis=0)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(
    st.integers(0, 10_000),
    st.sampled_from(UNSEEN),
    st.sampled_from([0.0, 0.3]),
    st.sampled_from(NEAR_1),
)
def test_a_plan_with_gamma_near_1_is_the_exact_one(seed, unseen, p_end, gamma):
    model = random_model(seed, unseen, p_end)
    plan, exact = rl.value_iteration(model, gamma), best_of_all_policies(model, gamma)
    np.testing.assert_allclose(
        plan.v, exact, rtol=1e-6, atol=1e-6 * max(1.0, np.abs(exact).max())
    )


def model_of(env_id, **options):
    """The table of one of Gymnasium's small worlds, whose outcomes are all equally likely, as a sample model."""
    env = gymnasium.make(env_id, **options).unwrapped
    n, m = int(env.observation_space.n), int(env.action_space.n)
    rows = [env.P[s][a] for s in range(n) for a in range(m)]
    outcomes = [outcome for row in rows for outcome in row]
    offsets = np.cumsum([0, *map(len, rows)])
    cumulative = np.concatenate([np.arange(1, len(row) + 1) for row in rows])
    s_next, r, terminated = (
        np.array([outcome[i] for outcome in outcomes]) for i in (1, 2, 3)
    )
    starts = np.flatnonzero(env.initial_state_distrib)
    return rl.SampleModel(
        (n,),
        m,
        offsets,
        s_next,
        r.astype(float),
        terminated.astype(bool),
        cumulative,
        starts,
        np.unique(r),
        "stay",
    )


# The undiscounted values are known: 13 steps along the cliff; the goal is reached with certainty in the large lake and
# with 14/17 in the small one; Taxi's mean over its 300 starts.
WORLDS = {
    ("CliffWalking-v1", ""): -13.0,
    ("FrozenLake-v1", "4x4"): 14 / 17,
    ("FrozenLake-v1", "8x8"): 1.0,
    ("Taxi-v4", ""): 7.93,
}


@pytest.mark.parametrize(("world", "undiscounted"), WORLDS.items())
def test_plans_in_textbook_worlds_approach_the_undiscounted_value_as_gamma_approaches_1(
    world, undiscounted
):
    env_id, map_name = world
    try:
        model = model_of(env_id, **({"map_name": map_name} if map_name else {}))
    except gymnasium.error.Error as error:
        pytest.skip(f"this Gymnasium has no {env_id}: {error}")
    missing = []
    for gamma in (0.99, 0.9999, 0.999999, 1):
        plan = rl.value_iteration(model, gamma)
        np.testing.assert_allclose(plan.q.max(axis=1), plan.v)
        assert 0 < plan.sweeps < 20_000
        missing.append(abs(plan.v[model.starts].mean() - undiscounted))
    assert missing == sorted(missing, reverse=True)
    assert missing[2] < 2e-4 and missing[3] < 1e-9


def test_gamma_1_is_refused_where_a_reward_comes_again_and_again():
    loop = [(0, 0, 5.0, 1, 0), (1, 0, -1.0, 0, 0), (1, 1, 5.0, 1, 1)]
    model = rl.SampleModel.from_recording(recording_of(loop), unseen="stay")
    with pytest.raises(
        ValueError, match="a gamma below 1 where an episode can go on for ever"
    ):
        rl.value_iteration(model, 1)
    rows = [(0, 0, -1.0, 0, 0), (0, 1, 5.0, 1, 1), (1, 0, 5.0, 1, 1)]
    costly = rl.SampleModel.from_recording(
        recording_of(rows, shape=(2, 1)), unseen="stay"
    )
    assert rl.value_iteration(costly, 1.0).q[0].tolist() == [4.0, 5.0]


def test_gamma_1_with_a_cost_that_never_ends_says_what_still_changes(monkeypatch):
    monkeypatch.setattr("rlrobot_edu.models.value_iteration.MOST_SWEEPS", 50)
    trap = [(0, 0, -1.0, 0, 0), (0, 1, -1.0, 0, 0), (1, 0, 5.0, 1, 1)]
    model = rl.SampleModel.from_recording(
        recording_of(trap, shape=(2, 1)), unseen="stay"
    )
    with pytest.raises(ValueError, match="a value still changes by 1 in sweep 50"):
        rl.value_iteration(model, 1)


@pytest.mark.parametrize("name", ["gamma", "tolerance"])
@pytest.mark.parametrize(
    "value", ["x", "0.5", [0.5], 1j, None, np.array([0.5, 0.5]), -1]
)
def test_what_is_no_discount_or_tolerance_is_refused_in_words(name, value):
    with pytest.raises(ValueError, match=f"{name} must be"):
        rl.value_iteration(random_model(0, "stay", 0.0), **{name: value})
