"""The exercises of lesson 16b, gathered from their files."""

from rlrobot_course.lesson_16b.exercises.how_far import exercise as how_far
from rlrobot_course.lesson_16b.exercises.two_biases import exercise as two_biases

__all__ = ["how_far", "two_biases"]
