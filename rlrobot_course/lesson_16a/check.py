"""The exercise of lesson 16a, from its file."""

from rlrobot_course.lesson_16a.exercises.overlaps import exercise as overlaps

__all__ = ["overlaps"]
