"""The exercises of lesson 06, gathered from their files."""

from rlrobot_course.lesson_06.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_06.exercises.dutch import exercise as dutch
from rlrobot_course.lesson_06.exercises.true_online_update import exercise as true_online_update

__all__ = ["by_hand", "dutch", "true_online_update"]
