"""The solution of lesson 07b, from the file of its exercise."""

from rlrobot_course.lesson_07b.exercises.own_share import own_share

__all__ = ["own_share"]
