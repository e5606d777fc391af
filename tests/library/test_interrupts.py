"""Learning in a model: the compiled loop stops now and then, so that Ctrl-C is heard, and goes on as if it had not."""

import _thread
import signal
import threading

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.learning import compiled_loop, progress
from rlrobot_edu.models.sampling import begin, outcome

SETTINGS = [
    {"method": "Q+SR"},
    {"method": "TOSL+QBIASSR"},
    {"method": "SL+EGLE", "loop_evasion": True},
]


def fresh(model, settings):
    return rl.Agent(model, seed=3, **settings), rl.make_env(model, seed=4)


def same(history, other):
    names = ("s", "a", "rewards", "s_next", "terminated", "truncated", "q", "visits")
    return all(
        np.array_equal(getattr(history, name), getattr(other, name)) for name in names
    )


def same_state(agent, env, other, twin):
    """Whether an agent and its world stand where others do, and will go on in the same way."""
    here, there = ((a.pending, w.state, w.episode_step, a.rng.random(), w.np_random.random())
                   for a, w in ((agent, env), (other, twin)))  # fmt: skip
    return (
        here == there
        and np.array_equal(agent.q, other.q)
        and np.array_equal(agent.e, other.e)
    )


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("length", [1, 7, 8, 1000])
@pytest.mark.parametrize("episodes", [None, 1, 30])
def test_slices_of_any_length_make_the_same_history(
    episodes_model, settings, length, episodes, monkeypatch
):
    agent, env = fresh(episodes_model, settings)
    whole = rl.learn(agent, env, 300, episodes=episodes, keep=True, progress=False)
    monkeypatch.setattr(compiled_loop, "SLICE", length)
    other, twin = fresh(episodes_model, settings)
    assert same(
        whole, rl.learn(other, twin, 300, episodes=episodes, keep=True, progress=False)
    )
    assert same_state(agent, env, other, twin)


@pytest.fixture
def ctrl_c():
    """What Ctrl-C does in a terminal, also where the tests run in the background."""
    if threading.current_thread() is not threading.main_thread():
        pytest.skip("signals come to the main thread alone")
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("pressed_in", [1, 2, 5])
def test_ctrl_c_within_a_slice_is_heard_at_its_end_and_learning_goes_on_bit_for_bit(
    wander_model, settings, pressed_in, monkeypatch, ctrl_c
):
    monkeypatch.setattr(compiled_loop, "SLICE", 100)
    agent, env = fresh(wander_model, settings)
    run, slices = compiled_loop.make_run(agent.method, begin, outcome), []

    def run_and_press(*arguments):
        slices.append(run(*arguments))
        if len(slices) == pressed_in:
            signal.raise_signal(
                signal.SIGINT
            )  # the interpreter hears of it when it is back from the kernel
        return slices[-1]

    monkeypatch.setattr(compiled_loop, "make_run", lambda *of: run_and_press)
    with pytest.raises(
        KeyboardInterrupt, match=r"Stopped after about [0-9]+ of 1,000 steps"
    ) as stopped:
        rl.learn(agent, env, 1000, progress=False)
    assert stopped.value._render_traceback_() == [str(stopped.value)], (
        "one line in a notebook"
    )
    assert agent.visits.sum() == 100 * pressed_in
    rl.learn(agent, env, 1000 - 100 * pressed_in, progress=False, resume=True)
    other, twin = fresh(wander_model, settings)
    rl.learn(other, twin, 1000, progress=False)
    assert same_state(agent, env, other, twin)


def test_ctrl_c_during_a_long_run_is_heard_within_a_few_slices(
    wander_model, monkeypatch, ctrl_c
):
    agent, env = fresh(wander_model, {})
    rl.learn(agent, env, 1, progress=False)  # compiles
    is_running = threading.Event()

    class Bar(progress.tqdm):
        def update(self, n=1):
            is_running.set()

    monkeypatch.setattr(progress, "tqdm", Bar)
    before = []

    def press():
        is_running.wait(60)
        before.append(agent.visits.sum())
        _thread.interrupt_main()

    thread = threading.Thread(target=press)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            rl.learn(agent, env, 3 * 10**7, progress=False)
    finally:
        thread.join()
    assert (
        agent.visits.sum() - before[0] < 20 * compiled_loop.SLICE
    )  # one or two, on a machine that does nothing else


def test_the_bar_moves_with_every_slice(wander_model, monkeypatch):
    monkeypatch.setattr(compiled_loop, "SLICE", 100)
    moves = []

    class Bar(progress.tqdm):
        def update(self, n=1):
            moves.append(n)

    monkeypatch.setattr(progress, "tqdm", Bar)
    rl.learn(*fresh(wander_model, {}), 350, progress=True)
    assert moves == [100, 100, 100, 50]
