"""The course's short world: a loop that the learner writes meets what the library's agent meets, number for number."""

import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_04 import exercises as lesson_04
from rlrobot_course.lesson_06 import exercises as lesson_06
from rlrobot_course.worlds.short_world import ShortWorld


def arena():
    return rl.make_env("wander_simple", seed=0)


def lake():
    return gymnasium.make("FrozenLake-v1", is_slippery=False)


def yours(env, seed, steps):
    world = ShortWorld(env, seed)
    q = world.table()

    def choose(q, s):
        x = lesson_04.normalise(q[s], world.r_max, 0.9)
        return lesson_04.draw(lesson_04.softmax(x, 1.0), world.u)

    def update(q, s, a, r, s_next, a_next, terminated):
        lesson_06.sarsa_update(q, s, a, r, s_next, a_next, terminated, 0.1, 0.9)

    lesson_06.sarsa_learn(world, q, choose, update, steps)
    return world.history(q)


@pytest.mark.parametrize("make", [arena, lake])
def test_a_learners_loop_learns_what_the_librarys_agent_learns(make):
    mine, env = yours(make(), 5, 300), make()
    history = rl.learn(
        rl.Agent(env, "SARSA+SR", seed=5, loop_evasion=False),
        env,
        300,
        keep=True,
        progress=False,
    )
    assert np.array_equal(mine.a, history.a)
    assert np.array_equal(mine.average_reward, history.average_reward)
    np.testing.assert_allclose(mine.q, history.q, atol=1e-12)
    assert np.array_equal(mine.visits, history.visits)


def test_a_world_in_which_nothing_happened_has_a_history_of_no_steps():
    world = ShortWorld(gymnasium.make("FrozenLake-v1"))
    assert len(world.history(world.table())) == 0
    assert "0 steps old" in repr(world)
