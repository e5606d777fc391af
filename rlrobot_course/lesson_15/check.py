"""The exercises of lesson 15, gathered from their files."""

from rlrobot_course.lesson_15.exercises.faults import exercise as faults
from rlrobot_course.lesson_15.exercises.follow_reward import exercise as follow_reward
from rlrobot_course.lesson_15.exercises.size import exercise as size

__all__ = ["faults", "follow_reward", "size"]
