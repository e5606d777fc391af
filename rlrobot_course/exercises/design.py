"""Exercises in which a reward is designed: it is tried on pairs of situations, one wanted and one not."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, ClassVar

from rlrobot_edu.task.task import Task
from rlrobot_grading.answers.limits import attempt
from rlrobot_grading.answers.replay import Case, Outcome
from rlrobot_grading.answers.values import Function, as_data, kept, safely, show
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.hints.evidence import Evidence, Hint

Readings = dict[str, float]
Pay = Callable[[Readings, Readings], float]
NO_NUMBER = "no number:"  # how a pay that is none is told
ANOTHER = (
    "pays otherwise when it is asked again"  # how a function that remembers is told
)
# what the lasers read where nothing is near [m]
FREE = dict.fromkeys(
    (
        "laser_front",
        "laser_front_left",
        "laser_left",
        "laser_rear_left",
        "laser_rear",
        "laser_rear_right",
        "laser_right",
        "laser_front_right",
    ),
    1.4,
)
NOTHING: Mapping[str, float] = MappingProxyType({})  # that is near
ONE_WHEEL = 0.29  # by how much a step turns the robot that turns one wheel [rad]
READ = ("before", "after")  # arguments of the learner's function
Place = tuple[float, float]  # x and y [m]
Situation = tuple[
    str, Readings, Readings
]  # name of a step of the robot, readings before and after it


def metres(distance: float) -> str:
    """A distance in words: in centimetres where it is one, else down to a tenth of a millimetre."""
    is_whole = abs(distance - round(distance, 2)) < 5e-5
    return f"{distance:.2f}" if is_whole else f"{distance:.4f}"


def way(before: Mapping[str, float], after: Mapping[str, float]) -> str:
    """How a step has moved the robot, in words."""
    dx, dy = after["x"] - before["x"], after["y"] - before["y"]
    return f"moved by ({metres(dx)}, {metres(dy)}) m"


def heading(way: Place) -> float:
    """Where the robot looks that drives this way in x and y [rad]."""
    dx, dy = way
    return math.atan2(dy, dx)


def unasked(lasers: Sequence[str]) -> list[Readings]:
    """Readings in which something is near where none of `lasers` looks, one laser at a time."""
    return [{laser: 0.03} for laser in FREE if laser not in lasers]


def moved(
    name: str,
    start: Place,
    by: Place,
    before: Readings,
    after: Readings,
    theta: float = 0.0,
    turned: float = 0.0,
) -> Situation:
    """A step that moved the robot from `start` by so much in x and y [m].

    before, after: its lasers, of those that are not `FREE`; theta: its heading before the step; turned: by how much the
    step turned it [rad]
    """
    (x, y), (dx, dy) = start, by
    was = FREE | {"x": x, "y": y, "theta": theta} | before
    now = FREE | {"x": x + dx, "y": y + dy, "theta": theta + turned} | after
    return name, was, now


@dataclass(frozen=True)
class Design(Exercise):
    """An exercise in which a reward is designed: any function is right that pays more for what is wanted.

    A step of the tape holds two situations, `wanted` and `unwanted`; the function is called twice with each one's
    readings, for a reward may not depend on anything else.

    words: the readings before and after a step, for a learner
    """

    is_exact: ClassVar[bool] = False
    words: Callable[[Readings, Readings], str] = way

    def outcome(self, answer: Function, case: Case, endless: bool = False) -> Outcome:
        paid, printed, spoilt = [], "", []
        for _, before, after in 2 * tuple(case.values()):
            given = dict(before), dict(after)
            pay, failure, more = attempt(answer, *given, endless=endless)
            printed += more
            spoilt += [
                name
                for name, was, now in zip(READ, (before, after), given, strict=True)
                if was != now
            ]
            if failure:
                return Outcome({}, tuple(dict.fromkeys(spoilt)), failure, printed)
            paid.append(as_data(pay))
        better = safely(kept(paid), self._better, case, paid)
        return Outcome(
            {self.returns: better}, tuple(dict.fromkeys(spoilt)), None, printed
        )

    def hint_on(self, seen: Evidence) -> Hint:
        told = [outcome.values.get(self.returns) for outcome in seen.got]
        if any(isinstance(text, str) and text.startswith(NO_NUMBER) for text in told):
            return Hint(
                "no_number",
                "a reward is one finite number, without quotation marks or brackets.",
            )
        hint = super().hint_on(seen)
        if ANOTHER in told and hint.id != "chance":
            return Hint(
                "remembers",
                "a reward looks at before and after alone. Does yours count something?",
            )
        return Hint(hint.id, hint.text.replace(self.returns, "reward"))

    def _better(self, case: Case, paid: Sequence[Any]) -> str | None:
        """Which of the two situations is paid more for; None where nothing is returned, and words for no reward."""
        if any(pay is None for pay in paid):
            return None
        for pay in paid:
            if isinstance(
                pay, str | list | tuple | dict | set | complex
            ) or not math.isfinite(pay):
                return f"{NO_NUMBER} {show(pay)}"
        if paid[:2] != paid[2:]:
            return ANOTHER
        more = float(paid[0]) - float(paid[1])
        better, worse = (name for name, _, _ in case.values())
        if more > 1e-12:
            return better
        if more < -1e-12:
            return worse
        return "both pay the same"

    def _called(self, case: Case) -> str:
        return "; and with ".join(
            f"“{name}”: {self.words(before, after)}"
            for name, before, after in case.values()
        )


def paid_by(
    task: Task, reward: Pay, pairs: Sequence[tuple[Situation, Situation]]
) -> Task:
    """`task` with a learner's own reward.

    A task names all rewards beforehand, the largest above 0. So a reward counts as the nearest of those that are paid
    in the situations of `pairs`; and if none of these is above 0, all are raised by the same amount.
    """
    paid = [
        float(reward(dict(before), dict(after)))
        for pair in pairs
        for _, before, after in pair
    ]
    raised = max(0.0, 1 - max(paid)) if max(paid) <= 0 else 0.0
    values = sorted({pay + raised for pay in paid})

    def nearest(before: Mapping[str, float], after: Mapping[str, float]) -> float:
        pay = float(reward(dict(before), dict(after))) + raised
        return min(values, key=lambda value: abs(value - pay))

    return replace(task, reward=nearest, rewards=values)
