"""The exercises of lesson 12, gathered from their files."""

from rlrobot_edu.course.lesson_12.exercises.arm_reward import exercise as arm_reward
from rlrobot_edu.course.lesson_12.exercises.gripper import exercise as gripper
from rlrobot_edu.course.lesson_12.exercises.pays import exercise as pays

__all__ = ["arm_reward", "gripper", "pays"]
