"""The exercises of lesson 01a, gathered from their files."""

from rlrobot_course.lesson_01a.exercises.discounted_return import exercise as discounted_return
from rlrobot_course.lesson_01a.exercises.far_from_the_goal import exercise as far_from_the_goal

__all__ = ["discounted_return", "far_from_the_goal"]
