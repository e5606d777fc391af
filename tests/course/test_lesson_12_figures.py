"""Lesson 12's worlds and figures say what the numbers say."""

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.figures.paths import drive, length_of
from rlrobot_course.lesson_12.episodes import drive_episodes
from rlrobot_course.lesson_12.exercises import shaping, to_and_fro
from rlrobot_course.lesson_12.figures import corridor_finding, film_in_lane
from rlrobot_course.lesson_12.room import plot_ways
from rlrobot_course.lesson_12.worlds import AWAY, NEARER, Corridor, OwnReward, lane

TASK = rl.load_task("navigation_1k")


def best_values(pay, gamma=0.9, n=6):
    """Optimal Q of the corridor by value iteration, array (n + 1, 2); a textbook's, for an oracle."""
    q = np.zeros((n + 1, 2))
    for _ in range(500):
        v = q.max(axis=1)
        for s in range(n):
            for a in (AWAY, NEARER):
                world = Corridor(pay, n)
                world.s = s
                s_next, r, terminated, _ = world.step(a)
                q[s, a] = r + gamma * v[s_next] * (not terminated)
    return q[:n]


def trap(s, s_next, at_goal):
    return 10.0 if at_goal else (5.0 if s_next > s else -1.0)


def honest(s, s_next, at_goal):
    return 10.0 if at_goal else -0.1


def test_to_and_fro_is_best_before_the_goal_if_it_pays_and_is_worth_what_the_formula_says():
    q = best_values(trap)
    assert q[5].argmax() == AWAY and (q[:5].argmax(axis=1) == NEARER).all()
    assert q[4].max() == pytest.approx(to_and_fro)


@pytest.mark.parametrize("seed", range(5))
def test_shaping_with_any_potential_leaves_the_best_actions_as_they_are(seed):
    phi = np.random.default_rng(seed).normal(0, 20, size=7)

    def shaped(s, s_next, at_goal):
        return honest(s, s_next, at_goal) + shaping(phi[s], phi[s_next], at_goal, 0.9)

    q, led = best_values(honest), best_values(shaped)
    assert np.allclose(led, q - phi[:6, None]), (
        "all values move by the potential of the state"
    )


def test_a_robot_is_paid_by_its_own_function_and_all_else_stays():
    env, twin = (
        OwnReward(
            rl.make_env(TASK, seed=0),
            lambda before, after, r, end: r + after["x"] - before["x"],
        ),
        None,
    )
    twin = rl.make_env(TASK, seed=0)
    (observation, info), (same, _) = env.reset(), twin.reset()
    assert isinstance(env, gymnasium.Wrapper) and (observation == same).all()
    x = info["readings"]["x"]
    for a in (8, 0, 5):
        observation, reward, *ends, info = env.step(a)
        same, r, *same_ends, _ = twin.step(a)
        assert (observation == same).all() and ends == same_ends
        assert reward == pytest.approx(r + info["readings"]["x"] - x)
        x = info["readings"]["x"]


def test_episodes_are_whole():
    short = rl.Agent(TASK, seed=0)
    env = gymnasium.wrappers.TimeLimit(rl.make_env(TASK, seed=0), 25)
    episodes = drive_episodes(short, env, 3)
    assert [len(episode) for episode in episodes] == [25, 25, 25] and not any(
        e.terminated for e in episodes
    )
    assert all(episode.path.shape == (26, 2) for episode in episodes)
    assert all((episode.path[0] == (-1.5, -1.475)).all() for episode in episodes)
    assert len(drive_episodes(short, env, 3, most=60)) == 2, "the third is not finished"


def test_a_path_is_where_the_commands_lead():
    path = drive(rl.make_env("wander_1k", seed=0), [8, 8, 0, 4])
    assert path[:, 1] == pytest.approx(np.zeros(5)) and length_of(
        path
    ) == pytest.approx(4 * 0.0975)
    assert path[:, 0] == pytest.approx(np.array([0, 1, 2, 4, 4]) * 0.0975)


def test_a_film_in_the_lane_ends_at_the_goal_or_after_so_many_steps():
    forward = np.tile([0.0, 1.0], (8, 1))
    for steps, shown in ((24, 6), (4, 4)):
        film = film_in_lane(forward, rl.make_env(lane(), seed=0), steps)
        assert repr(film) == f"<Film of {shown} steps>"


def test_the_title_of_the_ways_tells_their_lengths():
    episodes = drive_episodes(
        rl.Agent(TASK, seed=0),
        gymnasium.wrappers.TimeLimit(rl.make_env(TASK, seed=0), 25),
        2,
    )
    said = plot_ways(TASK, episodes, [1, 2]).finding
    assert said == "Still no shorter: from 25 steps in episode 1 to 25 in episode 2"


def test_the_title_of_the_corridor_names_the_reward_that_turns_back():
    on = np.zeros((7, 2))
    on[:, NEARER] = 1.0
    back = on.copy()
    back[5, AWAY] = 2.0
    said = corridor_finding({"a": back, "b": on, "c": on})
    assert said == "“a” turns back before the goal; the other 2 lead into it"
    assert corridor_finding({"b": on}) == "Each of these rewards leads to the goal"
