"""Rewards that several task files share, for a collision, a motion, an approach, and the distances that they need.

Pure functions; a task file hands in its own limits.
"""

from math import hypot

from rlrobot_edu.task.task import Readings


def collision_reward(readings: Readings, nearer_than: float) -> float:
    """−10 if two or more of the three front lasers are below `nearer_than` [m], −2 if one is, else 0."""
    front, left, right = (
        readings["laser_front"],
        readings["laser_front_left"],
        readings["laser_front_right"],
    )
    touching = (front < nearer_than) + (left < nearer_than) + (right < nearer_than)
    return (0.0, -2.0, -10.0, -10.0)[touching]


def distance_moved(before: Readings, after: Readings) -> float:
    """How far the robot is from where it was [m]."""
    return hypot(after["x"] - before["x"], after["y"] - before["y"])


def wander_reward(
    before: Readings, after: Readings, collision: float, moved: float
) -> float:
    """A collision (nearer than `collision` [m]): −10 or −2; moved further than `moved` [m]: 10; else −0.02."""
    return collision_reward(after, collision) or (
        10.0 if distance_moved(before, after) > moved else -0.02
    )


def approach_reward(before: float, after: float, gained: float, idle: float) -> float:
    """Reward for the way towards a goal, from the distances to it before and after the step [m].

    Away by more than `gained` [m]: −1; nearer by more than that: min(5, round(1 + 4 / distance)); else `idle`.
    """
    if after - before > gained:
        return -1.0
    return float(min(5, round(1 + 4 / after))) if before - after > gained else idle


def gripper_to_object(readings: Readings) -> float:
    """How far the point between an arm's fingertips is from the middle of the object [m]."""
    aside = hypot(
        readings["gripper_x"] - readings["object_x"],
        readings["gripper_y"] - readings["object_y"],
    )
    return hypot(aside, readings["gripper_z"] - readings["object_z"])
