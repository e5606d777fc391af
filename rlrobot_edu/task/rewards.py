"""Rewards that several task files share, for a collision, a motion, an approach, and the distances that they need.

Pure functions; a task file hands in its own limits.
"""

from math import sqrt

from rlrobot_edu.task.task import Readings


def length(x: float, y: float) -> float:
    """The length of the way x ahead and y aside, in the unit of both.

    `math.hypot` computes it, too, but its last bit differs between Python, numba and JavaScript.
    """
    return sqrt(x * x + y * y)


def collision_reward(readings: Readings, nearer_than: float) -> float:
    """−10 if two or more of the three front lasers are below `nearer_than` [m], −2 if one is, else 0."""
    front = readings["laser_front"] < nearer_than
    left = readings["laser_front_left"] < nearer_than
    right = readings["laser_front_right"] < nearer_than
    touching = front + left + right
    if touching >= 2:
        return -10.0
    return -2.0 if touching == 1 else 0.0


def distance_moved(before: Readings, after: Readings) -> float:
    """How far the robot is from where it was [m]."""
    return length(after["x"] - before["x"], after["y"] - before["y"])


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
    if before - after > gained:
        return min(5.0, round(1 + 4 / after))
    return idle


def gripper_to_object(readings: Readings) -> float:
    """How far the point between an arm's fingertips is from the middle of the object [m]."""
    aside = length(
        readings["gripper_x"] - readings["object_x"],
        readings["gripper_y"] - readings["object_y"],
    )
    return length(aside, readings["gripper_z"] - readings["object_z"])
