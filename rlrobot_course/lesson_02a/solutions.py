"""The answer of lesson 02a, from the file of its question."""

from rlrobot_course.lesson_02a.exercises.look_ahead import look_ahead

__all__ = ["look_ahead"]
