"""The exercises of lesson 07, gathered from their files."""

from rlrobot_course.lesson_07.exercises.bias import exercise as bias
from rlrobot_course.lesson_07.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_07.exercises.siblings import exercise as siblings

__all__ = ["bias", "by_hand", "siblings"]
