"""The exercise of lesson 13a, from its file."""

from rlrobot_course.lesson_13a.exercises.second_look import exercise as second_look

__all__ = ["second_look"]
