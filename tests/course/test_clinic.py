"""The clinic: the best loop in a model of what a robot saw, beside what agents earn."""

from dataclasses import replace

import pytest

import rlrobot_edu as rl
from rlrobot_course.worlds.clinic import clinic


@pytest.fixture(scope="module")
def shuttle():
    """Paid for coming nearer to the corner, and for nothing else: to and fro pays most."""

    def away(readings):
        return abs(readings["x"] - 0.5)

    def reward(before, after):
        return 10 if away(before) - away(after) > 0.02 else -0.4

    return clinic(
        replace(
            rl.load_task("wander_simple"),
            reward=reward,
            rewards=[-0.4, 10],
            command=None,
        ),
        steps=200,
    )


def test_the_best_loop_is_the_one_that_a_reward_can_be_milked_for(shuttle):
    assert shuttle.loop in ("10 -0.4 " * 5 + "10 -0.4", "-0.4 10 " * 5 + "-0.4 10")
    assert shuttle.best >= shuttle.rewards[-100:].mean() - 0.1


def test_its_table_goes_on_from_that_of_the_check(shuttle):
    rows = shuttle.table().rows
    assert [row[0] for row in rows[:-2]] == [
        row[0] for row in shuttle.check.learner.rows
    ]
    assert (rows[-2][1], rows[-1][1]) == (shuttle.best, shuttle.rewards.mean())


def test_one_seed_one_result_and_a_film_of_the_loop(shuttle):
    again = clinic(shuttle.task, steps=200)
    assert repr(again) == repr(shuttle) and again.loop == shuttle.loop
    assert len(shuttle.film(5).frames) > 0
