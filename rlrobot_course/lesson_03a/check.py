"""The exercises of lesson 03a, gathered from their files."""

from rlrobot_course.lesson_03a.exercises.normalise import exercise as normalise
from rlrobot_course.lesson_03a.exercises.temperature_for import exercise as temperature_for

__all__ = ["normalise", "temperature_for"]
