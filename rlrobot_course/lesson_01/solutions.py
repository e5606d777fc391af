"""The solutions of lesson 01, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_01.exercises.bin_of import bin_of
from rlrobot_course.lesson_01.exercises.reward import reward
from rlrobot_course.lesson_01.exercises.state_number import state_number

__all__ = ["bin_of", "state_number", "reward"]  # noqa: RUF022
