"""A red card's button: the robot drives by any function that a learner may write, and nothing breaks or hangs."""

import time
from importlib import import_module

import numpy as np
import pytest

from rlrobot_course.drives.beside import ALIKE, NOTHING, Beside, beside
from rlrobot_course.drives.by_your_code import FILMED, drive_of, driven
from rlrobot_grading.exercises.exercise import Exercise

DRIVEN = {
    "reward": "01",
    "target": "03",
    "update": "03",
    "learn": "03",
    "draw": "04",
    "dutch": "08",
    "choose": "10",
    "learn_and_evade": "10",
    "arm_reward": "13",
    "follow_reward": "16",
}


def exercise(name: str) -> Exercise:
    lesson = import_module(f"rlrobot_course.lesson_{DRIVEN[name]}")
    return getattr(lesson.check, name)


def shown(name: str, answer) -> Beside:
    asked = exercise(name)
    drive = drive_of(asked)
    assert drive is not None
    return beside(drive, asked.right, answer)


@pytest.mark.parametrize("name", DRIVEN)
def test_a_right_function_drives_as_the_right_one(name):
    found = shown(name, exercise(name).right)
    assert set(found.films) == {"yours", "right"}
    assert 0 < len(found.films["yours"].frames) <= FILMED
    assert ALIKE in found.said


def endless(*_):
    while True:
        pass


def divides(*_):
    return 1 / 0


def catches_all(*_):
    while True:
        try:
            while True:
                pass
        except Exception:
            pass


WRONG = {
    "endless": endless,
    "an error": divides,
    "holds on to its loop": catches_all,
    "NaN": lambda *_: float("nan"),
    "None": lambda *_: None,
    "text": lambda *_: "ahead",
    "a huge number": lambda *_: 10**400,
    "no such action": lambda *_: 99,
    "leaves": lambda *_: exit(),
    "an array": lambda *_: np.zeros((3, 3)),
    "wrong arguments": lambda: 0,
}


@pytest.mark.parametrize("what", WRONG)
@pytest.mark.parametrize("name", ["reward", "draw", "update", "learn_and_evade"])
def test_whatever_a_function_does_there_is_a_film_or_a_sentence(name, what, capsys):
    found = shown(name, WRONG[what])
    assert found.films or NOTHING in found.said
    assert found.said
    assert not capsys.readouterr().out


@pytest.mark.parametrize("name", ["reward", "update"])
def test_what_never_ends_is_stopped_and_told(name):
    begin = time.process_time()
    found = shown(name, endless)
    assert "takes too long" in found.said or "goes on" in found.said
    assert time.process_time() - begin < 20


def test_a_drive_of_one_function_is_the_same_whenever_it_is_driven():
    asked = exercise("draw")
    drive = drive_of(asked)

    def first(p, u):
        return 0

    one, other = driven(drive, first), driven(drive, first)
    assert [reward for _, reward in one.shots] == [reward for _, reward in other.shots]
    assert one.note == other.note


def test_a_wrong_reward_is_told_apart_from_the_right_one():
    found = shown("reward", lambda before, after: 0)
    assert "By your code the robot earns" in found.said


def test_only_functions_that_drive_a_robot_have_a_drive():
    check = import_module("rlrobot_course.lesson_01").check
    assert drive_of(check.reward) and not drive_of(check.bin_of)
