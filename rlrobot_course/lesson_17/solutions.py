"""The solutions of lesson 17, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_17.exercises.allowed import allowed
from rlrobot_course.lesson_17.exercises.nearest_ahead import nearest_ahead
from rlrobot_course.lesson_17.exercises.wheels import wheels

__all__ = ["wheels", "nearest_ahead", "allowed"]  # noqa: RUF022
