"""The question of lesson 02a, from its file."""

from rlrobot_course.lesson_02a.exercises.look_ahead import exercise as look_ahead

__all__ = ["look_ahead"]
