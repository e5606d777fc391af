"""The arm's task with a reward for contact alone."""

import dataclasses

from rlrobot_edu.task.rewards import gripper_to_object
from rlrobot_edu.task.task import Task

TOUCHED, NOT_TOUCHED = 10.0, -0.02


def _touch(before, after) -> float:
    """10 within 5 cm of the object, as in the task's own reward; nothing for the way to it."""
    return TOUCHED if gripper_to_object(after) <= 0.05 else NOT_TOUCHED


def contact_alone(task: Task) -> Task:
    """The arm's task with a reward for contact alone: to and fro before the object pays nothing any more."""
    return dataclasses.replace(
        task,
        reward=_touch,
        rewards=[NOT_TOUCHED, TOUCHED],
        name=f"{task.name}, contact alone",
    )
