"""Lesson 01's free exercise, a reward of one's own design, and the situations on which it is tried."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.limits import attempt
from rlrobot_edu.course.grading.replay import Case, Outcome
from rlrobot_edu.course.grading.values import kept, safely

Readings = dict[str, float]
READ = ("before", "after")  # arguments of the learner's function
Situation = tuple[str, Readings, Readings]  # name of a step of the robot, readings before and after it


@dataclass(frozen=True)
class Design(Exercise):
    """An exercise in which a reward is designed: any function is right that pays more for what is wanted.

    A step of the tape holds two situations, `wanted` and `unwanted`; the function is called with each one's readings.
    """

    def _outcome(self, answer: Callable[..., Any], case: Case, endless: bool = False) -> Outcome:
        paid, printed = [], ""
        for _, before, after in case.values():
            given = dict(before), dict(after)
            pay, failure, more = attempt(answer, *given, endless=endless)
            printed += more
            spoilt = tuple(name for name, was, now in zip(READ, (before, after), given, strict=True) if was != now)
            if failure or spoilt:
                return Outcome({}, spoilt, failure, printed)
            paid.append(pay)
        return Outcome({self.returns: safely(kept(paid), self._better, case, paid)}, printed=printed)

    def _better(self, case: Case, paid: Sequence[Any]) -> str | None:
        """Which of the two situations is paid more for; None where nothing is returned, and words for a text."""
        if any(pay is None or isinstance(pay, str) for pay in paid):
            return next((f"text: {pay!r}" for pay in paid if isinstance(pay, str)), None)
        more = float(paid[0]) - float(paid[1])
        better, worse = (name for name, _, _ in case.values())
        return better if more > 1e-12 else worse if more < -1e-12 else "both pay the same"

    def _called(self, case: Case) -> str:
        return "; and with ".join(
            f"“{name}”: moved by ({after['x'] - before['x']:.2f}, {after['y'] - before['y']:.2f}) m, lasers after it "
            f"{after['laser_front_left']:.2f} and {after['laser_front_right']:.2f} m"
            for name, before, after in case.values()
        )


def situation(
    name: str,
    moved: tuple[float, float] = (0.0, 0.0),
    before: tuple[float, float] = (0.9, 0.9),
    after: tuple[float, float] = (0.9, 0.9),
) -> Situation:
    """A step that moved the robot by `moved` in x and y [m]; before, after: lasers left and right [m]."""
    start = {"x": 2.0, "y": 1.0, "laser_front_left": before[0], "laser_front_right": before[1]}
    end = {"x": 2.0 + moved[0], "y": 1.0 + moved[1], "laser_front_left": after[0], "laser_front_right": after[1]}
    return name, start, end


STANDS = situation("stands still")
TURNS = situation("turns on the spot", (0.018, 0.018), (0.9, 0.9), (0.4, 1.2))  # x, y are measured behind the axle
CREEPS = situation("creeps 0.05 m", (0.05, 0), (0.9, 0.9), (0.85, 0.85))

PAIRS = (
    (situation("drives in +x", (0.1, 0), (1.0, 1.0), (0.9, 0.9)), STANDS),
    (situation("drives in −x", (-0.1, 0), (0.6, 0.7), (0.5, 0.6)), TURNS),
    (situation("drives in +y", (0, 0.1), (1.0, 1.0), (0.9, 0.9)), STANDS),
    (situation("drives in −y", (0, -0.1), (1.0, 1.0), (0.9, 0.9)), STANDS),
    (situation("drives askew", (-0.06, -0.06), (1.0, 1.0), (0.9, 0.9)), TURNS),
    (situation("drives askew", (0.06, -0.06), (1.0, 1.0), (0.9, 0.9)), STANDS),
    (situation("drives 0.3 m", (0.3, 0), (1.3, 1.3), (1.0, 1.0)), STANDS),
    (situation("drives 0.08 m", (0.08, 0), (1.0, 1.0), (0.95, 0.9)), CREEPS),
    (
        situation("drives 0.08 m", (0, 0.08), (1.0, 1.0), (0.95, 0.9)),
        situation("creeps askew, 0.064 m", (0.045, 0.045), (0.9, 0.9), (0.85, 0.8)),
    ),
    (situation("drives past a wall", (0.1, 0), (0.9, 0.11), (0.9, 0.11)), STANDS),
    (situation("drives out of a corner", (0.1, 0), (0.11, 0.9), (0.2, 0.11)), STANDS),
    (STANDS, situation("runs into a wall", (0.02, 0), (0.12, 0.12), (0.04, 0.04))),
    (STANDS, situation("leans on a wall, left", (0, 0), (0.04, 0.3), (0.04, 0.3))),
    (STANDS, situation("leans on a wall, right", (0, 0), (0.3, 0.08), (0.3, 0.08))),
    (
        situation("turns away from a wall", (0, 0), (0.05, 0.3), (0.15, 0.4)),
        situation("stays at it", (0, 0), (0.05, 0.3), (0.05, 0.3)),
    ),
    (
        situation("drives away from a wall", (0.1, 0), (0.3, 0.08), (0.3, 0.18)),
        situation("scrapes along it", (0.1, 0), (0.3, 0.08), (0.3, 0.08)),
    ),
    (TURNS, situation("scrapes along a wall, left", (0.1, 0), (0.3, 0.9), (0.08, 0.9))),
    (STANDS, situation("scrapes along a wall, right", (0.06, 0.06), (0.9, 0.3), (0.9, 0.08))),
)
