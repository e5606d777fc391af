"""The solutions of lesson 06, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_06.exercises.by_hand import by_hand
from rlrobot_course.lesson_06.exercises.dutch import dutch
from rlrobot_course.lesson_06.exercises.true_online_update import true_online_update

__all__ = ["dutch", "by_hand", "true_online_update"]  # noqa: RUF022
