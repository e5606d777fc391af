"""The solution of lesson 16a, from the file of its exercise."""

from rlrobot_course.lesson_16a.exercises.overlaps import overlaps

__all__ = ["overlaps"]
