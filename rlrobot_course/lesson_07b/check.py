"""The exercise of lesson 07b, from its file."""

from rlrobot_course.lesson_07b.exercises.own_share import exercise as own_share

__all__ = ["own_share"]
