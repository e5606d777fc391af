"""The situations on which lesson 01's free exercise, a reward of one's own design, is tried."""

from collections.abc import Mapping

from rlrobot_course.exercises import design
from rlrobot_course.exercises.design import (
    NOTHING,
    ONE_WHEEL,
    Readings,
    Situation,
    heading,
    metres,
    unasked,
    way,
)

LASERS = ("laser_front_left", "laser_front_right")


def words(before: Readings, after: Readings) -> str:
    """What describes a step: its way, and the two lasers after it."""
    left, right = after["laser_front_left"], after["laser_front_right"]
    return f"{way(before, after)}, lasers after it {metres(left)} and {metres(right)} m"


def situation(
    name: str,
    moved: tuple[float, float] = (0.0, 0.0),
    before: tuple[float, float] = (0.9, 0.9),
    after: tuple[float, float] = (0.9, 0.9),
    start: tuple[float, float] = (2.0, 1.0),
    turned: float = 0.0,
    others: Mapping[str, float] = NOTHING,
) -> Situation:
    """A step that moved the robot from `start` by `moved` in x and y [m], and turned it [rad].

    before, after: the lasers left and right [m]; others: further lasers, which play no part
    """
    was = dict(zip(LASERS, before, strict=True)) | dict(others)
    now = dict(zip(LASERS, after, strict=True)) | dict(others)
    return design.moved(name, start, moved, was, now, heading(moved), turned)


STANDS = situation("stands still", start=(0.0, 0.0))
# x and y are measured behind the axle, so they change a little
TURNS = situation(
    "turns on the spot",
    (0.018, 0.018),
    (0.9, 0.9),
    (0.4, 1.2),
    start=(0.0, 0.0),
    turned=ONE_WHEEL,
)
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
    (
        situation("drives 0.08 m", (0.08, 0), *FREE),
        situation("creeps 0.06 m", (0.06, 0), (0.9, 0.9), (0.85, 0.85)),
    ),
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
        situation(
            "turns away from a wall",
            (0, 0),
            (0.05, 0.3),
            (0.15, 0.4),
            turned=ONE_WHEEL,
        ),
        situation("stays at it", (0, 0), (0.05, 0.3), (0.05, 0.3)),
    ),
    (
        situation("drives away from a wall", (0.095, 0), (0.3, 0.08), (0.3, 0.18)),
        situation("scrapes along it", (0.095, 0), (0.3, 0.08), (0.3, 0.08)),
    ),
    (
        TURNS,
        situation("scrapes along a wall, left", (0.095, 0), (0.3, 0.9), (0.08, 0.9)),
    ),
    (
        STANDS,
        situation("scrapes along a wall, right", (0.06, 0.06), (0.9, 0.3), (0.9, 0.08)),
    ),
    # at the limits, and beside them, where whoever rounds judges otherwise
    (situation("drives along at 0.10 m", (0.095, 0), (0.1, 0.9), (0.1, 0.9)), STANDS),
    (situation("drives 0.0702 m", (0.0702, 0), *FREE, (0.39962, 0.0)), STANDS),
    (situation("drives 0.0702 m, too", (0.0702, 0), *FREE, (0.4001, 0.0)), STANDS),
    (STANDS, situation("leans on a wall, left", (0, 0), (0.0996, 0.3), (0.0996, 0.3))),
    (STANDS, situation("scrapes along fast", (0.3, 0), (0.9, 0.3), (0.9, 0.08))),
    *(
        (situation("drives, a box beside it", (0.095, 0), *FREE, others=near), STANDS)
        for near in unasked(LASERS)
    ),
)
