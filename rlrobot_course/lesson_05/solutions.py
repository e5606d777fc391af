"""The solutions of lesson 05, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_05.exercises.by_hand import by_hand
from rlrobot_course.lesson_05.exercises.sarsa_lambda_update import sarsa_lambda_update
from rlrobot_course.lesson_05.exercises.who_paid import who_paid

__all__ = ["by_hand", "sarsa_lambda_update", "who_paid"]
