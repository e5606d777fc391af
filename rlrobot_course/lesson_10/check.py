"""The exercises of lesson 10, gathered from their files."""

from rlrobot_course.lesson_10.exercises.bins import exercise as bins
from rlrobot_course.lesson_10.exercises.motion import exercise as motion

__all__ = ["bins", "motion"]
