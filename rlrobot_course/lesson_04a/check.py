"""The exercises of lesson 04a, gathered from their files."""

from rlrobot_course.lesson_04a.exercises.expected_target import exercise as expected_target

__all__ = ["expected_target"]
