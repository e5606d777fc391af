"""The solution of lesson 17a, from the file of its exercise."""

from rlrobot_course.lesson_17a.exercises.who_stops import who_stops

__all__ = ["who_stops"]
