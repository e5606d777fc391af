"""The exercises of lesson 11, gathered from their files."""

from rlrobot_course.lesson_11.exercises.shaping import exercise as shaping
from rlrobot_course.lesson_11.exercises.targets import exercise as targets
from rlrobot_course.lesson_11.exercises.to_and_fro import exercise as to_and_fro

__all__ = ["shaping", "targets", "to_and_fro"]
