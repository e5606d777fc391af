"""The exercises of lesson 10, gathered from their files."""

from rlrobot_edu.course.lesson_10.exercises.bins import exercise as bins
from rlrobot_edu.course.lesson_10.exercises.motion import exercise as motion
from rlrobot_edu.course.lesson_10.exercises.still_safe import exercise as still_safe

__all__ = ["bins", "motion", "still_safe"]
