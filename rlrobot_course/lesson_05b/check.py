"""The exercise of lesson 05b, from its file."""

from rlrobot_course.lesson_05b.exercises.n_step_return import exercise as n_step_return

__all__ = ["n_step_return"]
