"""The solutions of lesson 03a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_03a.exercises.normalise import normalise
from rlrobot_course.lesson_03a.exercises.temperature_for import temperature_for

__all__ = ["temperature_for", "normalise"]  # noqa: RUF022
