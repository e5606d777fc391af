"""Credit: the same kernels on numbers that remember their rewards; sums, bits and finite differences agree."""

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_19.credit import credit as credit_in
from rlrobot_course.lesson_19.linear import Linear, plain

METHODS = [("TOSL+QBIASSR", {}), ("TOSL+SR", {"traces": "full", "alpha": 0.6}), ("SL+SR", {}), ("SARSA+SR", {}),
           ("SL+SR", {"accumulating": True}), ("ESARSA+EG", {"epsilon": 0.3}), ("Q+SR", {})]  # fmt: skip


def credit_of(method, steps=200, seed=1, **settings):
    agent = rl.Agent("worked_example", method, seed=seed, **settings)
    return agent, credit_in(agent, rl.make_env("worked_example", seed=seed), steps)


def every(agent):
    return np.ndindex(*agent.q.shape)


@pytest.mark.parametrize(("method", "settings"), METHODS)
def test_the_shares_sum_to_each_value_and_nothing_else_is_learned(method, settings):
    agent, credit = credit_of(method, **settings)
    other = rl.Agent("worked_example", method, seed=1, **settings)
    rl.learn(other, rl.make_env("worked_example", seed=1), 200, progress=False)
    np.testing.assert_array_equal(agent.q, other.q)
    np.testing.assert_array_equal(credit.q, other.q)
    values = [getattr(made, "value", made) for made in credit._made_of.flat]
    np.testing.assert_array_equal(
        np.reshape(np.array(values, float), agent.q.shape), agent.q
    )  # to the last bit
    for s, a in every(agent):
        assert credit.shares(s, a).sum() == pytest.approx(agent.q[s, a], abs=1e-12)


def lived_again(agent, steps, rewards):
    """What an agent knows after the same steps with other rewards; its probabilities are those of then."""
    previous = None
    for step, r in zip(steps, rewards, strict=True):
        if previous is None or previous.terminated or previous.truncated:
            agent.begin_episode(step.s)
        agent.update(
            step.s,
            step.a,
            r,
            step.s_next,
            -1 if step.a_next is None else step.a_next,
            step.terminated,
        )
        previous = step
    return agent.q


@pytest.mark.parametrize(
    ("method", "settings"), [one for one in METHODS if one[0][:2] not in ("ES", "Q+")]
)
def test_the_weights_are_the_derivatives(method, settings):
    _, credit = credit_of(method, steps=60, **settings)
    for t in (0, 17, 42, 59):
        bumped = credit.rewards.copy()
        bumped[t] += 1.0
        after, before = (
            lived_again(
                rl.Agent("worked_example", method, seed=1, **settings), credit.steps, r
            ).copy()
            for r in (bumped, credit.rewards)
        )
        weights = [credit.weights(s, a)[t] for s, a in np.ndindex(*credit.q.shape)]
        np.testing.assert_allclose((after - before).ravel(), weights, atol=1e-12)


def test_what_an_agent_knew_before_is_of_no_reward_and_an_episodes_end_forgets_traces():
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)
    agent = rl.Agent(lake, "SL+SR", seed=25, loop_evasion=False)
    agent.q[:] = 0.5
    lake.reset(seed=0)
    credit = credit_in(agent, lake, 100)
    for (s, a), made in np.ndenumerate(credit._made_of):
        value = getattr(made, "value", made)
        assert value == pytest.approx(agent.q[s, a], abs=1e-12)
    s, a = np.argwhere(agent.visits == 0)[0].tolist()  # never tried, so nobody paid
    assert not credit.shares(s, a).any()


def test_why_names_the_steps_that_made_the_difference():
    _, credit = credit_of("SL+SR")
    parted = credit.shares(13, 1) - credit.shares(13, 0)
    told = credit.why(13, 1, 0)
    t = int(np.argmax(np.abs(parted)))
    apart = credit.q[13, 1] - credit.q[13, 0]
    assert told.startswith(
        f"Q(13, 1) − Q(13, 0) = {apart:+.3g}. Most of it: step {t + 1} ("
    )
    assert "no reward yet" in credit.why(0, 1, 1)


def test_by_hand_two_steps_of_sarsa_lambda():
    """Cell 8 learns 0.81 of what cell 9 does: lesson 07's table."""
    world = rl.Agent("worked_example", "SL+SR", seed=0)
    m = [Linear(2.0, np.array([1.0, 0.0])), Linear(3.0, np.array([0.0, 1.0]))]
    total = 1 - (m[0] * 0.5 + m[1]) + 2.0
    assert total.value == -1.0 and total.weights.tolist() == [-0.5, -1.0]
    assert max(m) is m[1] and m[0] < 2.5 and m[0] == 2.0 and m[1] >= m[0]
    with pytest.raises(TypeError, match="no exact credit"):
        m[0] * m[1]
    assert plain(len) is len and callable(plain(world.method.algorithm.update))


def test_who_plans_and_a_state_that_does_not_exist_are_refused():
    env = rl.make_env("worked_example", seed=0)
    with pytest.raises(ValueError, match="do not plan"):
        credit_in(rl.Agent("worked_example", "Q+SR", planner="dyna", seed=0), env, 10)
    with pytest.raises(ValueError, match="there is no state 24"):
        credit_of("Q+SR", steps=3)[1].weights(24, 0)
