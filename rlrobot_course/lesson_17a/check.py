"""The exercise of lesson 17a, from its file."""

from rlrobot_course.lesson_17a.exercises.who_stops import exercise as who_stops

__all__ = ["who_stops"]
