"""The solutions of lesson 12a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_12a.exercises.arm_reward import arm_reward
from rlrobot_course.lesson_12a.exercises.pays import pays

__all__ = ["pays", "arm_reward"]  # noqa: RUF022
