"""The answers of lesson 08a, gathered from the files of its questions, in the order of the notebook."""

from rlrobot_course.lesson_08a.exercises.heats import heats
from rlrobot_course.lesson_08a.exercises.paid_otherwise import paid_otherwise

__all__ = ["paid_otherwise", "heats"]  # noqa: RUF022
