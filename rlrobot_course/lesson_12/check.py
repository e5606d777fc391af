"""The exercise of lesson 12, from its file."""

from rlrobot_course.lesson_12.exercises.gripper import exercise as gripper

__all__ = ["gripper"]
