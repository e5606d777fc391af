"""The solutions of lesson 16, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_edu.course.lesson_16.exercises.by_hand import by_hand
from rlrobot_edu.course.lesson_16.exercises.dyna import dyna
from rlrobot_edu.course.lesson_16.exercises.how_far import how_far
from rlrobot_edu.course.lesson_16.exercises.overlaps import overlaps
from rlrobot_edu.course.lesson_16.exercises.two_biases import two_biases

__all__ = ["by_hand", "two_biases", "how_far", "dyna", "overlaps"]  # noqa: RUF022
