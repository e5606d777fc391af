"""The solutions of lesson 07, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_07.exercises.bias import bias
from rlrobot_course.lesson_07.exercises.by_hand import by_hand
from rlrobot_course.lesson_07.exercises.siblings import siblings

__all__ = ["by_hand", "siblings", "bias"]  # noqa: RUF022
