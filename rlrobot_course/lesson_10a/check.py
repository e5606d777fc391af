"""The exercise of lesson 10a, from its file."""

from rlrobot_course.lesson_10a.exercises.still_safe import exercise as still_safe

__all__ = ["still_safe"]
