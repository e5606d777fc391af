"""The solutions of lesson 04a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_04a.exercises.expected_target import expected_target

__all__ = ["expected_target"]
