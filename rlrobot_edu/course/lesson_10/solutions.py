"""The solutions of lesson 10, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_edu.course.lesson_10.exercises.bins import bins
from rlrobot_edu.course.lesson_10.exercises.motion import motion
from rlrobot_edu.course.lesson_10.exercises.still_safe import still_safe

__all__ = ["bins", "still_safe", "motion"]  # noqa: RUF022
