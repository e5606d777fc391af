"""The exercises of lesson 07a, gathered from their files."""

from rlrobot_course.lesson_07a.exercises.best_adviser import exercise as best_adviser

__all__ = ["best_adviser"]
