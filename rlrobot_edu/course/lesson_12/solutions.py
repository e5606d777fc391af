"""The solutions of lesson 12, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_edu.course.lesson_12.exercises.arm_reward import arm_reward
from rlrobot_edu.course.lesson_12.exercises.gripper import gripper
from rlrobot_edu.course.lesson_12.exercises.pays import pays

__all__ = ["pays", "gripper", "arm_reward"]  # noqa: RUF022
