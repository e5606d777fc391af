"""Other people's environments: their rewards, their limits, and the average reward that is the same by every route."""

import math
import warnings
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import (
    ClipReward,
    OrderEnforcing,
    TimeLimit,
    TransformObservation,
    TransformReward,
)
from hypothesis import given
from hypothesis import strategies as st
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.size import Size, time_limit


class Paying(gymnasium.Env):
    """Two squares and two actions; every step pays the same."""

    observation_space, action_space = (
        gymnasium.spaces.Discrete(2),
        gymnasium.spaces.Discrete(2),
    )

    def __init__(self, reward=1.0, terminated=False):
        self.reward, self.terminated = reward, terminated

    def reset(self, *, seed=None, options=None):
        return 0, {}

    def step(self, a):
        return int(a), self.reward, self.terminated, False, {}


def paid(reward, steps=30, **settings):
    """What an agent has learned where each step pays `reward`."""
    env = Paying(reward)
    agent = rl.Agent(env, "TOSL+EG", seed=0, **settings)
    return agent, rl.learn(agent, env, steps, progress=False)


KINDS = [
    np.float16, np.float32, np.float64, np.longdouble, np.int8, np.int64, np.uint8, np.array, Fraction, int,
    float, lambda x: np.array(np.float32(x)), lambda x: np.array(int(x)), lambda x: np.bool_(x > 0), lambda x: x > 0,
]  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("number", [1, -128, 0])
def test_a_reward_of_any_real_type_is_the_float_that_it_becomes(kind, number):
    if kind is np.uint8:
        number = abs(number)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        reward = kind(number)
        (agent, history), (other, same) = paid(reward), paid(float(reward))
    assert np.array_equal(agent.q, other.q) and np.array_equal(
        history.rewards, same.rewards
    )


@pytest.mark.parametrize(
    "reward",
    [
        *(kind(x) for kind in (float, np.float16, np.float32, np.float64, np.array, Decimal)
          for x in ("inf", "-inf", "nan") if kind is not np.array),
        np.array(math.nan), np.array(np.float32("inf")), np.longdouble("1e4000"), Decimal("sNaN"), Decimal("1e400"),
        10**400, Fraction(10**400), 1e308, -1e308, 1e101, "1", b"1", None, 1j, np.complex64(1), [1.0], np.array([1.0]),
        np.datetime64("2020"), object,
    ],
    ids=repr,
)  # fmt: skip
def test_a_reward_that_is_no_number_that_learning_can_bear_is_refused_in_one_sentence(
    reward,
):
    with (
        warnings.catch_warnings(),
        pytest.raises(ValueError, match="a reward must be a number, at least -1e"),
    ):
        warnings.simplefilter("error")
        paid(reward)


@given(
    reward=st.floats(-1e100, 1e100), gamma=st.sampled_from([0.0, 0.9, 1 - 1e-9]), alpha=st.sampled_from([0.1, 1.0]),
    lam=st.sampled_from([0.0, 0.9, 1.0]),
)  # fmt: skip
def test_whatever_reward_is_taken_every_number_stays_finite(
    reward, gamma, alpha, lam, tmp_path_factory
):
    agent, history = paid(reward, 200, gamma=gamma, alpha=alpha, lam=lam)
    path = tmp_path_factory.mktemp("finite")
    agent.save(path / "agent.npz"), history.save(path / "history.npz")
    rl.Agent.load(path / "agent.npz"), History.load(path / "history.npz")
    for numbers in (
        agent.q,
        agent.e,
        history.average_reward,
        history.average_reward**2,
        history.last_episode,
    ):
        assert np.isfinite(numbers).all()


def test_rewards_that_no_agent_could_bear_are_refused_in_recordings_models_and_tasks_too():
    for reward in (1e308, -1e308, math.inf):
        with pytest.raises(ValueError, match="finite number"):
            recording_of([(0, 0, reward, 1, False)], rewards=(reward, 1.0))
        with pytest.raises(ValueError, match="finite number"):
            replace(rl.load_task("wander_simple"), rewards=[reward, 1.0])
    model = rl.SampleModel.from_recording(
        recording_of([(0, 0, 1.0, 1, False)], rewards=(-1.0, 1.0))
    )
    with pytest.raises(ValueError, match="rewards does not fit this sample model"):
        replace(model, rewards=np.array([-1e308, 1.0]))
    with pytest.raises(
        ValueError,
        match="r_max must be between 1e-100 and 1e100",
    ):
        rl.Agent("wander_simple", r_max=1e308)


def test_numpys_truths_are_told_as_pythons_own():
    env = Paying(terminated=np.bool_(True))
    (step,) = rl.steps(rl.Agent(env), env, 1)
    assert step.terminated is True and step.truncated is False and type(step.r) is float


def test_an_observation_that_is_no_whole_number_is_called_so():
    env = gymnasium.wrappers.TransformObservation(
        Paying(), float, Paying.observation_space
    )
    with pytest.raises(
        ValueError, match=r"there is no bin 0\.0: bins are the integers 0 to 1"
    ):
        rl.learn(rl.Agent(env), env, 5, progress=False)


class OldStep(Paying):
    def step(self, a):
        return super().step(a)[:4]


class OldReset(Paying):
    def reset(self):
        return 0


@pytest.mark.parametrize("kind", [OldStep, OldReset])
def test_an_environment_that_answers_as_the_old_gym_is_told_what_to_do(kind):
    env = kind()
    with pytest.raises(
        ValueError,
        match=r"must return \d values, as in Gymnasium, .*GymV21CompatibilityV0",
    ):
        rl.learn(rl.Agent(env), env, 5, progress=False)


def test_an_environment_of_the_old_gym_itself_is_told_what_to_do():
    class Old:
        observation_space, action_space = Paying.observation_space, Paying.action_space
        reset, step = OldReset.reset, OldStep.step

    with pytest.raises(ValueError, match="GymV21CompatibilityV0"):
        rl.Agent(Old())
    with pytest.raises(ValueError, match="GymV21CompatibilityV0"):
        rl.learn(rl.Agent(Paying()), Old(), 5, progress=False)


@pytest.mark.parametrize("reward", ["x", math.nan, None])
def test_a_world_whose_largest_reward_is_no_number_is_refused(reward):
    world = Paying()
    world.r_max = reward
    if reward is None:
        rl.Agent(world)
    else:
        with pytest.raises(
            ValueError, match="r_max of a world must be a number, at least"
        ):
            rl.Agent(world, "Q+EG")


# ------------------------------------------------------------------------------------- episodes and their limits


def lake(limit=12):
    return gymnasium.make("FrozenLake-v1", is_slippery=False, max_episode_steps=limit)


def routes(env, path):
    """The world itself, its model, its model from files, and a model of what was recorded in the model."""
    agent = rl.Agent(env, "Q+RANDOM", seed=0)
    recording = rl.record(agent, env, steps=4000)
    recording.save(path)
    again = rl.read_recording(path)
    model, read = (
        rl.SampleModel.from_recording(r, unseen="stay") for r in (recording, again)
    )
    model.save(path / "model.npz")
    world = rl.make_env(rl.SampleModel.load(path / "model.npz"), seed=0)
    second = rl.SampleModel.from_recording(
        rl.record(rl.Agent(world, "Q+RANDOM", seed=1), world, 4000), unseen="stay"
    )
    return (
        env,
        *(rl.make_env(m, seed=0) for m in (model, read, second)),
        gymnasium.Wrapper(world),
    )


WORLDS = {
    "a lake": lake,
    "two limits, the inner one shorter": lambda: TimeLimit(lake(12), 30),
    "two limits, the outer one shorter": lambda: TimeLimit(lake(30), 12),
    "a task with episodes": lambda: rl.make_env("worked_example", seed=0),
    "such a task with a limit": lambda: TimeLimit(
        rl.make_env("worked_example", seed=0), 12
    ),
    "a task that goes on for ever": lambda: rl.make_env(
        replace(rl.load_task("worked_example"), episode_steps=None)
    ),
}


@pytest.mark.filterwarnings("ignore:.*has changed since")
@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
def test_a_world_has_the_same_episodes_and_the_same_average_reward_by_every_route(
    make, tmp_path
):
    worlds = routes(make(), tmp_path)
    first, *others = (
        rl.learn(
            rl.Agent(w, "Q+EG", r_max=1, seed=2), w, 400, keep=True, progress=False
        )
        for w in worlds
    )
    for history in others:
        assert history.size.episode_steps == first.size.episode_steps
        assert time_limit(worlds[0]) == time_limit(worlds[1]) == time_limit(worlds[3])
        if (
            first.size.n_states == 16
        ):  # the lake's states tell all, so a model of it is exact
            assert np.array_equal(history.s, first.s) and np.array_equal(
                history.terminated, first.terminated
            )
            assert np.array_equal(history.average_reward, first.average_reward)
            assert np.array_equal(history.last_episode, first.last_episode)


def test_the_limit_of_a_world_is_the_smallest_of_its_wrappers():
    assert time_limit(Paying()) is None and time_limit(OrderEnforcing(Paying())) is None
    assert (
        time_limit(OrderEnforcing(TimeLimit(OrderEnforcing(TimeLimit(Paying(), 5)), 9)))
        == 5
    )


# What wrappers change


class Tenth(gymnasium.Wrapper):
    """Pays a tenth, in a step of its own."""

    def step(self, action):
        observation, r, *rest = self.env.step(action)
        return observation, r / 10, *rest


class Counting(gymnasium.RewardWrapper):
    """Halves rewards, and counts them."""

    count = 0

    def reward(self, reward):
        self.count += 1
        return reward / 2


CHANGES = {
    "a tenth": (lambda env: TransformReward(env, lambda r: r / 10), lambda r: r / 10),
    "the other way round": (lambda env: TransformReward(env, lambda r: -r), lambda r: -r),
    "clipped": (lambda env: ClipReward(env, -1, 3), lambda r: min(max(r, -1), 3)),
    "twice wrapped": (
        lambda env: OrderEnforcing(ClipReward(TransformReward(env, lambda r: 2 * r), 0, 7)),
        lambda r: min(max(2 * r, 0), 7),
    ),
    "counted": (Counting, lambda r: r / 2),
    "as it was": (OrderEnforcing, lambda r: r),
}  # fmt: skip


@pytest.mark.parametrize("wrap, change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize("world", ["wander_simple", "model"])
def test_the_largest_reward_is_the_one_that_the_wrappers_let_through(
    world, wrap, change, wander_model
):
    env = wrap(rl.make_env(wander_model if world == "model" else world, seed=0))
    due = max(change(r) for r in rl.load_task("wander_simple").rewards)
    agent = rl.Agent(env, seed=0)
    assert agent.parameters.r_max == due
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        history = rl.learn(agent, env, 60, progress=False)
    assert history.size.r_max == due
    assert getattr(env, "count", 60) == 60


def test_a_wrapper_that_changes_rewards_by_itself_is_noticed_or_names_the_largest():
    env = Tenth(rl.make_env("wander_simple", seed=0))
    with pytest.warns(UserWarning, match="paid 1, which is none of the rewards"):
        rl.learn(rl.Agent(env, seed=0), env, 60, progress=False)
    env.r_max = 1.0
    agent = rl.Agent(env, seed=0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        history = rl.learn(agent, env, 60, progress=False)
    assert agent.parameters.r_max == history.size.r_max == 1.0


def test_a_reward_that_a_wrapper_cannot_change_is_refused_with_advice():
    env = TransformReward(rl.make_env("wander_simple"), math.log)
    with pytest.raises(ValueError, match=r"cannot change the reward .*attribute r_max"):
        rl.Agent(env)
    env.r_max = 3.0
    assert rl.Agent(env).parameters.r_max == 3.0


@pytest.mark.parametrize("limit", [5, 12, 1000])
def test_an_episode_is_as_long_as_the_shorter_of_task_and_time_limit(limit):
    env = TimeLimit(rl.make_env("worked_example", seed=0), limit)
    its_own = rl.load_task("worked_example").episode_steps
    due = min(limit, its_own)
    recording = rl.record(rl.Agent(env, "Q+RANDOM", seed=0), env, 2000)
    model = rl.SampleModel.from_recording(recording)
    for world in (env, model, rl.make_env(model)):
        assert Size.of(world).episode_steps == due

    def make():
        return TimeLimit(rl.make_env("worked_example"), limit)

    result = rl.compare(make, "Q+RANDOM", 1, steps=3600, n_jobs=1, progress=False)
    (history,) = result["Q+RANDOM"]
    assert history.size.episode_steps == due
    assert len(history.returns) == 3600 // due


def test_a_time_limit_gives_episodes_to_a_task_that_goes_on_for_ever():
    def make():
        return TimeLimit(rl.make_env("wander_simple"), 15)

    result = rl.compare(make, "Q+EG", 1, episodes=3, n_jobs=1, progress=False)
    (history,) = result["Q+EG"]
    assert len(history.returns) == 3 and len(history) == 45
    env = make()
    with pytest.raises(ValueError, match="gamma must be below 1"):
        rl.Agent(env, "Q+EG", gamma=1)
    # longer than what is assumed where nothing cuts an episode off
    env = TimeLimit(Paying(), 10_500)
    agent = rl.Agent(env, "Q+EG", seed=0)
    assert len(rl.learn(agent, env, episodes=1, progress=False).returns) == 1


class Ending(gymnasium.Wrapper):
    """Ends the episode where it is paid."""

    def step(self, action):
        observation, r, _, truncated, info = self.env.step(action)
        return observation, r, r > 0, truncated, info


def test_a_wrapper_can_end_the_episodes_of_a_task_that_goes_on_for_ever():
    env = Ending(rl.make_env("wander_simple", seed=0))
    agent = rl.Agent(env, "Q+EG", gamma=1, seed=0)
    assert len(rl.learn(agent, env, episodes=2, progress=False).returns) == 2


def test_what_is_seen_otherwise_is_no_recording_of_the_task():
    inner = rl.make_env("wander_simple", seed=0)
    turned = TransformObservation(inner, lambda o: 1 - o, inner.observation_space)
    for env in (turned, TransformReward(inner, lambda r: r / 10)):
        recording = rl.record(rl.Agent(env, "Q+EG", seed=0), env, 30)
        assert recording.task is None
        assert recording.source.task_name != "wander_simple"
    env = OrderEnforcing(inner)
    assert rl.record(rl.Agent(env, "Q+EG", seed=0), env, 30).task is inner.task


def test_a_goal_of_other_peoples_worlds_counts_once():
    env = lake()
    history = rl.learn(rl.Agent(env, "Q+RANDOM", seed=1), env, 3000, progress=False)
    assert history.rewards.sum() > 0 and history.average_reward[-1] == pytest.approx(
        history.rewards.mean()
    )


@pytest.mark.parametrize("wrong", ["x", -1, 0, 2.5, True])
def test_a_limit_that_is_none_is_refused(wrong):
    world = Paying()
    world.episode_steps = wrong
    with pytest.raises(
        ValueError,
        match="episode_steps of a world must be None or a whole number of at least 1",
    ):
        rl.Agent(world)
    with pytest.raises(ValueError, match="time_limit"):
        replace(recording_of([(0, 0, 0.0, 1, False)]).source, time_limit=wrong)


def test_where_every_step_costs_the_model_gives_the_agent_that_its_world_gives():
    cliff = gymnasium.make("CliffWalking-v1", max_episode_steps=50)
    model = rl.SampleModel.from_recording(
        rl.record(rl.Agent(cliff, "Q+RANDOM", seed=0), cliff, 2000)
    )
    for method in ("Q+EG", "SARSA+EGLE", "TOSL+GREEDY", "SL+RANDOM"):
        for world in (model, rl.make_env(model)):
            assert (
                rl.Agent(world, method).parameters == rl.Agent(cliff, method).parameters
            )
    with pytest.raises(
        ValueError, match=r"r_max must be .*if all rewards are negative"
    ):
        rl.Agent(model, "Q+SR")
    assert rl.Agent(model, "Q+SR", r_max=10).parameters.r_max == 10


# ---------------------------------------------------------------------------------------------------- γ = 1


def with_goal(episode_steps=None):
    task = rl.load_task("worked_example")
    return replace(task, goal=lambda readings: True, episode_steps=episode_steps)


@pytest.mark.parametrize(
    "method", ["Q+EG", "SARSA+EGLE", "TOSL+GREEDY", "SL+RANDOM", "ESARSA+EG"]
)
@pytest.mark.parametrize("traces", ["reduced", "full"])
def test_without_discount_what_is_left_to_the_goal_is_learned(method, traces, tmp_path):
    """In a corridor in which each step costs 1, Q(s, right) is minus the number of steps to the goal."""
    rows = [(s, a, -1.0, s + a, s + a == 5) for s in range(5) for a in (0, 1)]
    recording = recording_of(rows, shape=(6,), rewards=(-1.0, 0.0))
    model = replace(
        rl.SampleModel.from_recording(recording, unseen="stay"),
        starts=np.array([0]),
        time_limit=100,
    )
    agent = rl.Agent(
        model,
        method,
        gamma=1,
        lam=1,
        alpha=0.5,
        traces=traces,
        loop_evasion=False,
        seed=0,
    )
    rl.learn(agent, rl.make_env(model, seed=0), 4000, progress=False)
    assert (
        np.isfinite(agent.q).all() and len(agent.memory.register) == 6
    )  # a trace that never fades needs all states
    if method.startswith("Q"):
        assert agent.q[:5, 1] == pytest.approx([-5, -4, -3, -2, -1], abs=1e-6)
    agent.save(tmp_path / "agent.npz")
    assert rl.Agent.load(tmp_path / "agent.npz").parameters == agent.parameters


@pytest.mark.parametrize("method", ["Q+SR", "TOSL+QBIASSR", "Q+QBIASSR"])
def test_without_discount_no_softmax_has_a_scale(method):
    with pytest.raises(
        ValueError,
        match=r"gamma must be below 1 for a softmax, which divides Q by Rmax / \(1 - gamma",
    ):
        rl.Agent(with_goal(), method, gamma=1)


def test_without_discount_there_must_be_an_end():
    endless = rl.load_task("wander_simple")
    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    cut_off = replace(endless, episode_steps=20)
    for world in (
        endless,
        cut_off,
        model,
        rl.make_env(endless),
        rl.make_env(model),
        OrderEnforcing(rl.make_env(model)),
    ):
        with pytest.raises(
            ValueError, match="gamma must be below 1 where no episode ends for good"
        ):
            rl.Agent(world, "Q+EG", gamma=1)
    for world in (
        with_goal(),
        rl.make_env(with_goal()),
        lake(),
        gymnasium.make("CliffWalking-v1"),
        Paying(),
    ):
        assert rl.Agent(world, "Q+EG", gamma=1).parameters.gamma == 1


def test_where_a_goal_ends_episodes_they_can_be_counted_without_a_limit():
    recording = rl.record(rl.Agent(lake(), "Q+RANDOM", seed=0), lake(), 500)
    model = rl.SampleModel.from_recording(recording, unseen="stay")
    some = {"episodes": 3, "repetitions": 1, "n_jobs": 1, "progress": False}
    for world in (
        model,
        replace(
            rl.load_task("worked_example"),
            goal=lambda readings: True,
            episode_steps=None,
        ),
    ):
        (history,) = rl.compare(world, ["Q+EG"], **some)["Q+EG"]
        assert (history.terminated | history.truncated).sum() == 3
    with pytest.raises(ValueError, match="goes on for ever and has no episodes"):
        rl.compare("wander_simple", ["Q+EG"], **some)


def test_a_store_tells_models_apart_by_their_limit(tmp_path):
    recording = rl.record(rl.Agent(lake(), "Q+RANDOM", seed=0), lake(), 500)
    model = rl.SampleModel.from_recording(recording)
    some = {
        "repetitions": 1,
        "steps": 50,
        "n_jobs": 1,
        "progress": False,
        "store": tmp_path / "store",
    }
    rl.compare(model, ["Q+EG"], **some)
    with pytest.raises(ValueError, match="time_limit"):
        rl.compare(replace(model, time_limit=40), ["Q+EG"], **some)
