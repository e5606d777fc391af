"""The exercise of lesson 12, from its file."""

from rlrobot_edu.course.lesson_12.exercises.gripper import exercise as gripper

__all__ = ["gripper"]
