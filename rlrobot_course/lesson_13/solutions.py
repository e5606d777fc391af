"""The solutions of lesson 13, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_13.exercises.enough import enough
from rlrobot_course.lesson_13.exercises.estimate import estimate
from rlrobot_course.lesson_13.exercises.sample import sample

__all__ = ["estimate", "enough", "sample"]  # noqa: RUF022
