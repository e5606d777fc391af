"""Environments that draw themselves, as Gymnasium's wrappers ask for it."""

import copy
import warnings
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.wrappers import RecordVideo, RenderCollection

import rlrobot_edu as rl
from rlrobot_edu.task.task_file import available_tasks


@pytest.fixture
def env():
    return gymnasium.make("rlrobot/wander_simple-v0", render_mode="rgb_array")


def test_a_picture_is_what_gymnasium_asks_for_and_shows_where_the_robot_has_gone(env):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)
    env.reset(seed=0)
    before = env.render()
    assert before.dtype == np.uint8 and before.shape == (331, 480, 3)
    assert np.array_equal(env.render(), before)
    env.unwrapped.robot.act({"left_wheel": 2.0, "right_wheel": 2.0})
    after = env.render()
    columns = [
        np.argwhere((p[..., 2] > 150) & (p[..., 0] < 30))[:, 1].mean()
        for p in (before, after)
    ]  # of blue
    assert (
        10 < columns[1] - columns[0] < 60
    )  # it has gone to the right, by 0.2 m of 2 m


def test_a_picture_before_the_first_reset_and_one_that_nobody_ordered_are_told_in_words(
    env,
):
    with pytest.raises(
        gymnasium.error.ResetNeeded, match=r"reset\(\) before the first render"
    ):
        env.unwrapped.render()
    blind = rl.make_env("wander_simple")
    blind.reset()
    with pytest.warns(UserWarning, match="render_mode='rgb_array'"):
        assert blind.render() is None


def test_what_cannot_be_drawn_is_refused_in_one_sentence(wander_model):
    for make in (
        rl.make_env,
        lambda name, **mode: gymnasium.make(f"rlrobot/{name}-v0", **mode),
    ):
        with pytest.raises(
            ValueError, match="None, 'rgb_array' or 'ansi', got 'human'"
        ):
            make("wander_simple", render_mode="human")
    with pytest.raises(TypeError, match="render_mode"):
        rl.make_env(wander_model, render_mode="rgb_array")


def test_pictures_of_a_whole_episode_can_be_collected(env):
    collection = RenderCollection(env)
    collection.reset(seed=0)
    for _ in range(3):
        collection.step(3)  # ahead
    frames = collection.render()
    assert len(frames) == 4 and len({frame.tobytes() for frame in frames}) == 4


def test_a_video_is_recorded(env, tmp_path):
    pytest.importorskip("moviepy", reason="Gymnasium's RecordVideo needs moviepy")
    video = RecordVideo(env, str(tmp_path / "video"), video_length=5)
    video.reset(seed=0)
    for _ in range(6):
        video.step(0)
    video.close()
    (file,) = Path(tmp_path, "video").glob("*.mp4")
    assert file.stat().st_size > 1000


def test_a_copy_of_an_environment_that_has_drawn_draws_its_own_world(env):
    env.reset(seed=0)
    first, twin = env.render(), copy.deepcopy(env)
    env.step(0)
    assert np.array_equal(twin.render(), first)
    twin.step(0)
    assert np.array_equal(twin.render(), env.render())


LIBRARY = Path(__file__).parents[2] / "docs" / "library.md"


def test_the_loop_of_ones_own_on_the_page_of_the_library_counts_episodes_and_learns(
    capsys,
):
    section = LIBRARY.read_text(encoding="utf-8").split("\n## Gymnasium\n")[1]
    program = section.split("```python\n")[1].split("```")[0]
    names = {}
    exec(program, names)
    assert [line.split()[-1] for line in capsys.readouterr().out.splitlines()] == [
        "500"
    ] * 5
    q, env = names["q"], names["env"]
    rows = q.reshape(-1, env.action_space.n)
    assert q.any() and len(rows) == names["bins"].prod() == 1024
    assert (rows[names["info"]["state"]] == q[tuple(names["s"])]).all()


def test_a_world_says_in_words_where_the_robot_is_and_what_it_reads():
    for task in available_tasks():
        env = gymnasium.make(f"rlrobot/{task}-v0", render_mode="ansi")
        env.reset(seed=0)
        first, second = env.render().splitlines()
        assert first.startswith("Step 0. A ")
        for name in env.unwrapped.task.inputs:
            assert f"{name.name} = " in second
    cells = rl.make_env("worked_example", seed=0, render_mode="ansi")
    cells.reset()
    assert cells.render().endswith("X = 0, Y = 0, theta = 0 deg, d = 0, bumped = 0")
