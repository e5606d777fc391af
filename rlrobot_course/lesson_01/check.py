"""The exercises of lesson 01, gathered from their files."""

from rlrobot_course.lesson_01.exercises.bin_of import exercise as bin_of
from rlrobot_course.lesson_01.exercises.reward import exercise as reward
from rlrobot_course.lesson_01.exercises.state_number import exercise as state_number

__all__ = ["bin_of", "reward", "state_number"]
