"""The solutions of assignment 5, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.assignment_5.exercises.inputs import inputs
from rlrobot_course.assignment_5.exercises.interval import interval
from rlrobot_course.assignment_5.exercises.park_reward import park_reward
from rlrobot_course.assignment_5.exercises.value_of import value_of
from rlrobot_course.assignment_5.exercises.verdict import verdict

__all__ = ["park_reward", "inputs", "value_of", "interval", "verdict"]  # noqa: RUF022
