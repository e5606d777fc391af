"""The solution of lesson 10a, from the file of its exercise."""

from rlrobot_course.lesson_10a.exercises.still_safe import still_safe

__all__ = ["still_safe"]
