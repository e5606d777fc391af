"""The exercises of lesson 12a, gathered from their files."""

from rlrobot_course.lesson_12a.exercises.arm_reward import exercise as arm_reward
from rlrobot_course.lesson_12a.exercises.pays import exercise as pays

__all__ = ["arm_reward", "pays"]
