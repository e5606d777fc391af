"""The question of lesson 04b, from its file."""

from rlrobot_course.lesson_04b.exercises.fall import exercise as fall

__all__ = ["fall"]
