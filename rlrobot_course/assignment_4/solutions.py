"""The solutions of assignment 4, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.assignment_4.exercises.bias_table import bias_table
from rlrobot_course.assignment_4.exercises.drive import drive
from rlrobot_course.assignment_4.exercises.near_states import near_states
from rlrobot_course.assignment_4.exercises.next_temperature import next_temperature
from rlrobot_course.assignment_4.exercises.period import period

__all__ = ["near_states", "bias_table", "period", "next_temperature", "drive"]  # noqa: RUF022
