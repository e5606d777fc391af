"""The exercises of lesson 16, gathered from their files."""

from rlrobot_course.lesson_16.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_16.exercises.dyna import exercise as dyna

__all__ = ["by_hand", "dyna"]
