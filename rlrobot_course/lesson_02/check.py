"""The exercises of lesson 02, gathered from their files."""

from rlrobot_course.lesson_02.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_02.exercises.learn import exercise as learn
from rlrobot_course.lesson_02.exercises.target import exercise as target
from rlrobot_course.lesson_02.exercises.update import exercise as update

__all__ = ["by_hand", "learn", "target", "update"]
