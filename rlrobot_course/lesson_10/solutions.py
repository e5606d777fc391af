"""The solutions of lesson 10, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_10.exercises.bins import bins
from rlrobot_course.lesson_10.exercises.motion import motion

__all__ = ["bins", "motion"]
