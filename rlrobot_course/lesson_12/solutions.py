"""The solution of lesson 12, from the file of its exercise."""

from rlrobot_course.lesson_12.exercises.gripper import gripper

__all__ = ["gripper"]
