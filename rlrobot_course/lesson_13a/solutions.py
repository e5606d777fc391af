"""The solution of lesson 13a, from the file of its exercise."""

from rlrobot_course.lesson_13a.exercises.second_look import second_look

__all__ = ["second_look"]
