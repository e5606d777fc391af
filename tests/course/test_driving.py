"""A person drives a robot, here by pressing buttons from Python, and an agent learns from what was driven."""

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.robot_cards import WHEELS
from rlrobot_edu.task.task_file import available_tasks
from rlrobot_edu.widgets.driving.keys import buttons_of, keys_of
from rlrobot_edu.widgets.driving.pad import teleoperate
from rlrobot_edu.widgets.driving.teaching import learn_from


@pytest.fixture
def pad():
    with rl.make_env("wander_1k", seed=0) as env:
        yield teleoperate(env)


@pytest.mark.parametrize(
    "method", ["Q+SR", "SARSA+EG", "ESARSA+SR", "SL+SR", "TOSL+QBIASSR"]
)
def test_who_is_taught_by_an_agents_recording_knows_what_that_agent_learned(method):
    env = gymnasium.make(
        "FrozenLake-v1", is_slippery=False
    )  # its episodes end soon, in a hole
    acting = rl.Agent(env, method, loop_evasion=False, seed=1)
    history = rl.learn(acting, env, episodes=30, keep=True, progress=False)
    source = Source.of_env(env, history.rewards)
    recording = rl.Recording(history.transitions, source)
    assert recording.terminated[-1], (
        "what is cut off would end with a choice of the agent's own"
    )
    taught = rl.Agent(env, method)
    learn_from(taught, recording)
    np.testing.assert_array_equal(taught.q, acting.q)
    np.testing.assert_array_equal(taught.visits, acting.visits)


def test_several_passes_teach_more_and_other_tasks_nothing():
    recording = rl.read_recording("wander_simple")
    once, twice = (rl.Agent("wander_simple", "Q+SR", seed=0) for _ in range(2))
    learn_from(once, recording)
    learn_from(twice, recording, passes=2)
    assert twice.visits.sum() == 2 * once.visits.sum() == 2 * len(recording)
    with pytest.raises(
        ValueError, match=r"states \(4, .* make the agent from its task, wander_simple"
    ):
        learn_from(rl.Agent("wander_1k"), recording)
    with pytest.raises(ValueError, match="passes must be a whole number of at least 1"):
        learn_from(once, recording, passes=0)


def test_the_taught_agent_goes_on_with_new_episodes():
    agent = rl.Agent("wander_simple", seed=0)
    learn_from(agent, rl.read_recording("wander_simple"))
    with rl.make_env("wander_simple", seed=0) as env:
        assert len(rl.learn(agent, env, steps=10, progress=False)) == 10


def test_what_is_driven_is_a_recording(pad, tmp_path):
    rewards = [pad.press(a) for a in (8, 8, 2, 8)]
    pad.start_again()
    pad.press(8)
    recording = pad.recording
    assert (
        recording.a.tolist() == [8, 8, 2, 8, 8] and recording.r[:4].tolist() == rewards
    )
    assert (
        recording.episode.tolist() == [0, 0, 0, 0, 1]
        and recording.source.method == "by hand"
    )
    assert recording.s_next[:3].tolist() == recording.s[1:4].tolist()
    recording.save(tmp_path / "mine")
    assert (
        rl.read_recording(tmp_path / "mine", task="wander_1k").a.tolist()
        == recording.a.tolist()
    )
    assert len(pad.film.frames) == 5


def test_an_episode_that_has_ended_begins_anew():
    with rl.make_env("navigation_1k", seed=0) as env:
        pad, n = teleoperate(env), env.unwrapped.task.episode_steps
        for _ in range(n + 1):
            pad.press(4)  # stands still
    assert pad.recording.episode[-1] == 1 and pad.recording.truncated[n - 1]


def test_nothing_is_recorded_before_the_first_step(pad):
    with pytest.raises(ValueError, match="nothing has been driven yet"):
        _ = pad.recording
    with pytest.raises(ValueError, match="there is no action 9"):
        pad.press(9)
    with pytest.raises(ValueError, match="no robot"):
        teleoperate(gymnasium.make("CliffWalking-v1"))


def test_clicks_drive_and_are_told(pad):
    pad.widget  # noqa: B018 - made when it is first asked for
    first = pad._picture.shown
    button(pad, "rl-action-8").click()
    assert len(pad.recording) == 1 and pad._picture.shown != first
    assert "reward +10" in pad._said.value and 'aria-live="polite"' in pad._said.value
    assert "image/gif" in pad.still().mime
    button(pad, "start again").click()
    assert pad.recording.truncated[-1]


def button(pad, about):
    """The button of the pad with this text, or with this class of the page."""
    names = (
        (w, (getattr(w, "description", ""), *getattr(w, "_dom_classes", ())))
        for w in walk(pad.widget)
    )
    return next(w for w, its in names if about in its)


def test_the_pad_counts_its_steps_also_after_a_new_start():
    with rl.make_env("wander_1k", seed=0) as env:
        pad = teleoperate(env)
        ahead, again = button(pad, "rl-action-8"), button(pad, "start again")
        for _ in range(5):
            ahead.click()
        assert "On average +10.00 in 5 steps" in pad._said.value
        again.click()
        ahead.click()
        assert "On average +10.00 in 6 steps" in pad._said.value


def walk(widget):
    yield widget
    for child in getattr(widget, "children", ()):
        yield from walk(child)


@pytest.mark.parametrize("name", available_tasks())
def test_everything_a_robot_can_do_has_one_button_and_a_key(name):
    task = rl.load_task(name)
    buttons, keys = buttons_of(task), keys_of(task)
    commands = [task.command_for(a) for a in range(task.actions.n)]
    assert len(buttons) == len({tuple(command.values()) for command in commands})
    assert len({(b.place, b.text) for b in buttons}) == len(buttons), (
        "no two buttons look alike"
    )
    assert len({b.key for b in buttons if b.key}) == min(len(buttons), 35) and set(
        keys.values()
    ) <= {b.a for b in buttons}


def test_keys_follow_the_buttons_row_by_row_and_a_new_start_has_a_new_trail(pad):
    buttons = buttons_of(rl.load_task("wander_1k"))
    assert [b.key for b in buttons] == list("1234567") and [
        b.place for b in buttons
    ] == sorted(b.place for b in buttons)
    for a in (8, 8, 8):
        pad.press(a)
    pad.start_again()
    pad.press(8)
    assert len(pad) == 4 and len(pad._way) == 2


def test_arrows_drive_where_they_point():
    task = rl.load_task("wander_1k")
    speeds = {
        key: tuple(task.command_for(a)[w] for w in WHEELS)
        for key, a in keys_of(task).items()
    }
    assert speeds["ArrowUp"] == (1, 1) and speeds["ArrowLeft"] == (-1, 1)
    assert speeds["ArrowRight"] == (1, -1) and speeds["ArrowDown"] == (0, 0)
    assert {b.text: b.place for b in buttons_of(task)}["↖"] == (0, 0)


def test_what_a_task_says_reaches_the_page_as_text():
    pad = teleoperate(rl.make_env("wander_simple", seed=0))
    assert pad.widget is not None
    pad._show("<u>said</u>")
    assert "&lt;u&gt;said" in pad._said.value and "textContent" in pad._keyboard._esm, (
        "and no HTML of anybody's"
    )
