"""The exercises of lesson 09, gathered from their files."""

from rlrobot_course.lesson_09.exercises.choose import exercise as choose
from rlrobot_course.lesson_09.exercises.learn import exercise as learn
from rlrobot_course.lesson_09.exercises.learn_and_evade import exercise as learn_and_evade
from rlrobot_course.lesson_09.exercises.preferences import exercise as preferences

__all__ = ["choose", "learn", "learn_and_evade", "preferences"]
