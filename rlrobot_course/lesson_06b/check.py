"""The question of lesson 06b, from its file."""

from rlrobot_course.lesson_06b.exercises.bump_share import exercise as bump_share

__all__ = ["bump_share"]
