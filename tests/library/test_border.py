"""What reaches compiled code, and what is believed: bounds, observations, files, and a task that stays what it was."""

import copy
import dataclasses
import io
import json
import math
import os
import pickle
import subprocess
import sys
import warnings
import zipfile

import cloudpickle
import gymnasium
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from worlds import RandomWorld, recording_of

import rlrobot_edu as rl
from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.models.sample_model import DTYPES
from rlrobot_edu.models.value_iteration import best_average_reward

TASK = '''"""A task of my own."""
import rlrobot_edu as rl

LIMIT = 0.5

def far(readings):
    return readings["laser_front"] > LIMIT

def reward(before, after):
    return 1 if far(after) else -1

task = rl.Task(
    robot="mobile_base", scene="square_2x2",
    inputs=[rl.InputVariable("laser_front", cuts=[0.2, 0.5], unit="m")],
    outputs=[rl.OutputVariable("left_wheel", values=[0, 1], unit="rad/s"),
             rl.OutputVariable("right_wheel", values=[0, 1], unit="rad/s")],
    reward=reward, rewards=[-1, 1],
)
'''


@pytest.fixture
def task_file(tmp_path):
    path = tmp_path / "my_own.py"
    path.write_text(TASK)
    return path


# A task is what was loaded


def test_a_changed_task_is_the_same_task_on_every_core():
    task = dataclasses.replace(rl.load_task("wander_simple"), step_time=0.2)
    one, two = (
        rl.compare(task, ["Q+SR"], 2, steps=60, n_jobs=n, progress=False).final["Q+SR"]
        for n in (1, 2)
    )
    assert np.array_equal(one, two)
    assert not np.array_equal(
        one,
        rl.compare("wander_simple", ["Q+SR"], 2, steps=60, progress=False).final[
            "Q+SR"
        ],
    )


@pytest.mark.parametrize("travel", [lambda t: pickle.loads(pickle.dumps(t)), copy.deepcopy, copy.copy,
                                    lambda t: cloudpickle.loads(cloudpickle.dumps(t))])  # fmt: skip
def test_a_task_travels_as_it_was_loaded_whatever_becomes_of_its_file(
    task_file, travel
):
    task = dataclasses.replace(rl.load_task(task_file), step_time=0.3)
    task_file.write_text(TASK.replace("LIMIT = 0.5", "LIMIT = 5"))
    there = travel(task)
    task_file.unlink()
    assert (
        travel(there).step_time == 0.3 and there.fingerprint == task.fingerprint != ""
    )
    assert there.reward_for({}, {"laser_front": 1.0}) == 1 and there.path == str(
        task_file
    )


def test_an_environment_whose_task_was_changed_is_copied_with_the_change():
    env = rl.make_env(dataclasses.replace(rl.load_task("wander_simple"), step_time=0.2))
    assert copy.deepcopy(env).task.step_time == 0.2


def test_a_store_knows_another_content_of_the_tasks_file_and_another_function(
    task_file, tmp_path
):
    def run(task):
        return rl.compare(
            task, ["Q+SR"], 1, steps=10, progress=False, store=tmp_path / "store"
        )

    task = rl.load_task(task_file)
    run(task)
    task_file.write_text(TASK.replace("LIMIT = 0.5", "LIMIT = 0.6"))
    run(task)  # still what was loaded
    with pytest.raises(ValueError, match="the content of the task's file"):
        run(rl.load_task(task_file))
    for least in (0.1, 0.2):

        def reward(before, after, least=least):
            return 1 if after["laser_front"] > least else -1

        changed = dataclasses.replace(task, reward=reward)
        with pytest.raises(ValueError, match="the function reward"):
            run(changed)
    with pytest.raises(ValueError, match="goal_steps"):
        run(dataclasses.replace(task, goal_steps=3))


def test_a_function_is_known_by_what_it_does_and_by_what_it_reaches():
    def made(limit, text):
        namespace = {"LIMIT": limit}
        exec(text, namespace)
        return code_of(namespace["f"])

    from rlrobot_edu.jit.fingerprint import code_of

    one = "def g(x):\n    return x > LIMIT\ndef f(x):\n    return g(x) + 1"
    assert made(1, one) == made(1, "\n\n" + one)
    assert (
        len(
            {
                made(1, one),
                made(2, one),
                made(1, one.replace("+ 1", "+ 2")),
                made(1, one.replace(">", "<")),
            }
        )
        == 4
    )
    command = f"exec({one!r}, space := {{'LIMIT': 1}})\nprint(code_of(space['f']))"
    command = f"from rlrobot_edu.jit.fingerprint import code_of\n{command}"
    assert subprocess.check_output(
        [sys.executable, "-c", command], text=True
    ).strip() == made(1, one)


# An agent sees what its environment shows


class Turned(gymnasium.ObservationWrapper):
    """The bins in reverse order, as another numbering of the same states."""

    def observation(self, observation):
        return self.observation_space.nvec - 1 - observation


@pytest.mark.parametrize("world", ["wander_simple", "model"])
def test_a_wrapper_that_renames_the_states_renames_what_is_learned(world, wander_model):
    world = wander_model if world == "model" else world
    agents = [rl.Agent(world, "Q+RANDOM", seed=1) for _ in range(2)]
    plain, turned = rl.make_env(world, seed=2), Turned(rl.make_env(world, seed=2))
    pairs = zip(agents, (plain, turned), strict=True)
    histories = [
        rl.learn(agent, env, 150, keep=True, progress=False) for agent, env in pairs
    ]
    n = agents[0].q.shape[0]
    assert np.array_equal(histories[1].s, n - 1 - histories[0].s)
    assert np.array_equal(agents[1].q, agents[0].q[::-1]) and agents[0].q.any()


def test_a_wrapper_that_sees_less_makes_fewer_states():
    inner = rl.make_env("wander_4k", seed=0)
    coarse = gymnasium.spaces.MultiDiscrete([2, 2])
    env = gymnasium.wrappers.TransformObservation(inner, lambda o: o[:2] // 2, coarse)
    agent = rl.Agent(env, seed=0)
    history = rl.learn(agent, env, 60, keep=True, progress=False)
    assert agent.q.shape[0] == 4 and history.s_next.max() < 4
    assert agent.visits.sum() == 60


class Liar(gymnasium.Wrapper):
    """An environment that shows what is not in its space, or says in its info what it does not show."""

    def __init__(self, env, lie, info=None):
        super().__init__(env)
        self.lie, self.info = lie, info or {}

    def step(self, action):
        _, r, terminated, truncated, _ = self.env.step(action)
        return self.lie, r, terminated, truncated, self.info


@pytest.mark.parametrize(
    "lie", [np.array([3, 0, 0]), np.array([-1, 0, 0]), np.array([0, 0]), np.array([0.5, 0, 0]), None, "north", 7,
            np.array([10**9, 0, 0]), np.array([np.nan, 0, 0]), [[0, 0], [0]]]
)  # fmt: skip
def test_an_observation_outside_its_space_is_refused(lie):
    env = Liar(RandomWorld(), lie)
    with pytest.raises(ValueError, match="not in its MultiDiscrete"):
        rl.learn(rl.Agent(env), env, 5, progress=False)


def test_a_foreign_info_is_not_mistaken_for_a_state():
    env = Liar(RandomWorld(), np.array([2, 1, 1]), {"state": 10**9})
    history = rl.learn(rl.Agent(env), env, 5, keep=True, progress=False)
    assert (history.s_next == 11).all()


def test_spaces_that_do_not_begin_at_zero_are_counted_from_their_start():
    env = RandomWorld()
    env.observation_space = gymnasium.spaces.MultiDiscrete([3, 2], start=[5, -1])
    assert [state_numbers(env)(np.array(o)) for o in ([5, -1], [5, 0], [7, 0])] == [
        0,
        1,
        5,
    ]
    env.observation_space = gymnasium.spaces.Discrete(4, start=2)
    assert [state_numbers(env)(o) for o in (2, np.int64(5))] == [0, 3]
    with pytest.raises(ValueError, match="6, which is not in its Discrete"):
        state_numbers(env)(6)


def test_a_drive_of_another_kind_is_left_alone():
    env = RandomWorld()
    env.drive = lambda *_: pytest.fail("a car's, not ours")
    assert len(rl.learn(rl.Agent(env), env, 5, progress=False)) == 5


def test_a_reward_that_is_no_finite_number_is_refused():
    for r in (math.nan, math.inf, -math.inf):
        env = gymnasium.wrappers.TransformReward(RandomWorld(), lambda _, r=r: r)
        with pytest.raises(ValueError, match="a reward must be a number"):
            rl.learn(rl.Agent(env), env, 5, progress=False)


# Bounds


BAD = st.one_of(
    st.integers(max_value=-1), st.integers(min_value=10**4), st.floats(), st.none(), st.text(), st.complex_numbers(),
    st.just(np.float64(0)), st.just(np.array([0, 1])), st.just(True).map(lambda _: [0]),
)  # fmt: skip


@given(
    BAD,
    st.sampled_from(
        ["s", "a", "r", "s_next", "begin", "update", "a_next", "step", "outcomes"]
    ),
)
@settings(max_examples=200, deadline=None)
def test_no_state_action_or_reward_that_is_not_there_gets_through(bad, where):
    model = rl.SampleModel.from_recording(
        recording_of([(0, 0, 5.0, 1, 0), (1, 1, 0.0, 3, 0)])
    )
    agent, env = rl.Agent(model, seed=0), rl.make_env(model, seed=0)
    env.reset(seed=0)
    transition = {"s": 0, "a": 1, "r": 1.0, "s_next": 2, "terminated": False}
    if (
        where == "r"
        and isinstance(bad, int | float)
        and math.isfinite(bad)
        and abs(bad) < 1e300
    ):
        return
    with pytest.raises(ValueError):
        if where == "begin":
            agent.begin_episode(bad)
        elif where == "step":
            env.step(bad)
        elif where == "outcomes":
            model.outcomes(bad, 0)
        elif where == "a_next":
            agent.update(**transition, a_next=bad)
        elif where == "update":
            agent.update(**{**transition, "s_next": bad}, a_next=0)
        elif where == "r" and isinstance(bad, int | float) and math.isfinite(bad):
            raise ValueError("a huge reward is a number, too")
        else:
            agent.learn_step(**{**transition, where: bad})
    assert not agent.q.any() and np.isfinite(agent.q).all()


def test_a_model_must_be_reset_before_its_first_step(wander_model):
    with pytest.raises(gymnasium.error.ResetNeeded):
        rl.make_env(wander_model).step(0)


@pytest.mark.parametrize("env", ["wander_simple", "model"])
@pytest.mark.parametrize("episodes", [0, -1, 1.5, "two"])
def test_a_number_of_episodes_means_the_same_on_a_robot_and_on_a_model(
    env, episodes, wander_model
):
    env = rl.make_env(wander_model if env == "model" else env)
    with pytest.raises(
        ValueError, match="episodes must be None or a whole number of at least 1"
    ):
        rl.learn(rl.Agent(env), env, 5, episodes=episodes, progress=False)


@pytest.mark.parametrize(
    ("settings", "match"),
    [
        ({"r_max": 1e-320}, "r_max must be between 1e-100 and 1e100"),
        ({"r_max": -1}, "if all rewards are negative, give the magnitude"),
        ({"epsilon": "0.1"}, "epsilon must be a number"),
        ({"alpha": True}, "alpha must be a number, got True"),
        ({"r_max": np.True_}, "r_max must be a number, got True"),
        ({"planning_steps": True}, "planning_steps must be a whole number"),
        ({"loop_evasion": "no"}, "loop_evasion must be True or False"),
        ({"traces": np.array(["full"])}, "traces must be"),
    ],
)
def test_a_setting_of_the_wrong_kind_is_refused_in_words(settings, match):
    with pytest.raises(ValueError, match=match):
        rl.Agent("wander_simple", **settings)


def test_a_world_without_a_reward_above_zero_asks_for_r_max():
    model = rl.SampleModel.from_recording(
        recording_of([(0, 0, -1.0, 1, 0)], rewards=(-1.0,))
    )
    with pytest.raises(ValueError, match="give the magnitude of a typical one"):
        rl.Agent(model)
    rl.learn(rl.Agent(model, r_max=1), rl.make_env(model), 10, progress=False)


@pytest.mark.parametrize("shape", [(10**8,), (10**5, 10**5), (0,), (-3,), (2.5,)])
def test_a_table_that_no_memory_could_hold_is_refused_before_it_is_made(shape):
    from rlrobot_edu.learning.size import Size

    with pytest.raises(
        ValueError, match=r"too many for a table|must be a whole number"
    ):
        rl.Agent(Size(shape, 4))


# Files


def changed(path, name, change):
    """The arrays file at `path`, with one of its arrays, or what it says about itself, changed."""
    with np.load(path) as file:
        arrays = dict(file)
    if name == "about":
        about = json.loads(str(arrays["about"]))
        change(about)
        arrays["about"] = np.array(json.dumps(about))
    else:
        arrays[name] = np.asarray(change(arrays[name]))
    np.savez(path, **arrays)


def put(value, *where):
    def change(array):
        array[where] = value
        return array

    return change


def say(**facts):
    return lambda about: about.update(facts)


@pytest.fixture
def saved_agent(tmp_path, wander_model):
    agent = rl.Agent(wander_model, seed=0)
    rl.learn(agent, rl.make_env(wander_model, seed=1), 500, progress=False)
    agent.save(tmp_path / "agent.npz")
    return tmp_path / "agent.npz"


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("q", put(math.nan, 3, 1)), ("q", lambda q: q[0]), ("q", lambda q: q.astype(complex)), ("q", lambda q: q.T),
        ("q", lambda q: q[:1]), ("visits", put(-1, 0, 0)), ("visits", lambda visits: visits.astype(float)),
        ("about", say(shape=[2, -3])),
        ("about", say(shape=[10**6, 10**6])), ("about", say(method="Q")), ("about", say(n_actions="3")),
        ("about", say(settings={"alpha": 7})), ("about", say(rng={})), ("about", lambda about: about.clear()),
    ],
)  # fmt: skip
def test_an_agents_file_is_believed_only_as_a_whole(saved_agent, name, change):
    changed(saved_agent, name, change)
    with pytest.raises(ValueError, match=r"agent\.npz"):
        rl.Agent.load(saved_agent)


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("s_next", put(10**9, 0)), ("s_next", put(-1, 0)), ("s_next", lambda s: s[:-1]), ("s_next", lambda s: s + 0.5),
        ("offsets", put(10**9, -1)), ("offsets", put(5, 0)), ("offsets", lambda o: o[::-1]),
        ("offsets", lambda o: o[:-1]),
        ("r", put(math.nan, 0)), ("r", put(123.0, 0)), ("r", lambda r: r.astype(complex)), ("starts", lambda s: s[:0]),
        ("starts", put(10**9, 0)), ("cumulative", put(0, 0)), ("cumulative", lambda c: c[::-1]),
        ("rewards", lambda r: r[::-1]), ("rewards", lambda r: r[:0]), ("terminated", lambda t: t.astype(float)),
        ("about", say(shape=[3])), ("about", say(n_actions=0)), ("about", say(unseen="guess")),
        ("about", say(episode_steps=0)), ("about", say(episode_steps=10**30)),
        ("about", say(episode_steps="ten")), ("about", say(colour="red")),
    ],
)  # fmt: skip
def test_a_models_file_is_believed_only_as_a_whole(
    tmp_path, wander_model, name, change
):
    path = tmp_path / "model.npz"
    wander_model.save(path)
    changed(path, name, change)
    with pytest.raises(ValueError, match=r"model\.npz"):
        rl.SampleModel.load(path)


def test_every_array_of_a_model_is_looked_at(wander_model):
    for name in DTYPES:
        with pytest.raises(ValueError, match=name):
            dataclasses.replace(
                wander_model,
                **{name: np.array(["x"] * len(getattr(wander_model, name)))},
            )


def test_a_file_that_claims_to_be_huge_is_refused_by_its_header(tmp_path):
    path = tmp_path / "bomb.npz"
    with (
        zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive,
        archive.open("about.npy", "w") as entry,
    ):
        for _ in range(400):
            entry.write(bytes(2**20))
    for load in (rl.Agent.load, rl.SampleModel.load):
        with pytest.raises(ValueError, match="claims to hold more than 256 MB"):
            load(path)


@pytest.mark.parametrize(
    "kind", ["fifo", "folder", "nothing", "empty", "npy", "text", "pickle", "encrypted"]
)
def test_what_is_no_file_of_arrays_is_refused_by_name(tmp_path, kind):
    path = tmp_path / "agent.npz"
    if kind == "fifo":
        if not hasattr(os, "mkfifo"):
            pytest.skip("this system has no named pipes")
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "npy":
        buffer = io.BytesIO()
        np.save(buffer, np.zeros(3))
        path.write_bytes(buffer.getvalue())
    elif kind == "encrypted":
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("about.npy", b"?")
        data = bytearray(path.read_bytes())
        data[data.index(b"PK\x01\x02") + 8] |= 1
        path.write_bytes(data)
    elif kind != "nothing":
        path.write_bytes(
            {"empty": b"", "text": b"PK, not a zip", "pickle": pickle.dumps([1])}[kind]
        )
    for load in (rl.Agent.load, rl.SampleModel.load):
        with pytest.raises((ValueError, FileNotFoundError), match=r"agent\.npz"):
            load(path)


# Planning and statistics


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9, 1e15])
def test_plans_end_and_scale_with_the_rewards(scale):
    rows = [
        (0, 0, 5.0 * scale, 1, 0),
        (1, 1, 0.0, 0, 0),
        (1, 0, scale, 1, 0),
        (0, 1, -scale, 0, 0),
    ]
    rewards = (-scale, 0.0, scale, 5.0 * scale)
    model = rl.SampleModel.from_recording(
        recording_of(rows, shape=(2, 1), rewards=rewards), unseen="stay"
    )
    assert best_average_reward(model) == pytest.approx(2.5 * scale)
    assert (
        rl.value_iteration(model, 0.5).v[1]
        == pytest.approx(2 * scale * 5 / 3, rel=1e-6)
        or scale < 1
    )


@pytest.mark.parametrize("tolerance", [0, -1, math.nan, math.inf])
def test_a_tolerance_that_is_never_reached_is_refused(wander_model, tolerance):
    with pytest.raises(ValueError, match="tolerance must be a number, at least 1e-300"):
        rl.value_iteration(wander_model, tolerance=tolerance)


def test_values_beyond_all_numbers_are_refused():
    rows, rewards = [(0, 0, 1e308, 0, 0)], (1e308,)
    with pytest.raises(ValueError, match="up to 1e100"):
        rl.SampleModel.from_recording(
            recording_of(rows, shape=(1, 1), n_actions=1, rewards=rewards)
        )


# The place where it runs


def test_nothing_warns(wander_model):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rl.learn(rl.Agent(wander_model), rl.make_env(wander_model), 100, progress=False)


@pytest.mark.parametrize("seed", [-1, 0.5, "one", [1], math.nan])
def test_what_is_no_seed_is_refused_wherever_one_is_given(seed, wander_model):
    for use in (
        lambda: rl.Agent("wander_simple", seed=seed),
        lambda: rl.make_env("wander_simple", seed=seed),
        lambda: rl.make_env(wander_model, seed=seed),
        lambda: rl.repeat(wander_model, "Q+SR", repetitions=1, steps=5, seed=seed),
        lambda: rl.compare(
            wander_model, ["Q+SR"], 1, steps=5, seed=seed, progress=False
        ),
    ):
        with pytest.raises(
            ValueError, match="seed must be a whole number of at least 0"
        ):
            use()


def test_numpys_whole_numbers_count_like_pythons(wander_model):
    n = np.int64(2)
    assert (
        len(
            rl.compare(wander_model, ["Q+SR"], n, steps=np.int64(5), progress=False)[
                "Q+SR"
            ]
        )
        == 2
    )
    assert len(rl.repeat(wander_model, "Q+SR", repetitions=n, steps=5)) == 2
    assert (
        len(rl.record(rl.Agent(wander_model), rl.make_env(wander_model), steps=n)) == 2
    )
    assert (
        dataclasses.replace(
            rl.load_task("wander_simple"), episode_steps=n
        ).episode_steps
        == 2
    )
