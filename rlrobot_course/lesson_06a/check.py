"""The exercises of lesson 06a, gathered from their files."""

from rlrobot_course.lesson_06a.exercises.lambda_return import exercise as lambda_return
from rlrobot_course.lesson_06a.exercises.largest_alpha import exercise as largest_alpha

__all__ = ["lambda_return", "largest_alpha"]
