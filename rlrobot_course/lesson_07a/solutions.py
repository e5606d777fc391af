"""The solutions of lesson 07a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_07a.exercises.best_adviser import best_adviser

__all__ = ["best_adviser"]
