"""The solutions of lesson 16b, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_16b.exercises.how_far import how_far
from rlrobot_course.lesson_16b.exercises.two_biases import two_biases

__all__ = ["two_biases", "how_far"]  # noqa: RUF022
