"""The solutions of lesson 16, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_16.exercises.by_hand import by_hand
from rlrobot_course.lesson_16.exercises.dyna import dyna

__all__ = ["by_hand", "dyna"]
