"""A learner's function in the place of the right one, for as long as a robot drives by it."""

import importlib
import importlib.util
import math
import re
import time
from collections import deque
from collections.abc import Callable, Iterable
from numbers import Real
from typing import Any, NamedTuple

import numpy as np

from rlrobot_course.exercises.design import Pay, Readings
from rlrobot_edu.robots.scene import Scene
from rlrobot_grading.answers.limits import TooLong, attempt
from rlrobot_grading.answers.values import Function, one_line, safely, show
from rlrobot_grading.exercises.exercise import Exercise

SECONDS = 1.5  # of computing that a learner's function may take in a whole drive
PATIENCE = 10.0  # of waiting, as in time.sleep [s]
FILMED = 60  # the last steps of a drive


class Stopped(Exception):
    """A drive cannot go on; says what the learner's function did."""


class Enough(BaseException):
    """A loop goes on after its last step. No Exception: ``except Exception`` in the loop must not hold it up."""


class Reel:
    """The last steps of a drive.

    shots: the scene after each, and its reward; note: what else is to be said of the drive
    """

    def __init__(self) -> None:
        self.shots: deque[tuple[Scene, float]] = deque(maxlen=FILMED)
        self.note = ""

    def take(self, scene: Scene, reward: float) -> None:
        """Film a step."""
        self.shots.append((scene, float(reward)))

    def follow(
        self, walk: Iterable[object], robot: Any, reward: Pay, before: Readings
    ) -> None:
        """Film each step of a walk, with what a reward pays for it.

        robot: that goes; reward: of the readings before and after a step; before: the readings at the beginning
        """
        for _ in walk:
            after = robot.readings
            self.take(robot.scene(), reward(before, after))
            before = after


Drive = Callable[[Function, Reel], None]


class Guarded:
    """A learner's function as a check calls it: it can neither go on for ever nor print.

    function: the learner's
    Raises Stopped where it fails, or where all calls together take too long.
    """

    def __init__(self, function: Function) -> None:
        self.function = function
        self._calls = 0
        self._left = SECONDS

    def __call__(self, *arguments: Any) -> Any:
        """What the function returns; None where it went on after the last step of its world."""
        self._calls += 1
        begin = time.process_time()
        value, failure, _ = attempt(
            self.function,
            *arguments,
            seconds=self._left,
            patience=PATIENCE,
        )
        self._left -= time.process_time() - begin
        if failure and failure.kind == Enough.__name__:
            return None
        if failure and failure.kind != TooLong.__name__:
            raise Stopped(f"{failure.ends}{self._when()}")
        if failure or self._left <= 0:
            where = (
                f", in the line “{failure.line}”" if failure and failure.line else ""
            )
            raise Stopped(f"takes too long, and was stopped{where}{self._when()}")
        return value

    def _when(self) -> str:
        """In which of several calls."""
        return f" (call {self._calls})" if self._calls > 1 else ""


def number(value: Any) -> float:
    """What a reward has returned, if it is one finite number. Raises Stopped for anything else."""
    if isinstance(value, np.ndarray | np.generic) and value.ndim == 0:
        value = value.item()
    # a whole number may be too large for a float
    if not isinstance(value, Real) or not safely(False, math.isfinite, value):
        raise Stopped(f"returns {show(value)}, and a reward is one finite number")
    return float(value)


class Driven(NamedTuple):
    """A drive that is over.

    shots: its last steps, each with its reward; note: what became of the learner's function; empty if all went well
    is_whole: whether it went to its end
    """

    shots: list[tuple[Scene, float]]
    note: str
    is_whole: bool


def driven(drive: Drive, function: Function) -> Driven:
    """The drive by a function of the learner's, as far as it goes; raises nothing but KeyboardInterrupt."""
    reel, is_whole = Reel(), False
    try:
        drive(Guarded(function), reel)
        is_whole = True
    except Stopped as end:
        reel.note = f"Your function {end}."
    except Exception as error:
        said = one_line(str(error), 300) or type(error).__name__
        reel.note = f"The robot cannot go on: {said}."
    return Driven(list(reel.shots), reel.note, is_whole)


def drive_of(exercise: Exercise) -> Drive | None:
    """How a robot drives by the function of an exercise; None if none does."""
    lesson = re.fullmatch(r"rlrobot_course\.lesson_\d\d", _package(exercise))
    if lesson is None or importlib.util.find_spec(f"{lesson[0]}.drive") is None:
        return None
    drives: dict[str, Drive] = getattr(
        importlib.import_module(f"{lesson[0]}.drive"), "drives", {}
    )
    return drives.get(exercise.name)


def _package(exercise: Exercise) -> str:
    """The package of the lesson, or assignment, that an exercise belongs to."""
    return str(exercise.right.__module__).rpartition(".")[0]
