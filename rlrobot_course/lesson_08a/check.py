"""The questions of lesson 08a, gathered from their files."""

from rlrobot_course.lesson_08a.exercises.heats import exercise as heats
from rlrobot_course.lesson_08a.exercises.paid_otherwise import exercise as paid_otherwise

__all__ = ["heats", "paid_otherwise"]
