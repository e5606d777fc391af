"""Learning on a robot of geometry alone runs as one kernel: the numbers of the plain loop, to the last bit."""

import dataclasses
import math
import os
import random
import re
import signal
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from plain_programs import module_of

import rlrobot_edu as rl
from rlrobot_edu.jit.dispatcher import IS_PLAIN
from rlrobot_edu.learning import compiled_loop
from rlrobot_edu.robots import robot_env
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
from rlrobot_edu.task.rewards import length
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task_file import available_tasks, load_task

pytestmark = pytest.mark.skipif(IS_PLAIN, reason="there is nothing to compile with")
NEVER = 10**9
KERNELS = KinematicBase.kernels
# rewards that would say something else if numba compiled them as they are; and what is not plain in each
CAREFUL = {
    "a memory": (
        """
def make():
    battery = 100
    def reward(before, after):
        nonlocal battery
        battery -= 1
        return 10 if battery > 0 and after["x"] > before["x"] else -1
    return reward
reward = make()
""",
        "“nonlocal battery”",
    ),
    "an array that remembers": (
        """
def reward(before, after, best=np.full(1, -9.0)):
    if after["x"] > best[0] + 0.01:
        best[0] = after["x"]
        return 10
    return -1
""",
        "the default of best",
    ),
    "an entry beyond an array": (
        """
FLOOR = np.array([0.0, 0.0, 0.0])
def reward(before, after):
    return 10 if FLOOR[round(20 * length(after["x"], after["y"]))] > 0.5 else -1
""",
        "“FLOOR[",
    ),
    "a logarithm of less than 0": (
        """
def reward(before, after):
    return 10 if math.log(0.4 - length(after["x"], after["y"])) < -3 else -1
""",
        "“math.log(",
    ),
    "a root of less than 0, as a power": (
        """
def reward(before, after):
    return 10 if (0.4 - length(after["x"], after["y"])) ** 0.5 < 0.1 else -1
""",
        "“(0.4 -",
    ),
    "a negative power of a whole number": (
        """
def reward(before, after):
    return 10 if 2 ** int(-5 * length(after["x"], after["y"])) >= 0.4 else -1
""",
        "“int(-5",
    ),
    "a whole number beyond 2**63": (
        """
def reward(before, after):
    return 10 if int(100 * length(after["x"], after["y"])) ** 12 > 10 ** 19 else -1
""",
        "“int(",
    ),
}
TASKS = [
    name
    for name in available_tasks()
    if "kinematic" in ROBOTS[load_task(name).robot].engines
    and load_task(name).robot != "mobile_manipulator"
]


@pytest.fixture
def compiling(monkeypatch):
    """Sets from how many steps on the loop is compiled."""
    return lambda steps: monkeypatch.setattr(robot_env, "WORTH_COMPILING", steps)


@pytest.fixture
def plain_steps(monkeypatch):
    """The numbers of the actions that robots were given one at a time, in the plain loop."""
    taken, step = [], robot_env.RobotEnv.step
    monkeypatch.setattr(
        robot_env.RobotEnv, "step", lambda self, a: taken.append(a) or step(self, a)
    )
    return taken


def fresh(task, method="TOSL+QBIASSR", **robot):
    return rl.Agent(task, method, seed=5), rl.make_env(
        task, 3, engine="kinematic", **robot
    )


def learned(
    compiling, first, task, steps, method="TOSL+QBIASSR", realism=None, **length
):
    """Agent, environment and history of so many steps; compiled if there are at least `first`."""
    agent, env = fresh(task, method, realism=realism)
    compiling(first)
    return agent, env, rl.learn(agent, env, steps, keep=True, progress=False, **length)


def told(agent, env, *histories):
    """All that must be the same, as text: it tells −0 from 0, and NaN is itself."""
    env = env.unwrapped
    columns = [
        np.concatenate(rows).tolist()
        for rows in zip(*(h.transitions for h in histories), strict=True)
    ]
    memory = (
        [array.tolist() for array in agent.memory[:-2]],
        float(agent.memory.now.temperature),
    )
    place = (
        env.state,
        env.episode_step,
        env._at_goal,
        env._readings,
        env.robot.readings,
        env.robot.parts.place.tolist(),
    )
    streams = agent.rng.bit_generator.state, env.np_random.bit_generator.state
    return repr(
        (
            columns,
            memory,
            place,
            streams,
            agent.pending,
            agent.resume_point and agent.resume_point[:2],
        )
    )


@pytest.mark.parametrize("task", TASKS)
@pytest.mark.parametrize(
    "method", ["TOSL+QBIASSR", pytest.param("Q+EG", marks=pytest.mark.nightly)]
)
def test_compiled_or_not_an_agent_lives_the_same_life_and_its_robot_stands_at_the_same_place(
    task, method, compiling, plain_steps
):
    whole = learned(compiling, 1, task, 2500, method)
    assert not plain_steps
    assert told(*whole) == told(*learned(compiling, NEVER, task, 2500, method))


@pytest.mark.parametrize("task", ["wander_1k", "navigation_1k"])
def test_where_walls_hold_and_commands_are_late_it_is_compiled_too(
    task, compiling, plain_steps
):
    vrep = {"realism": rl.Realism.vrep()}
    whole = learned(compiling, 1, task, 2500, **vrep)
    assert not plain_steps
    assert told(*whole) == told(*learned(compiling, NEVER, task, 2500, **vrep))


def test_it_stops_and_goes_on_where_the_plain_loop_would(compiling):
    whole = learned(compiling, NEVER, "arm_1k", 1500)
    agent, env, first = learned(compiling, 1, "arm_1k", 1500, episodes=3)
    assert len(first) == 360
    compiling(NEVER)  # compiled and plain steps take turns
    second = rl.learn(agent, env, 300, keep=True, progress=False, resume=True)
    compiling(1)
    third = rl.learn(agent, env, 840, keep=True, progress=False, resume=True)
    assert told(agent, env, first, second, third) == told(*whole)


def test_ctrl_c_is_heard_between_two_slices_and_learning_goes_on_bit_for_bit(
    compiling, monkeypatch
):
    whole = learned(compiling, NEVER, "wander_1k", 500)
    compiling(1)
    monkeypatch.setattr(compiled_loop, "SLICE", 100)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    make_run, slices = compiled_loop.make_run, []

    def make_and_press(*kind):
        def run_and_press(*arguments):
            slices.append(make_run(*kind)(*arguments))
            if len(slices) == 2:
                signal.raise_signal(signal.SIGINT)

        return run_and_press

    monkeypatch.setattr(compiled_loop, "make_run", make_and_press)
    agent, env = fresh("wander_1k")
    try:
        with pytest.raises(KeyboardInterrupt):
            rl.learn(agent, env, 500, progress=False)
    finally:
        signal.signal(signal.SIGINT, before)
    assert agent.visits.sum() == 200
    rl.learn(agent, env, 300, progress=False, resume=True)
    assert told(agent, env, whole[-1]) == told(*whole)


def test_a_goal_ends_episodes_for_good_as_in_the_plain_loop(compiling, plain_steps):
    task = task_with(
        '10.0 if after["x"] > 0.1 else -1.0',
        goal='readings["x"] > 0.1',
        goal_steps=3,
        episode_steps=40,
    )
    whole = learned(compiling, 1, task, 3000)
    assert (
        not plain_steps and 20 < whole[-1].terminated.sum() < whole[-1].terminated.size
    )
    assert told(*whole) == told(*learned(compiling, NEVER, task, 3000))


def task_with(reward, goal=None, rewards=(10.0, -1.0), around=None, **more):
    """wander_1k with this reward and goal, expressions of Python."""
    space = {
        "math": math,
        "sqrt": math.sqrt,
        "near": near,
        "LIMIT": 0.3,
        **(around or {}),
    }
    space = module_of(
        f"def reward(before, after):\n    return {reward}\ndef goal(readings):\n    return {goal}",
        space,
    )
    like = load_task("wander_1k")
    return rl.Task(
        like.robot, like.scene, like.inputs, like.outputs, space["reward"], rewards, command=like.command,
        goal=goal and space["goal"], **more,
    )  # fmt: skip


def of_text(text):
    """wander_1k with the reward that this text defines."""
    around = {"math": math, "np": np, "length": length}
    return dataclasses.replace(
        load_task("wander_1k"),
        reward=module_of(text, around)["reward"],
        rewards=[10, -1],
    )


@pytest.mark.parametrize("what", CAREFUL)
def test_a_reward_that_would_say_something_else_when_compiled_is_not_compiled(
    what, compiling, plain_steps, capsys
):
    text, part = CAREFUL[what]
    lives = []
    for first in (1, NEVER):
        try:  # each time with a memory of its own
            lives.append(told(*learned(compiling, first, of_text(text), 400)))
        except ValueError as failed:
            lives.append(re.sub("drawn program [0-9]+", "", str(failed)))
    assert lives[0] == lives[1] and plain_steps
    assert part in capsys.readouterr().err


def test_a_root_of_less_than_0_fails_at_the_same_step_with_pythons_words(compiling):
    test_a_task_that_fails_fails_at_the_same_step_with_the_same_words(
        "10.0 if sqrt(0.1 - after['x'] * after['x']) < 0.2 else -1.0",
        "math domain error|nonnegative",
        compiling,
    )


def near(readings, limit=0.3):
    return min(readings["laser_front"], readings["laser_left"]) < limit


REFUSED = (
    "sum(after[name] for name in ('x', 'y')) > 0.1",
    "after.get('x') > 0.1",
    "random.random() > 0.5",
)


@pytest.mark.parametrize("condition", REFUSED)
def test_a_reward_that_is_not_plain_runs_as_python_and_says_so_once(
    condition, compiling, plain_steps, capsys
):
    task = task_with(f"10.0 if {condition} else -1.0", around={"random": random})
    random.seed(1)
    learned(compiling, 1, task, 60)
    random.seed(1)
    compiled = learned(compiling, 1, task, 60)
    assert len(plain_steps) == 120
    said = [line for line in capsys.readouterr().err.splitlines() if line]
    assert len(said) == 1 and "is not plain" in said[0], said
    random.seed(1)
    assert told(*compiled) == told(*learned(compiling, NEVER, task, 60))


def test_what_a_closure_holds_is_compiled_and_may_be_another_number_in_the_next_task(
    compiling, plain_steps
):
    def above(limit):
        return lambda before, after: 10 if after["x"] > limit else -2

    for limit, only in ((-9.0, 10.0), (9.0, -2.0)):
        task = dataclasses.replace(load_task("wander_1k"), reward=above(limit))
        assert set(learned(compiling, 1, task, 50)[-1].rewards.tolist()) == {only}
    assert not plain_steps


def test_what_has_no_kernels_of_its_own_runs_as_python(compiling, plain_steps):
    class Odd(KinematicBase):
        def _sense(self):
            return super()._sense() | {"laser_front": 0.1}

    agent, env = fresh("wander_1k")
    env.robot = Odd("maze_6x6", 1.0)
    compiling(1)
    rl.learn(agent, env, 20, progress=False)
    rl.learn(
        *fresh("wander_1k", realism=rl.Realism(laser_noise=0.1)), 20, progress=False
    )
    assert len(plain_steps) == 40


@pytest.mark.parametrize(
    "reward, fault",
    [
        ('10.0 if 1 / (after["x"] - after["x"]) > 0 else -1.0', "division by zero"),
        ('10.0 if after["x"] < 0.25 else after["x"]', "not one of rewards"),
        ('10.0 if after["x"] < 0.25 else None', "not one of rewards|is no"),
    ],
)
def test_a_task_that_fails_fails_at_the_same_step_with_the_same_words(
    reward, fault, compiling
):
    lives = []
    for first in (1, NEVER):
        agent, env = fresh(task_with(reward))
        compiling(first)
        with pytest.raises(ValueError, match=fault) as failed:
            rl.learn(agent, env, 3000, progress=False)
        lives.append(
            (
                str(failed.value),
                agent.visits.sum(),
                agent.q.tolist(),
                env.robot.readings,
            )
        )
    assert lives[0] == lives[1]


def test_another_arena_counts_from_the_next_episode_on_as_in_the_plain_loop(compiling):
    lives = []
    for first in (1, NEVER):
        agent, env = fresh("wander_1k")
        compiling(first)
        before = rl.learn(agent, env, 40, keep=True, progress=False)
        env.robot.arena = ARENAS["square_2x2"]
        after = rl.learn(agent, env, 40, keep=True, progress=False)
        lives.append(told(agent, env, before, after))
    assert lives[0] == lives[1]


def test_a_number_that_the_reward_reads_may_be_changed_between_two_calls(
    compiling, plain_steps
):
    task = task_with("10.0 if near(after, LIMIT) else -1.0")
    shares = []
    for limit in (0.0, 9.0):
        task.reward.__globals__["LIMIT"] = limit
        shares.append(set(learned(compiling, 1, task, 50)[-1].rewards.tolist()))
    assert shares == [{-1.0}, {10.0}] and not plain_steps


numbers = st.sampled_from(
    [
        "before['x']",
        "after['y']",
        "after['theta']",
        "after['laser_front']",
        "LIMIT",
        "0.1",
        "2",
        "7",
    ]
)


def grown(parts):
    return st.one_of(
        st.builds(
            "({} {} {})".format,
            parts,
            st.sampled_from(["+", "-", "*", "/"]),
            parts,
        ),
        st.builds(
            "{}({}, {})".format,
            st.sampled_from(["min", "max"]),
            parts,
            parts,
        ),
        st.builds(
            "{}({})".format,
            st.sampled_from(["abs", "round", "sqrt", "math.sqrt", "-", "+"]),
            parts,
        ),
        st.builds("({} if {} < {} else {})".format, parts, parts, parts, parts),
        st.builds("({} < {} or near(after))".format, parts, parts),
        st.builds("({} <= {} < {})".format, parts, parts, parts),
    )


@pytest.mark.long
@settings(max_examples=16, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    st.recursive(numbers, grown, max_leaves=12),
    st.recursive(numbers, grown, max_leaves=12),
)
def test_whatever_a_reward_compares_the_life_is_the_same_to_the_last_bit(
    compiling, one, other
):
    task = task_with(f"10.0 if {one} < {other} else -1.0")
    lives = []
    for first in (1, NEVER):
        try:
            lives.append(told(*learned(compiling, first, task, 300)))
        except ValueError as failed:
            lives.append(str(failed))
    assert lives[0] == lives[1]


PLAIN = """
import sys
sys.path[:0] = sys.argv[1:]
from test_compiled_loop import fresh, told
import rlrobot_edu as rl
agent, env = fresh("wander_simple")
print(told(agent, env, rl.learn(agent, env, 1200, keep=True, progress=False)))
"""


def test_without_a_compiler_the_numbers_are_the_same():
    agent, env = fresh("wander_simple")
    here = told(agent, env, rl.learn(agent, env, 1200, keep=True, progress=False))
    without = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    folder = os.path.dirname(__file__)
    ran = subprocess.run(
        [sys.executable, "-c", PLAIN, folder, os.path.dirname(folder)],
        capture_output=True,
        text=True,
        env=without,
    )
    assert ran.stdout.strip() == here, ran.stderr
