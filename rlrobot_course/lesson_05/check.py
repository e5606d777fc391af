"""The exercises of lesson 05, gathered from their files."""

from rlrobot_course.lesson_05.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_05.exercises.sarsa_lambda_update import exercise as sarsa_lambda_update
from rlrobot_course.lesson_05.exercises.who_paid import exercise as who_paid

__all__ = ["by_hand", "sarsa_lambda_update", "who_paid"]
