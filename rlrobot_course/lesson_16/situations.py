"""The situations on which a reward for following a wall on the right is tried."""

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

ASKED = ("laser_front", "laser_front_right", "laser_right")  # for a touch
LASERS = ("laser_front", "laser_front_right", "laser_right", "laser_left")


def words(before: Readings, after: Readings) -> str:
    """What describes a step: its way, and the lasers after it."""
    front, front_right, right, left = (metres(after[laser]) for laser in LASERS)
    told = f"front {front}, front right {front_right}, right {right}, left {left} m"
    return f"{way(before, after)}; after it {told}"


def situation(
    name: str,
    moved: tuple[float, float] = (0.0, 0.0),
    right: float = 0.25,
    front: float = 1.2,
    front_right: float = 0.5,
    left: float = 1.3,
    before: float | None = None,
    start: tuple[float, float] = (0.4, -0.5),
    turned: float = 0.0,
    others: Mapping[str, float] = NOTHING,
) -> Situation:
    """A step that moved the robot from `start` by `moved` in x and y [m], and what the lasers say after it [m].

    before: laser_right before the step; None is the same as after it; turned: by how much it turned the robot [rad];
    others: further lasers, which play no part
    """
    now = dict(zip(LASERS, (front, front_right, right, left), strict=True))
    now |= dict(others)
    was = now | {"laser_right": right if before is None else before}
    return design.moved(name, start, moved, was, now, heading(moved), turned)


AHEAD = (0.095, 0.0)  # what a step that drives straight on moves the robot [m]
ALONG = situation("follows the wall", AHEAD)
MIDWAY = situation("follows the wall at 0.25 m", AHEAD)
STANDS = situation("stands beside the wall")
TURNS = situation(
    "turns on the spot beside the wall",
    (0.02, 0.01),
    right=0.30,
    before=0.22,
    turned=ONE_WHEEL,
)
FREE = situation(
    "drives far from any wall", AHEAD, right=0.9, front_right=1.2, left=0.9
)
LEFT = situation(
    "follows a wall on its left", AHEAD, right=1.3, front_right=1.6, left=0.25
)
FAST = situation(
    "drives fast, far from any wall",
    (0.195, 0.0),
    right=0.9,
    front_right=1.2,
    left=0.9,
)
STANDS_FREE = situation(
    "stands far from any wall", right=0.9, front_right=1.2, left=0.9
)
SCRAPES = situation("scrapes along the wall", AHEAD, right=0.04, front_right=0.2)
# it has moved far enough beside the wall, and touches all the same
BUMPS = situation("bumps into the wall ahead", (0.09, 0.0), front=0.03, right=0.25)
LEANS = situation("leans on a wall in front", front=0.04, right=0.25)

PAIRS = (
    (ALONG, STANDS),
    (ALONG, situation("stands beside a wall at x = 0, y = 0", start=(0.0, 0.0))),
    (situation("follows the wall in −x", (-0.095, 0.0)), TURNS),
    (situation("follows the wall in +y", (0.0, 0.095)), STANDS_FREE),
    (situation("follows the wall in −y", (0.0, -0.095), start=(-0.5, 0.3)), STANDS),
    (situation("follows an oblique wall", (0.065, 0.065)), TURNS),
    (ALONG, FREE),
    (ALONG, LEFT),
    (
        ALONG,
        situation("drives 0.9 m away from the wall", AHEAD, right=0.9, front_right=1.2),
    ),
    (
        ALONG,
        situation(
            "has just left the wall",
            AHEAD,
            right=0.55,
            front_right=0.9,
            before=0.30,
        ),
    ),
    (
        situation("has just reached the wall", (0.0, -0.095), right=0.35, before=0.60),
        FREE,
    ),
    (
        situation("follows the wall at 0.12 m", AHEAD, right=0.12, front_right=0.3),
        FREE,
    ),
    (
        situation("follows the wall at 0.39 m", AHEAD, right=0.39, front_right=0.7),
        FREE,
    ),
    (
        MIDWAY,
        situation("at 0.07 m", AHEAD, right=0.07),
    ),
    (
        MIDWAY,
        situation("at 0.45 m", AHEAD, right=0.45),
    ),
    (
        situation("follows the wall at 0.40 m", AHEAD, right=0.40, front_right=0.7),
        FREE,
    ),
    (
        MIDWAY,
        situation("at 0.10 m", AHEAD, right=0.10),
    ),
    (
        ALONG,
        situation("curves beside the wall, by 0.06 m", (0.06, 0.0), turned=ONE_WHEEL),
    ),
    (
        ALONG,
        situation("curves askew beside the wall, by 0.064 m", (0.045, 0.045)),
    ),
    (situation("follows an oblique wall, down", (0.065, -0.065)), STANDS),
    (situation("follows the wall slowly", (0.075, 0.0)), FAST),
    (STANDS, situation("scrapes along fast", (0.195, 0.0), right=0.04)),
    # what plays no part
    *(
        (situation("follows the wall, a box beside it", AHEAD, others=near), STANDS)
        for near in unasked(ASKED)
    ),
    *(
        (situation("stands, a box beside it", others=near), SCRAPES)
        for near in unasked(ASKED)
    ),
    # at the limits, and beside them, where whoever rounds judges otherwise
    (situation("follows the wall at 0.1004 m", AHEAD, right=0.1004), FREE),
    (MIDWAY, situation("at 0.4004 m", AHEAD, right=0.4004)),
    (situation("drives on, a wall at 0.05 m ahead", AHEAD, front=0.05), STANDS),
    (STANDS, situation("stands, a wall at 0.0496 m ahead", front=0.0496)),
    (situation("moves by 0.0702 m", (0.0702, 0.0), start=(0.39962, -0.5)), TURNS),
    (situation("moves by 0.0702 m, too", (0.0702, 0.0), start=(0.4001, -0.5)), TURNS),
    (
        situation("follows the wall past a box on its left", AHEAD, left=0.1),
        STANDS,
    ),
    (STANDS, SCRAPES),
    (FREE, SCRAPES),
    (STANDS, LEANS),
    (
        STANDS_FREE,
        situation(
            "bumps into a corner", (0.01, 0.0), front=0.3, front_right=0.03, right=0.3
        ),
    ),
    (
        TURNS,
        situation("bumps into a wall in front", (0.03, 0.0), front=0.02, right=0.25),
    ),
    (situation("comes free of the wall", (0.02, 0.01), right=0.15, before=0.03), LEANS),
    (ALONG, BUMPS),
    (STANDS, BUMPS),
)
