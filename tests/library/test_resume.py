"""Stop and go on: the parts of a learning process say what the whole says, or the rest is refused in one sentence."""

import copy
import gc
import pickle
import signal
import sys
import threading
import weakref
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import TimeLimit, TransformObservation
from hypothesis import given, settings
from hypothesis import strategies as st
from worlds import RandomWorld, recording_of

import rlrobot_edu as rl
from rlrobot_edu.learning import resume
from rlrobot_edu.learning.history import History

PACKAGE = Path(rl.__file__).parent
STEPS = 60


class Lane(gymnasium.Env):
    """Four squares in a row with the goal at the end: somebody's own environment that tells nothing of where it is."""

    observation_space, action_space = (
        gymnasium.spaces.Discrete(4),
        gymnasium.spaces.Discrete(2),
    )

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self._square = 0
        return 0, {}

    def step(self, a):
        self._square = max(self._square + (1 if a else -1), 0)
        return min(self._square, 3), float(self._square), self._square == 3, False, {}


def walk_model():
    """A walk along four states; the goal is at its end, an episode has at most eight steps."""
    rows = [
        (s, a, 5.0 if s + a == 4 else 0.5, min(s + a, 3), s + a == 4)
        for s in range(4)
        for a in (0, 1)
    ]
    model = rl.SampleModel.from_recording(
        recording_of(rows, shape=(2, 2), rewards=(0.5, 5.0)), unseen="stay"
    )
    return rl.SampleModel(
        **{**vars(model), "episode_steps": 8, "starts": np.array([0])}
    )


def last_first(s):
    return 15 - s


def turned(lake):
    """The same lake whose states have other numbers."""
    return TransformObservation(lake, last_first, lake.observation_space)


WORLDS = {
    "a model, compiled": lambda: rl.make_env(walk_model(), seed=4),
    "a model, step by step": lambda: gymnasium.Wrapper(
        rl.make_env(walk_model(), seed=4)
    ),
    "a task": lambda: rl.make_env("worked_example", seed=4),
    "an MDP with a limit": lambda: TimeLimit(RandomWorld(seed=4, p_end=0.1), 7),
    "a lake": lambda: gymnasium.make("FrozenLake-v1", max_episode_steps=9),
    "a taxi": lambda: gymnasium.make("Taxi-v4", max_episode_steps=9),
    "a cliff": lambda: gymnasium.make("CliffWalking-v1"),
    "a lake, renumbered": lambda: turned(
        gymnasium.make("FrozenLake-v1", max_episode_steps=9)
    ),
    "somebody's own": Lane,
}


def fresh(make):
    """An agent and its world. Gymnasium's are seeded by a first reset."""
    env = make()
    if env.unwrapped.spec is not None:
        env.reset(seed=5)
    return rl.Agent(env, "TOSL+EG", epsilon=0.4, seed=3), env


def same_state(agent, env, other, twin):
    """Whether two agents know the same, and go on in the same way."""
    agents = [
        (a.q.tobytes(), a.e.tobytes(), a.pending, a.rng.bit_generator.state)
        for a in (agent, other)
    ]
    rest = [
        rl.learn(a, e, 20, keep=True, progress=False, resume=True)
        for a, e in ((agent, env), (other, twin))
    ]
    return agents[0] == agents[1] and np.array_equal(rest[0].s, rest[1].s)


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
@given(
    cuts=st.lists(st.integers(0, STEPS), max_size=2).map(sorted), saved=st.booleans()
)
@settings(max_examples=12)
def test_the_parts_of_a_process_say_together_what_the_whole_says(
    make, cuts, saved, tmp_path_factory
):
    file = tmp_path_factory.mktemp("parts") / "part.npz" if saved else None
    agent, env = fresh(make)
    whole = rl.learn(agent, env, STEPS, progress=False)
    other, twin = fresh(make)
    parts = []
    for i, (begin, end) in enumerate(zip([0, *cuts], [*cuts, STEPS], strict=True)):
        part = rl.learn(other, twin, end - begin, progress=False, resume=i > 0)
        if file:
            part.save(file)
            part = History.load(file)
        parts.append(part)
    assert [*np.concatenate([part.rewards for part in parts])] == [*whole.rewards]
    np.testing.assert_allclose(
        np.concatenate([part.returns for part in parts]), whole.returns
    )
    assert same_state(agent, env, other, twin)
    # a mean over n steps, and over the rest of episodes, is a sum and a number of steps
    lengths = [len(part) + rest(part) for part in parts]
    total = sum(
        n * part.average_reward[-1]
        for n, part in zip(lengths, parts, strict=True)
        if len(part)
    )
    assert total / sum(lengths) == pytest.approx(whole.average_reward[-1])
    assert sum(lengths) == STEPS + rest(whole)
    ended = [part for part in parts if (part.terminated | part.truncated).any()]
    last = ended[-1] if ended else parts[-1]
    np.testing.assert_allclose(
        last.last_episode, whole.last_episode[-len(last.last_episode) or STEPS :]
    )


def rest(history):
    """Steps that a goal stands for besides its own, counted one by one."""
    steps, n = history.before.steps, 0
    for terminated, truncated in zip(
        history.terminated, history.truncated, strict=True
    ):
        steps += 1
        n += max((history.size.episode_steps or 0) - steps, 0) if terminated else 0
        steps = 0 if terminated or truncated else steps
    return n


def test_a_goal_shortly_after_resuming_counts_for_the_rest_of_its_own_episode_alone():
    model = rl.SampleModel(**{**vars(walk_model()), "episode_steps": 100})
    agent, env = rl.Agent(model, "Q+RANDOM", seed=0), rl.make_env(model, seed=0)
    whole = rl.learn(agent, env, 500, episodes=1, progress=False)
    assert 2 < len(whole) < 100 and whole.terminated[-1]
    agent, env = rl.Agent(model, "Q+RANDOM", seed=0), rl.make_env(model, seed=0)
    rl.learn(agent, env, len(whole) - 1, progress=False)
    end = rl.learn(agent, env, 1, progress=False, resume=True)
    assert (
        end.returns == pytest.approx(whole.returns)
        and end.before.steps == len(whole) - 1
    )
    assert end.final_average_reward == pytest.approx(whole.final_average_reward)
    assert len(end.last_episode) == 100 - end.before.steps


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
@pytest.mark.parametrize("meanwhile", ["reset", "step", "learn", "elsewhere"])
def test_an_environment_that_is_not_where_the_agent_left_it_is_refused(make, meanwhile):
    (agent, env), (other, _) = fresh(make), fresh(make)
    while agent.pending is None:  # not when an episode has just ended
        rl.learn(agent, env, 1, progress=False)
    if meanwhile == "learn":
        rl.learn(other, env, 1, progress=False)
    elif meanwhile == "elsewhere":
        env = fresh(make)[1]
        env.reset()
    elif isinstance(env, Lane):
        return  # that is not told
    else:
        getattr(env, meanwhile)(*([0] if meanwhile == "step" else []))
    with pytest.raises(
        ValueError,
        match="nothing to resume: its environment was reset or stepped by somebody else",
    ):
        rl.learn(agent, env, 5, progress=False, resume=True)
    assert len(rl.learn(agent, env, 5, progress=False)) == 5


def test_an_agent_from_a_file_goes_on_in_a_copy_of_its_world_with_the_next_episode(
    tmp_path,
):
    for make in WORLDS.values():
        agent, env = fresh(make)
        rl.learn(agent, env, 25, progress=False)
        twin = copy.deepcopy(env)
        agent.save(tmp_path / "agent.npz")
        loaded = rl.Agent.load(tmp_path / "agent.npz")
        with pytest.raises(
            ValueError, match="nothing to resume: it has begun no episode"
        ):
            rl.learn(loaded, twin, 5, progress=False, resume=True)
        rest = [
            rl.learn(a, e, 20, keep=True, progress=False)
            for a, e in ((agent, env), (loaded, twin))
        ]
        assert (
            np.array_equal(rest[0].s, rest[1].s)
            and agent.e.tobytes() == loaded.e.tobytes()
        )
        assert same_state(agent, env, loaded, twin)


@pytest.mark.parametrize(
    "before",
    [[-1, 0.0, {}], ["x", 0.0, {}], [3, np.nan, {}], [1.5, 0.0, {}], [1, "x", {}]],
)
def test_where_a_history_began_is_checked_in_its_file(before, tmp_path, monkeypatch):
    agent, env = fresh(Lane)
    history = rl.learn(agent, env, 2, progress=False)
    vars(history)["before"] = before
    with monkeypatch.context() as unchecked:
        unchecked.setattr(History, "_parts", lambda self: ())
        history.save(tmp_path / "history.npz")
    with pytest.raises(ValueError, match=r"history\.npz: this history is damaged"):
        History.load(tmp_path / "history.npz")


def lines_of_ours(call, press):
    """Make the call and press Ctrl-C before the line of the library with this number. Returns the number of lines."""
    count = 0

    def trace(frame, event, _):
        nonlocal count
        if PACKAGE not in Path(frame.f_code.co_filename).parents:
            return None
        count += event == "line"
        if event == "line" and count == press:
            raise KeyboardInterrupt
        return trace

    before, handler = sys.gettrace(), signal.getsignal(signal.SIGINT)
    sys.settrace(trace)
    try:
        call()
    finally:
        sys.settrace(before)
        signal.signal(signal.SIGINT, handler)  # no handler has seen this Ctrl-C
    return count


@pytest.mark.parametrize(
    "name", ["a model, compiled", "a task", "a lake", "somebody's own"]
)
@given(share=st.floats(0, 1), from_the_start=st.booleans())
@settings(max_examples=40)
def test_ctrl_c_before_any_line_then_resume_gives_the_numbers_of_the_whole_or_is_refused(
    name, share, from_the_start
):
    def begin():
        agent, env = fresh(WORLDS[name])
        if not from_the_start:
            rl.learn(agent, env, 2, progress=False)
        return (
            agent,
            env,
            lambda: rl.learn(agent, env, 6, progress=False, resume=not from_the_start),
        )

    n = lines_of_ours(begin()[2], press=None)
    agent, env, learn = begin()
    with pytest.raises(KeyboardInterrupt):
        lines_of_ours(learn, press=1 + round(share * (n - 1)))
    try:
        rl.learn(
            agent, env, STEPS - int(agent.visits.sum()), progress=False, resume=True
        )
    except ValueError as error:
        assert (
            "nothing to resume: it has begun no episode, or was interrupted within a step"
            in str(error)
        )
        agent.begin_episode(0)
        return
    other, twin = fresh(WORLDS[name])
    rl.learn(other, twin, STEPS, progress=False)
    assert same_state(agent, env, other, twin)


@pytest.fixture
def ctrl_c():
    """Python's own handler, which is in force again when a test has ended."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    signal.signal(signal.SIGINT, before)


class Pressed(gymnasium.Wrapper):
    """Somebody presses Ctrl-C within one of its steps: before or after the robot has moved, or both."""

    def __init__(self, env, step, moments):
        super().__init__(env)
        self.steps_to_go, self.moments = step, moments

    def step(self, action):
        self.steps_to_go -= 1
        self.press("before")
        answer = self.env.step(action)
        self.press("after")
        return answer

    def press(self, moment):
        if self.steps_to_go == 0 and moment in self.moments:
            signal.raise_signal(signal.SIGINT)


def interrupted(agent, env, n, go_on=rl.learn):
    """Act until Ctrl-C is heard."""
    more = {"progress": False} if go_on is rl.learn else {}
    with pytest.raises(KeyboardInterrupt):
        list(go_on(agent, env, n, **more))
    return agent, env


@pytest.mark.parametrize("moment", ["before", "after"])
@pytest.mark.parametrize("go_on", [rl.learn, rl.steps])
def test_ctrl_c_within_a_step_of_a_robot_waits_for_its_end_and_learning_goes_on_bit_for_bit(
    go_on, moment, ctrl_c
):
    def new():
        return rl.Agent("wander_1k", seed=1), rl.make_env("wander_1k", seed=2)

    whole = rl.learn(*new(), 60, progress=False)
    for step in (1, 2, 17, 59, 60):
        agent, env = new()
        interrupted(agent, Pressed(env, step, moment), 60, go_on)
        assert agent.visits.sum() == step, "the step was done, and no other"
        rl.learn(agent, env, 60 - step, progress=False, resume=True)
        assert agent.q.tobytes() == whole.q.tobytes()


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
@given(step=st.integers(1, STEPS), moment=st.sampled_from(["before", "after"]))
@settings(max_examples=10)
def test_ctrl_c_within_a_step_is_never_refused(make, step, moment):
    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        agent, env = fresh(make)
        interrupted(agent, Pressed(env, step, moment), STEPS)
    finally:
        signal.signal(signal.SIGINT, handler)
    rl.learn(agent, env, STEPS - step, progress=False, resume=True)
    other, twin = fresh(make)
    rl.learn(other, twin, STEPS, progress=False)
    assert same_state(agent, env, other, twin)


@pytest.mark.parametrize("go_on", [rl.learn, rl.steps])
def test_a_second_ctrl_c_is_heard_within_the_step_and_then_nothing_can_be_resumed(
    go_on, ctrl_c
):
    agent, env = fresh(WORLDS["a task"])
    interrupted(agent, Pressed(env, 20, ["before", "after"]), 50, go_on)
    assert agent.visits.sum() == 19
    for again in (rl.learn, rl.steps):
        with pytest.raises(
            ValueError, match="was interrupted within a step; call without resume=True"
        ):
            again(agent, env, 5, resume=True)
    assert len(rl.learn(agent, env, 5, progress=False)) == 5


@pytest.mark.parametrize("go_on", [rl.learn, rl.steps])
def test_a_world_that_stops_at_once_hears_ctrl_c_within_the_step(go_on, ctrl_c):
    agent, env = fresh(WORLDS["a task"])
    env.unwrapped.stops_at_once = True
    interrupted(agent, Pressed(env, 20, "before"), 50, go_on)
    assert agent.visits.sum() == 19
    with pytest.raises(ValueError, match="was interrupted within a step"):
        rl.learn(agent, env, 5, progress=False, resume=True)


def test_between_two_steps_ctrl_c_is_heard_at_once(ctrl_c):
    agent, env = fresh(WORLDS["a task"])
    walk = rl.steps(agent, env, 50)
    for step in walk:
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if step.t == 9:
            with pytest.raises(KeyboardInterrupt):
                signal.raise_signal(signal.SIGINT)
            break
    walk.close()
    rl.learn(agent, env, 40, progress=False, resume=True)
    other, twin = fresh(WORLDS["a task"])
    rl.learn(other, twin, 50, progress=False)
    assert agent.q.tobytes() == other.q.tobytes()


class Broken(gymnasium.Wrapper):
    """An environment with a fault, in which Ctrl-C is pressed, too."""

    def step(self, action):
        signal.raise_signal(signal.SIGINT)
        raise ZeroDivisionError


@pytest.mark.parametrize("go_on", [rl.learn, rl.steps])
def test_a_fault_within_a_step_is_told_and_puts_the_handler_back(go_on, ctrl_c):
    agent, env = fresh(Lane)
    with pytest.raises(ZeroDivisionError):
        list(go_on(agent, Broken(env), 5))
    with pytest.raises(ValueError, match="was interrupted within a step"):
        go_on(agent, env, 5, resume=True)


def test_a_handler_of_somebody_else_stays_in_force():
    heard = []

    def own(number, frame):
        heard.append(number)

    before = signal.signal(signal.SIGINT, own)
    try:
        agent, env = fresh(Lane)
        pressed = Pressed(env, 3, ["before", "after"])
        assert len(rl.learn(agent, pressed, 5, progress=False)) == 5
        assert signal.getsignal(signal.SIGINT) is own and len(heard) == 2
    finally:
        signal.signal(signal.SIGINT, before)


class Handling(Lane):
    """A robot whose code brings a handler of its own."""

    def step(self, a):
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        return super().step(a)


def test_a_handler_that_a_step_has_set_stays_in_force(ctrl_c):
    rl.learn(*fresh(Handling), 3, progress=False)
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    signal.signal(signal.SIGINT, signal.default_int_handler)


def test_threads_learn_too():
    agent, env = fresh(Lane)
    threads = [
        threading.Thread(target=lambda: rl.learn(agent, env, 5, progress=False)),
        threading.Thread(target=lambda: list(rl.steps(agent, env, 5, resume=True))),
    ]
    for thread in threads:
        thread.start()
        thread.join()
    assert agent.visits.sum() == 10


def in_an_episode(make):
    """An agent and its world, in the middle of an episode."""
    agent, env = fresh(make)
    rl.learn(agent, env, 5, progress=False)
    while agent.pending is None:
        rl.learn(agent, env, 1, progress=False, resume=True)
    return agent, env


COPIES = {
    "copied": copy.deepcopy,
    "pickled": lambda things: pickle.loads(pickle.dumps(things)),
}
# those that count the steps of their episode; of another one, a copy is refused
COUNTING = {
    name: make for name, make in WORLDS.items() if make not in (WORLDS["a cliff"], Lane)
}


@pytest.mark.parametrize("make", COUNTING.values(), ids=COUNTING)
@pytest.mark.parametrize("way", COPIES.values(), ids=COPIES)
@pytest.mark.parametrize("what", ["agent", "world", "both"])
def test_copies_of_agent_and_world_go_on_where_these_were(make, way, what):
    agent, env = in_an_episode(make)
    twin, world = agent, env
    if what == "both":
        twin, world = way((agent, env))
    elif what == "agent":
        twin = way(agent)
        env = copy.deepcopy(env)
    else:
        world = way(env)
        agent = copy.deepcopy(agent)
    assert same_state(agent, env, twin, world)


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
@pytest.mark.parametrize("way", COPIES.values(), ids=COPIES)
def test_of_an_agent_and_its_copy_only_one_goes_on_in_their_world(make, way):
    agent, env = in_an_episode(make)
    twin = way(agent)
    rl.learn(twin, env, 1, progress=False, resume=True)
    with pytest.raises(ValueError, match="was reset or stepped by somebody else"):
        rl.learn(agent, env, 5, progress=False, resume=True)


def test_a_copy_of_a_world_that_counts_no_steps_is_refused():
    agent, env = in_an_episode(Lane)
    with pytest.raises(ValueError, match="or this is another one"):
        rl.learn(agent, copy.deepcopy(env), 5, progress=False, resume=True)
    rl.learn(agent, env, 5, progress=False, resume=True)


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
def test_nothing_is_written_into_a_world_and_an_agent_does_not_keep_it(make):
    stepped, env = make(), make()
    for world in (stepped, env):
        world.reset(seed=1)
        world.step(0)
    agent = rl.Agent(env, seed=0)
    rl.learn(agent, env, 5, progress=False)
    assert vars(env.unwrapped).keys() == vars(stepped.unwrapped).keys()
    inner = weakref.ref(env.unwrapped)
    number = id(env.unwrapped)
    assert number in resume._last_walk
    del env, world
    gc.collect()
    assert inner() is None and number not in resume._last_walk
    assert pickle.loads(pickle.dumps(agent)).pending == agent.pending


def test_a_refused_call_leaves_the_episode_as_it_is():
    agent, env = fresh(Lane)
    rl.learn(agent, env, 2, progress=False)
    for wrong in (
        {"steps": -1},
        {"steps": "3"},
        {"steps": True},
        {"steps": 10**9},
        {"steps": 3, "episodes": 0},
    ):
        with pytest.raises(ValueError, match=r"steps|episodes"):
            rl.learn(agent, env, progress=False, **wrong)
    rl.learn(agent, env, np.int64(2), episodes=np.int8(1), progress=False, resume=True)
