"""The solutions of lesson 11, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_11.exercises.shaping import shaping
from rlrobot_course.lesson_11.exercises.targets import targets
from rlrobot_course.lesson_11.exercises.to_and_fro import to_and_fro

__all__ = ["targets", "to_and_fro", "shaping"]  # noqa: RUF022
