"""The exercises of lesson 13, gathered from their files."""

from rlrobot_course.lesson_13.exercises.enough import exercise as enough
from rlrobot_course.lesson_13.exercises.estimate import exercise as estimate
from rlrobot_course.lesson_13.exercises.sample import exercise as sample

__all__ = ["enough", "estimate", "sample"]
