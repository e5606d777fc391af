"""The solutions of lesson 01a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_01a.exercises.discounted_return import discounted_return
from rlrobot_course.lesson_01a.exercises.far_from_the_goal import far_from_the_goal

__all__ = ["discounted_return", "far_from_the_goal"]
