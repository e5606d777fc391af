"""Lesson 10's worlds."""

from rlrobot_course.lesson_10.worlds import Dice, Ring


def test_a_ring_ends_its_episodes_in_both_ways_and_its_dice_know_the_moment_alone():
    ring = Ring(12, ((2, True), (3, False)))
    dice = Dice(ring)
    assert ring.reset() == 0 and ring.step(1)[0] == 1
    assert dice.random() == dice.random()
    assert ring.step(0)[2:] == (True, False)
    assert ring.reset() == 7
    assert [ring.step(2)[2:] for _ in range(3)] == [(False, False)] * 2 + [
        (False, True)
    ]
