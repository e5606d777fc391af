"""The exercises of lesson 17, gathered from their files."""

from rlrobot_course.lesson_17.exercises.allowed import exercise as allowed
from rlrobot_course.lesson_17.exercises.nearest_ahead import exercise as nearest_ahead
from rlrobot_course.lesson_17.exercises.wheels import exercise as wheels

__all__ = ["allowed", "nearest_ahead", "wheels"]
