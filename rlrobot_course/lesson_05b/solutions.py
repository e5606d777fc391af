"""The solution of lesson 05b, from the file of its exercise."""

from rlrobot_course.lesson_05b.exercises.n_step_return import n_step_return

__all__ = ["n_step_return"]
