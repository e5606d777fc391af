"""Exercises of lesson 04: SARSA."""

from rlrobot_edu.course.lesson_04.by_hand_check import by_hand, fall
from rlrobot_edu.course.lesson_04.loop_check import sarsa_learn
from rlrobot_edu.course.lesson_04.update_check import sarsa_update

__all__ = ["by_hand", "fall", "sarsa_learn", "sarsa_update"]
