"""The answer of lesson 04b, from the file of its question."""

from rlrobot_course.lesson_04b.exercises.fall import fall

__all__ = ["fall"]
