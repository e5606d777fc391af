"""The algorithms against independent versions of themselves."""

import math
from itertools import pairwise

import gymnasium
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import (
    NumpyLoopEvasion,
    NumpyModelWorld,
    numpy_bias,
    numpy_q_learning,
    numpy_softmax,
    online_lambda_return,
)
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_edu.learning.loop_evasion import watch_for_loops
from rlrobot_edu.learning.memory import trace_steps
from rlrobot_edu.learning.methods import ALGORITHMS
from rlrobot_edu.learning.selections.qbiassr import compute_bias
from rlrobot_edu.learning.selections.softmax import softmax


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("lam", [0.0, 0.6, 0.9, 1.0])
def test_tosl_with_full_traces_equals_the_online_lambda_return_at_every_step(seed, lam):
    world = RandomWorld(seed=seed, p_end=0.02)
    agent = rl.Agent(world, "TOSL+SR", lam=lam, alpha=0.3, traces="full", seed=seed)
    transitions, q_after = [], []
    for step in rl.steps(agent, world, steps=60):
        transitions.append(
            (step.s, step.a, step.r, step.s_next, step.a_next, step.terminated)
        )
        q_after.append(agent.q.copy())
        if step.terminated:
            break
    expected = online_lambda_return(transitions, world.n_states, 3, 0.3, 0.9, lam)
    for q, q_expected in zip(q_after, expected, strict=True):
        np.testing.assert_allclose(q, q_expected, rtol=0, atol=1e-10)


@pytest.mark.parametrize("selection", ["SR", "QBIASSR", "EG", "RANDOM"])
def test_expected_sarsa_weighs_each_next_value_with_the_probability_of_its_action(
    selection,
):
    world = RandomWorld(seed=2, p_end=0.05)
    agent = rl.Agent(world, f"ESARSA+{selection}", alpha=0.3, seed=4)
    q, walk = np.zeros((world.n_states, 3)), list(rl.steps(agent, world, steps=400))
    for step, following in pairwise(walk):
        # what the next step's action was drawn with is what this step's update expected of it
        v_next = 0.0 if step.terminated else following.probabilities @ q[step.s_next]
        delta = step.r + 0.9 * v_next - q[step.s, step.a]
        q[step.s, step.a] += 0.3 * delta
        assert step.delta == pytest.approx(delta, abs=1e-12)
    assert np.allclose(
        np.delete(agent.q, walk[-1].s, axis=0),
        np.delete(q, walk[-1].s, axis=0),
        atol=1e-12,
    )


def test_expected_sarsa_is_sarsa_on_average_over_the_next_action():
    world = RandomWorld(seed=1)
    expected = rl.Agent(world, "ESARSA+SR", seed=0)
    expected.q[:] = np.random.default_rng(0).normal(size=expected.q.shape)
    values = expected.q.copy()
    (step,) = rl.steps(expected, world, steps=1)
    p, deltas = expected.probabilities, []
    for a_next in range(3):
        sarsa = rl.Agent(world, "SARSA+SR")
        sarsa.q[:] = values
        deltas.append(sarsa.update(step.s, step.a, step.r, step.s_next, a_next, False))
    assert step.delta == pytest.approx(p @ deltas) and np.ptp(deltas) > 0.1


@pytest.mark.parametrize(
    "algorithm, accumulating", [("SL", False), ("SL", True), ("TOSL", False)]
)
def test_reduced_traces_equal_a_textbook_loop_that_drops_small_traces_and_those_of_old_states(
    algorithm, accumulating
):
    world = RandomWorld(shape=(5, 4, 4), seed=3)
    alpha, gamma, lam = 0.2, 0.8, 0.7
    agent = rl.Agent(
        world,
        f"{algorithm}+SR",
        alpha=alpha,
        gamma=gamma,
        lam=lam,
        accumulating=accumulating,
        seed=1,
    )
    n = math.floor(math.log(0.01) / math.log(gamma * lam))
    q, e, q_old, recent = np.zeros((80, 3)), np.zeros((80, 3)), 0.0, []
    left = 0
    for step in rl.steps(agent, world, steps=400):
        s, a = step.s, step.a
        recent = [s] + [x for x in recent if x != s]
        if len(recent) > n + 1:
            e[recent.pop()] = 0.0
            left += 1
        q_sa, q_next = q[s, a], q[step.s_next, step.a_next]
        delta = step.r + gamma * q_next - q_sa
        if algorithm == "SL":
            e[s, a] = e[s, a] + 1 if accumulating else 1.0
            q += alpha * delta * e
        else:
            e[s, a] = (1 - alpha) * e[s, a] + 1
            q += alpha * (delta + q_sa - q_old) * e
            q[s, a] -= alpha * (q_sa - q_old)
        e *= gamma * lam
        e[e < 0.01] = 0.0
        left += sum(not e[x].any() for x in recent)
        recent = [x for x in recent if e[x].any()]
        q_old = q_next
        assert step.delta == pytest.approx(delta, abs=1e-12)
        np.testing.assert_allclose(agent.q, q, rtol=0, atol=1e-12)
    assert left > 100  # the test did see states leave


def test_the_register_holds_21_states_for_the_papers_parameters():
    assert trace_steps(0.9, 0.9) == 21
    assert trace_steps(0.9, 0.0) == 0
    assert math.log(0.01) / math.log(0.81) == pytest.approx(21.85, abs=0.005)


@pytest.mark.parametrize("traces, smallest", [("reduced", 0.01), ("full", 1e-100)])
@pytest.mark.parametrize("algorithm", ["SL", "TOSL"])
def test_a_trace_is_above_its_threshold_or_gone_and_the_register_names_the_states_that_have_one(
    algorithm, traces, smallest
):
    world = RandomWorld(shape=(4, 10), seed=2)
    agent = rl.Agent(
        world, f"{algorithm}+SR", gamma=0.5, lam=0.4, traces=traces, seed=2
    )
    gone = 0
    for step in rl.steps(agent, world, steps=300):
        e, register = (
            agent.memory.e,
            agent.memory.register[: agent.memory.now.register_size],
        )
        assert ((e == 0) | (e >= smallest)).all()
        assert (
            sorted(register) == [s for s in range(40) if e[s].any()]
            and register[0] == step.s
        )
        gone += not e[step.s].all()
    assert gone > 100


def test_where_nothing_is_remembered_a_trace_lasts_for_its_step_alone():
    world = RandomWorld(seed=4)
    agents = [
        rl.Agent(world, method, lam=0.0, seed=4) for method in ("SL+SR", "SARSA+SR")
    ]
    for agent in agents:
        rl.learn(agent, RandomWorld(seed=4), steps=200, progress=False)
    assert not agents[0].memory.e.any() and agents[0].memory.now.register_size == 0
    np.testing.assert_array_equal(agents[0].q, agents[1].q)


def test_full_traces_reach_further_back_than_reduced_ones():
    finals = {}
    for traces in ("reduced", "full"):
        world = RandomWorld(shape=(10, 10), seed=0)
        agent = rl.Agent(world, "SL+RANDOM", traces=traces, seed=0)
        rl.learn(agent, world, steps=500, progress=False)
        finals[traces] = agent.q
    assert not np.array_equal(finals["reduced"], finals["full"])
    np.testing.assert_allclose(finals["reduced"], finals["full"], atol=0.05)


@given(
    st.integers(0, 2**32),
    st.lists(st.integers(1, 5), min_size=1, max_size=4),
    st.integers(1, 6),
)
@settings(max_examples=60, deadline=None)
def test_the_bias_is_the_mean_of_numpy_means_along_the_axes_of_q(
    seed, shape, n_actions
):
    rng = np.random.default_rng(seed)
    n_states = int(np.prod(shape))
    q, bias = rng.normal(size=(n_states, n_actions)), np.zeros(n_actions)
    s = int(rng.integers(n_states))
    compute_bias(q, np.array(shape), s, bias)
    np.testing.assert_allclose(bias, numpy_bias(q, tuple(shape), s), atol=1e-12)


def test_the_papers_example_of_24_states_number_by_number():
    task = rl.load_task("worked_example")
    assert (
        task.states.shape == (2, 2, 3, 2)
        and task.states.n == 24
        and task.actions.n == 3
    )

    def state(x, y, theta, d):
        return task.states.encode({"X": x, "Y": y, "theta": theta, "d": d})

    # Only these five states, which share at least three values with (1, 1, 90, T), may matter.
    values = {
        (1, 1, 90, 1): (0, 0, 0),
        (0, 1, 90, 1): (2, -4, 8),
        (1, 0, 90, 1): (6, 0, 2),
        (1, 1, 0, 1): (3, 9, -3),
        (1, 1, -90, 1): (-6, 3, 12),
        (1, 1, 90, 0): (4, 8, -2),
    }
    q = np.full((24, 3), 1000.0)
    for inputs, row in values.items():
        q[state(*inputs)] = row
    s = state(1, 1, 90, 1)
    families = {
        name: q[members].mean(axis=0)
        for name, members in task.states.siblings(s).items()
    }
    np.testing.assert_allclose(families["X"], (1, -2, 4))
    np.testing.assert_allclose(families["Y"], (3, 0, 1))
    np.testing.assert_allclose(families["theta"], (-1, 4, 3))
    np.testing.assert_allclose(families["d"], (2, 4, -1))
    bias = np.zeros(3)
    compute_bias(q, np.array(task.states.shape), s, bias)
    np.testing.assert_allclose(bias, (1.25, 1.5, 1.75))
    # Without the bias all three actions are alike; with it, the third leads: e^1.25, e^1.5 and e^1.75 of 13.56.
    p = np.zeros(3)
    softmax(q[s], 1.0, p)
    np.testing.assert_allclose(p, 1 / 3)
    softmax(q[s] + bias, 1.0, p)
    np.testing.assert_allclose(
        p, np.exp([1.25, 1.5, 1.75]) / (3.4903 + 4.4817 + 5.7546), atol=1e-4
    )


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=9), st.floats(0.01, 100))
@settings(deadline=None)
def test_softmax_sums_to_one_and_keeps_the_order_of_the_values(x, temperature):
    x, p = np.array(x), np.zeros(len(x))
    softmax(x, temperature, p)
    assert p.sum() == pytest.approx(1)
    assert (np.diff(p[np.argsort(x)]) >= 0).all()
    np.testing.assert_allclose(p, numpy_softmax(x, temperature), atol=1e-12)


def test_loop_evasion_sets_the_temperature_that_a_plain_list_says():
    rng = np.random.default_rng(0)
    agent = rl.Agent(RandomWorld(shape=(10, 10)), "TOSL+SR")
    plain = NumpyLoopEvasion(21, 1.0)
    temperatures = []
    for t in range(3000):
        few = (
            3 if t // 200 % 2 else 40
        )  # now and then the agent is caught among a few states
        s, r = int(rng.integers(few)), float(rng.choice([-10, -0.02, 2]))
        watch_for_loops(agent.memory, s, r)
        temperatures.append(float(agent.memory.now.temperature))
        assert temperatures[-1] == pytest.approx(plain(s, r), abs=1e-9)
    assert max(temperatures) == 50.0 and temperatures.count(1.0) > 1000


@pytest.mark.parametrize("n_states, length", [(4, 4), (24, 6), (1024, 21)])
def test_the_queue_of_loop_evasion_is_as_long_as_the_register_within_its_limits(
    n_states, length
):
    agent = rl.Agent(RandomWorld(shape=(n_states,)), "TOSL+SR")
    assert len(agent.memory.queue_states) == length


def test_q_learning_on_a_model_equals_the_plain_numpy_loop_that_benchmarks_race(
    wander_model,
):
    agent = rl.Agent(wander_model, "Q+SR", seed=7, loop_evasion=False)
    rl.learn(
        agent,
        rl.make_env(wander_model, seed=np.random.SeedSequence(11)),
        steps=3600,
        progress=False,
    )
    world = NumpyModelWorld(wander_model, np.random.default_rng(11))
    q = numpy_q_learning(world, 3600, np.random.default_rng(7))
    np.testing.assert_allclose(agent.q, q, atol=1e-9)


def test_a_terminal_step_does_not_bootstrap_and_a_truncated_one_does():
    class OneStep(gymnasium.Env):
        observation_space, action_space = (
            gymnasium.spaces.Discrete(2),
            gymnasium.spaces.Discrete(1),
        )

        def __init__(self, terminated):
            self.terminated = terminated

        def reset(self, *, seed=None, options=None):
            return 0, {}

        def step(self, a):
            return 1, 1.0, self.terminated, not self.terminated, {}

    for method in (f"{algorithm}+SR" for algorithm in ALGORITHMS):
        for terminated, delta in ((True, 1.0), (False, 1.0 + 0.9 * 5.0)):
            agent = rl.Agent(OneStep(terminated), method)
            agent.q[1] = 5.0
            (step,) = rl.steps(agent, OneStep(terminated), steps=1)
            assert step.delta == pytest.approx(delta), method
            assert agent.q[0, 0] == pytest.approx(0.1 * delta)
            assert (step.a_next is None) == terminated
