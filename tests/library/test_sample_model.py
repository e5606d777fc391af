"""Sample models: what they count, how they sample, plan, tell their weak points, and repeat themselves."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from hypothesis import given, settings
from hypothesis import strategies as st
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_edu.models.sample_model import UNSEEN
from rlrobot_edu.models.value_iteration import expected_outcomes

ROWS = [
    (0, 0, 5.0, 1, 0), (1, 1, 0.0, 0, 0), (0, 0, 5.0, 1, 0), (1, 1, -1.0, 0, 0), (0, 0, 0.0, 2, 0), (2, 0, 5.0, 2, 0),
    (2, 1, 5.0, 5, 1), (3, 0, 0.0, 4, 0), (4, 1, -1.0, 3, 0),
]  # fmt: skip


@given(st.integers(0, 2**32), st.integers(1, 300))
@settings(max_examples=30, deadline=None)
def test_a_model_counts_as_a_dictionary_would(seed, n):
    rng = np.random.default_rng(seed)
    rows = [
        (
            *rng.integers([6, 2]),
            rng.choice([-1.0, 0.0, 5.0]),
            rng.integers(6),
            int(rng.random() < 0.1),
        )
        for _ in range(n)
    ]
    model = rl.SampleModel.from_recording(recording_of(rows))
    counts = Counter((s, a, s_next, r, bool(end)) for s, a, r, s_next, end in rows)
    for s in range(6):
        for a in range(2):
            expected = {key[2:]: n for key, n in counts.items() if key[:2] == (s, a)}
            assert {
                (s_next, r, end): n for s_next, r, end, n in model.outcomes(s, a)
            } == expected
            assert model.pair_count[s, a] == sum(expected.values())
    assert model.count.sum() == n


def test_the_model_of_the_papers_recording_has_the_counts_its_authors_file_has(vrep):
    model = rl.SampleModel.from_recording(vrep)
    report = model.diagnose()
    triples = set(zip(model.pair.tolist(), model.s_next.tolist(), strict=True))
    assert (report.states_seen, report.pairs_seen, len(triples)) == (298, 1691, 4294)
    assert report.pairs_seen_once == 478
    assert report.mean_reward == pytest.approx(3.36995, abs=5e-6)
    on_itself = [
        loop for loop in report.loops if len(loop.states) == 1 and loop.reward == 10
    ]
    assert len(on_itself) == 13 and sum(loop.samples == 1 for loop in on_itself) == 12
    by_reward = {r: int(model.count[model.r == r].sum()) for r in model.rewards}
    assert by_reward == {-10.0: 0, -2.0: 1555, -0.02: 10048, 10.0: 6397}
    assert model.starts.tolist() == [1023]


@pytest.mark.parametrize("unseen", UNSEEN)
def test_outcomes_are_drawn_as_often_as_planning_expects(unseen):
    model = rl.SampleModel.from_recording(recording_of(ROWS), unseen=unseen)
    expected = expected_outcomes(model)
    env = rl.make_env(model, seed=0)
    env.reset()
    n = 4000
    for s in range(6):
        for a in range(2):
            landed, rewards = np.zeros(6), 0.0
            for _ in range(n):
                env.state = s
                _, r, terminated, _, info = env.step(a)
                landed[info["state"]] += not terminated
                rewards += r
            pair = s * 2 + a
            probability = (
                expected.transitions[[pair]].toarray()[0] + expected.anywhere[pair] / 6
            )
            np.testing.assert_allclose(landed / n, probability, atol=0.035)
            assert rewards / n == pytest.approx(expected.reward[pair], abs=0.2)


def test_siblings_lend_their_outcomes_to_a_pair_that_was_never_tried():
    model = rl.SampleModel.from_recording(
        recording_of([(0, 0, 5.0, 1, 0), (1, 1, 0.0, 3, 0)]), unseen="siblings"
    )
    env = rl.make_env(model, seed=0)
    env.reset()
    for s in (
        1,
        2,
        3,
    ):  # the states of shape (2, 3) that share one of the two inputs with state 0
        env.state = s
        assert env.step(0)[1] == 5.0 and env.state == 1
    env.state = 4  # shares none with 0, so anything goes
    assert {env.step(0)[1] for env.state in [4] * 200} == {-1.0, 0.0, 5.0}


def test_an_unknown_policy_for_the_unseen_is_refused():
    with pytest.raises(
        ValueError,
        match=r"unseen pairs called 'guess'\. It has: uniform, stay, siblings$",
    ):
        rl.SampleModel.from_recording(recording_of(ROWS), unseen="guess")


def test_a_model_that_no_memory_could_hold_is_refused():
    with pytest.raises(
        ValueError, match="4,294,967,296 states × 2 actions are too many for a table"
    ):
        rl.SampleModel.from_recording(recording_of(ROWS, shape=(2**16, 2**16)))


def test_only_a_recording_makes_a_model():
    with pytest.raises(ValueError, match="a sample model is made from a Recording"):
        rl.SampleModel.from_recording("wander_1k")


@pytest.mark.parametrize("unseen", UNSEEN)
@pytest.mark.parametrize("gamma", [0.0, 0.5, 0.9])
def test_value_iteration_solves_the_bellman_equation(unseen, gamma):
    model = rl.SampleModel.from_recording(recording_of(ROWS), unseen=unseen)
    plan = rl.value_iteration(model, gamma)
    expected = expected_outcomes(model)
    dense = expected.transitions.toarray() + expected.anywhere[:, None] / 6
    # Evaluate the greedy policy exactly, by a linear solve: it must have the value V*, and no action may beat it.
    pairs = np.arange(6) * 2 + plan.policy
    v = np.linalg.solve(np.eye(6) - gamma * dense[pairs], expected.reward[pairs])
    np.testing.assert_allclose(plan.v, v, atol=1e-7)
    np.testing.assert_allclose(
        plan.q, (expected.reward + gamma * dense @ v).reshape(6, 2), atol=1e-7
    )
    assert (plan.q.max(axis=1) <= v + 1e-7).all()


def test_learning_approaches_what_planning_computed():
    rng = np.random.default_rng(0)
    rows = [
        (s, a, rng.choice([-1.0, 0.0, 5.0]), rng.integers(6), 0)
        for s in range(6)
        for a in range(2)
        for _ in "ab"
    ]
    model = rl.SampleModel.from_recording(recording_of(rows))
    plan = rl.value_iteration(model)
    agent = rl.Agent(model, "Q+RANDOM", alpha=0.01, seed=0)
    rl.learn(agent, rl.make_env(model, seed=1), steps=400_000, progress=False)
    np.testing.assert_allclose(agent.q, plan.q, atol=1.5)
    chosen = plan.q[np.arange(6), agent.policy]
    np.testing.assert_allclose(chosen, plan.v, atol=0.5)


def test_loops_that_rest_on_few_samples_are_found():
    rows = (
        [(0, 0, 5.0, 0, 0)]
        + [(1, 0, 5.0, 2, 0), (2, 1, 5.0, 1, 0)]
        + [(3, 0, 5.0, 3, 0)] * 50
    )
    rows += [(4, 0, -1.0, 4, 0), (5, 0, -1.0, 0, 0), (5, 0, -1.0, 0, 1)] + [
        (5, 1, 0.0, 5, 0)
    ] * 60
    report = rl.SampleModel.from_recording(recording_of(rows)).diagnose()
    assert [loop.pairs for loop in report.loops] == [((0, 0),), ((1, 0), (2, 1))]
    assert report.loops[1].samples == 2 and report.loops[1].reward == 5.0
    assert "seen only once" in str(report)


def test_a_model_comes_back_from_its_file_as_it_was(tmp_path):
    model = rl.SampleModel.from_recording(recording_of(ROWS), unseen="stay")
    model.save(tmp_path / "model.npz")
    loaded = rl.SampleModel.load(tmp_path / "model.npz")
    for name, value in vars(model).items():
        np.testing.assert_array_equal(getattr(loaded, name), value)
    (tmp_path / "model.npz").write_bytes((tmp_path / "model.npz").read_bytes()[:300])
    with pytest.raises(ValueError, match=r"model\.npz"):
        rl.SampleModel.load(tmp_path / "model.npz")


def test_a_model_remembers_the_task_of_its_recording_and_its_file_does_not(
    wander_model, tmp_path
):
    task, path = wander_model.task, tmp_path / "model.npz"
    assert task.name == "wander_1k" and rl.Agent(wander_model).task is task
    assert rl.SampleModel.from_recording(recording_of(ROWS)).task is None
    wander_model.save(path)
    loaded = rl.SampleModel.load(path)
    assert loaded.task is None and replace(loaded, task=task).task is task


def test_a_model_is_a_good_gymnasium_environment(wander_model):
    check_env(rl.make_env(wander_model, seed=0), skip_render_check=True)


def test_memory_grows_with_what_was_seen_not_with_states_squared(wander_model):
    arrays = [
        value for value in vars(wander_model).values() if isinstance(value, np.ndarray)
    ]
    per_outcome = sum(
        a.nbytes for a in arrays if len(a) == len(wander_model.s_next)
    ) / len(wander_model.s_next)
    assert per_outcome <= 40
    assert sum(a.nbytes for a in arrays) < 1e6


def test_repetitions_do_not_depend_on_the_number_of_jobs(wander_model):
    one, two = (
        rl.repeat(wander_model, repetitions=6, steps=200, seed=5, n_jobs=n)
        for n in (1, 2)
    )
    assert [h.rewards.tolist() for h in one] == [h.rewards.tolist() for h in two]
    assert len({h.rewards.tobytes() for h in one}) == 6
