"""The task of assignment 5: to park in front of a wall."""

import math
from collections.abc import Mapping

from rlrobot_course.exercises.design import (
    NOTHING,
    ONE_WHEEL,
    Pay,
    Readings,
    Situation,
    metres,
    moved,
    paid_by,
    unasked,
    way,
)
from rlrobot_edu import InputVariable, OutputVariable, Task

LASERS = ("laser_front", "laser_front_left", "laser_front_right")


def words(before: Readings, after: Readings) -> str:
    """What describes a step: its way, and the lasers."""
    front, left, right = (metres(after[laser]) for laser in LASERS)
    was = metres(before["laser_front"])
    told = f"front {front} (before {was}), front left {left}, front right {right} m"
    return f"{way(before, after)}; after it {told}"


def situation(
    name: str,
    front: float,
    before: float | None = None,
    left: float = 0.6,
    right: float = 0.6,
    ahead: float = 0.0,
    start: float = -0.3,
    others: Mapping[str, float] = NOTHING,
    turned: float = 0.0,
) -> Situation:
    """A step that moved the robot from `start` by `ahead` in y [m], and what the lasers say after it [m].

    before: laser_front before the step; None is the same as after it; turned: by how much it turned the robot [rad];
    others: further lasers, which play no part
    """
    now = dict(zip(LASERS, (front, left, right), strict=True)) | dict(others)
    was = now | {"laser_front": front if before is None else before}
    comes = was["laser_front"] > front
    looks_down = (ahead < 0) == comes and ahead != 0
    theta = math.pi / 2 * (-1 if looks_down else 1)
    return moved(name, (0.2, start), (0.0, ahead), was, now, theta, turned)


PARKED = situation("stands 0.25 m in front of the wall", 0.25)
STANDS_FAR = situation("stands 1.2 m from the wall", 1.2)
COMES = situation("comes nearer to a wall afar", 0.9, 0.995, ahead=0.095)
LEAVES = situation("drives away from the wall", 0.9, 0.805, ahead=-0.095)
TURNS = situation("turns on the spot, far from any wall", 1.1, 1.1, turned=ONE_WHEEL)
TOUCHES = situation("stands 0.0496 m in front of the wall", 0.0496)

PAIRS = (
    (PARKED, STANDS_FAR),
    (PARKED, COMES),
    (PARKED, situation("stands 0.10 m in front of the wall", 0.10)),
    (
        situation("stands 0.17 m in front of the wall", 0.17),
        situation("stands at 0.12 m", 0.12),
    ),
    (
        situation("stands 0.34 m in front of the wall", 0.34),
        situation("stands at 0.45 m", 0.45),
    ),
    (PARKED, situation("drives past 0.25 m without a stop", 0.25, 0.345, ahead=0.095)),
    (
        PARKED,
        situation(
            "drives along a slanting wall, always 0.25 m ahead", 0.25, ahead=0.06
        ),
    ),
    (PARKED, situation("creeps through 0.25 m backward", 0.25, 0.21, ahead=-0.04)),
    (COMES, STANDS_FAR),
    (
        situation("comes nearer, to 0.45 m", 0.45, 0.545, ahead=0.095),
        situation("stands 0.45 m in front of the wall", 0.45),
    ),
    (COMES, LEAVES),
    (COMES, TURNS),
    (situation("comes nearer along −y", 0.6, 0.695, ahead=-0.095), STANDS_FAR),
    (STANDS_FAR, situation("touches the wall in front", 0.03, 0.10, ahead=0.07)),
    (STANDS_FAR, situation("stands and touches on the left", 0.25, left=0.03)),
    (LEAVES, situation("stands and touches on the right", 0.25, right=0.04)),
    (situation("stands parked, a wall at 0.10 m on its left", 0.25, left=0.10), COMES),
    *(
        (situation("stands parked, a box beside it", 0.25, others=near), COMES)
        for near in unasked(LASERS)
    ),
    (PARKED, situation("comes nearer fast", 0.8, 0.995, ahead=0.195)),
    (
        STANDS_FAR,
        situation("comes nearer fast, and touches", 0.6, 0.795, left=0.03, ahead=0.195),
    ),
    # at the limits, and beside them, where whoever rounds judges otherwise
    (situation("stands 0.35 m in front of the wall", 0.35), COMES),
    (PARKED, situation("stands 0.15 m in front of the wall", 0.15)),
    (situation("stands 0.1504 m in front of the wall", 0.1504), COMES),
    (PARKED, situation("stands 0.3504 m in front of the wall", 0.3504)),
    (situation("stands 0.05 m in front of the wall", 0.05), TOUCHES),
    (STANDS_FAR, TOUCHES),
    (situation("stands, but for 0.0096 m", 0.25, 0.2596, ahead=0.0096), COMES),
    (
        situation("stands, but for 0.0097 m", 0.25, ahead=-0.0097, start=-0.30046),
        COMES,
    ),
    (situation("comes nearer by 0.0101 m", 0.9003, 0.9104, ahead=0.0101), STANDS_FAR),
    (situation("comes nearer by 0.0102 m", 0.9096, 0.9198, ahead=0.0102), STANDS_FAR),
)


def parking_task(reward: Pay) -> Task:
    """A small arena, wheels that go ahead, turn or stand, and a learner's own reward."""

    def command(wheels: Readings) -> Readings:
        back = wheels["left_wheel"] < 0 and wheels["right_wheel"] < 0
        return {"left_wheel": 0.0, "right_wheel": 0.0} if back else wheels

    task = Task(
        robot="mobile_base",
        scene="square_2x2",
        inputs=[
            InputVariable("laser_front", cuts=[0.15, 0.35, 0.60], unit="m"),
            InputVariable("laser_front_left", cuts=[0.15], unit="m"),
            InputVariable("laser_front_right", cuts=[0.15], unit="m"),
        ],
        outputs=[
            OutputVariable(wheel, values=[-1, 1], unit="rad/s")
            for wheel in ("left_wheel", "right_wheel")
        ],
        rewards=[0, 1],
        reward=lambda before, after: 0.0,
        command=command,
    )
    return paid_by(task, reward, PAIRS)
