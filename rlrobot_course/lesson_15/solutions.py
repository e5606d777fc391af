"""The solutions of lesson 15, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_15.exercises.faults import faults
from rlrobot_course.lesson_15.exercises.follow_reward import follow_reward
from rlrobot_course.lesson_15.exercises.size import size

__all__ = ["follow_reward", "size", "faults"]  # noqa: RUF022
