"""Lesson 01's free exercise, a reward of one's own design, and the situations on which it is tried."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.limits import attempt
from rlrobot_edu.course.grading.replay import Case, Outcome
from rlrobot_edu.course.grading.values import kept, safely, show

Readings = dict[str, float]
NO_NUMBER = "no number:"  # how a pay that is none is told
READ = ("before", "after")  # arguments of the learner's function
Situation = tuple[str, Readings, Readings]  # name of a step of the robot, readings before and after it


@dataclass(frozen=True)
class Design(Exercise):
    """An exercise in which a reward is designed: any function is right that pays more for what is wanted.

    A step of the tape holds two situations, `wanted` and `unwanted`; the function is called with each one's readings.
    """

    def _outcome(self, answer: Callable[..., Any], case: Case, endless: bool = False) -> Outcome:
        paid, printed, spoilt = [], "", []
        for _, before, after in case.values():
            given = dict(before), dict(after)
            pay, failure, more = attempt(answer, *given, endless=endless)
            printed += more
            spoilt += [name for name, was, now in zip(READ, (before, after), given, strict=True) if was != now]
            if failure:
                return Outcome({}, tuple(dict.fromkeys(spoilt)), failure, printed)
            paid.append(pay)
        better = safely(kept(paid), self._better, case, paid)
        return Outcome({self.returns: better}, tuple(dict.fromkeys(spoilt)), None, printed)

    def _hint(self, answer: Callable[..., Any], got: Sequence[Outcome]) -> str:
        told = [outcome.values.get(self.returns) for outcome in got]
        if any(isinstance(text, str) and text.startswith(NO_NUMBER) for text in told):
            return "a reward is one number, without quotation marks or brackets."
        return super()._hint(answer, got).replace(self.returns, "reward")

    def _better(self, case: Case, paid: Sequence[Any]) -> str | None:
        """Which of the two situations is paid more for; None where nothing is returned, and words for no number."""
        if any(pay is None for pay in paid):
            return None
        for pay in paid:
            if isinstance(pay, str | list | tuple | dict | set | complex):
                return f"{NO_NUMBER} {show(pay)}"
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
    start: tuple[float, float] = (2.0, 1.0),
) -> Situation:
    """A step that moved the robot from `start` by `moved` in x and y [m]; before, after: lasers left and right [m]."""
    (x, y), (dx, dy) = start, moved
    was = {"x": x, "y": y, "laser_front_left": before[0], "laser_front_right": before[1]}
    now = {"x": x + dx, "y": y + dy, "laser_front_left": after[0], "laser_front_right": after[1]}
    return name, was, now


STANDS = situation("stands still", start=(0.0, 0.0))
# x and y are measured behind the axle, so they change a little
TURNS = situation("turns on the spot", (0.018, 0.018), (0.9, 0.9), (0.4, 1.2), start=(0.0, 0.0))
FREE = (1.0, 1.0), (0.9, 0.9)  # lasers before and after

PAIRS = (
    (situation("drives in +x", (0.095, 0), *FREE, (-1.0, 0.5)), STANDS),
    (situation("drives in −x", (-0.095, 0), (0.6, 0.7), (0.5, 0.6)), TURNS),
    (situation("drives in +y", (0, 0.095), *FREE, (0.5, -1.0)), STANDS),
    (situation("drives in −y", (0, -0.095), *FREE), situation("stands still")),
    (situation("drives askew", (-0.06, -0.06), *FREE), TURNS),
    (situation("drives askew", (0.06, -0.06), *FREE), STANDS),
    (situation("drives askew, 0.11 m", (0.08, 0.08), *FREE, (-1.0, -1.0)), STANDS),
    (situation("drives 0.15 m", (0.15, 0), *FREE), STANDS),
    (situation("drives 0.3 m", (0.3, 0), (1.3, 1.3), (1.0, 1.0)), STANDS),
    (situation("drives 0.08 m", (0.08, 0), *FREE), situation("creeps 0.06 m", (0.06, 0), (0.9, 0.9), (0.85, 0.85))),
    (
        situation("drives 0.08 m", (0, 0.08), *FREE),
        situation("creeps askew, 0.064 m", (0.045, 0.045), (0.9, 0.9), (0.85, 0.8)),
    ),
    (situation("drives past a wall", (0.095, 0), (0.9, 0.11), (0.9, 0.11)), STANDS),
    (situation("drives out of a corner", (0.095, 0), (0.11, 0.9), (0.2, 0.11)), STANDS),
    (STANDS, situation("runs into a wall", (0.02, 0), (0.12, 0.12), (0.04, 0.04))),
    (STANDS, situation("leans on a wall, left", (0, 0), (0.04, 0.3), (0.04, 0.3))),
    (STANDS, situation("leans on a wall, right", (0, 0), (0.3, 0.08), (0.3, 0.08))),
    (
        situation("turns away from a wall", (0, 0), (0.05, 0.3), (0.15, 0.4)),
        situation("stays at it", (0, 0), (0.05, 0.3), (0.05, 0.3)),
    ),
    (
        situation("drives away from a wall", (0.095, 0), (0.3, 0.08), (0.3, 0.18)),
        situation("scrapes along it", (0.095, 0), (0.3, 0.08), (0.3, 0.08)),
    ),
    (TURNS, situation("scrapes along a wall, left", (0.095, 0), (0.3, 0.9), (0.08, 0.9))),
    (STANDS, situation("scrapes along a wall, right", (0.06, 0.06), (0.9, 0.3), (0.9, 0.08))),
)
