"""The solutions of lesson 04, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_04.exercises.by_hand import by_hand
from rlrobot_course.lesson_04.exercises.sarsa_learn import sarsa_learn
from rlrobot_course.lesson_04.exercises.sarsa_update import sarsa_update

__all__ = ["by_hand", "sarsa_update", "sarsa_learn"]  # noqa: RUF022
