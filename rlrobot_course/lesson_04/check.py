"""The exercises of lesson 04, gathered from their files."""

from rlrobot_course.lesson_04.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_04.exercises.sarsa_learn import exercise as sarsa_learn
from rlrobot_course.lesson_04.exercises.sarsa_update import exercise as sarsa_update

__all__ = ["by_hand", "sarsa_learn", "sarsa_update"]
