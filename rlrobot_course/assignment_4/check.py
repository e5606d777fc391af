"""The exercises of assignment 4, gathered from their files."""

from rlrobot_course.assignment_4.exercises.bias_table import exercise as bias_table
from rlrobot_course.assignment_4.exercises.drive import exercise as drive
from rlrobot_course.assignment_4.exercises.near_states import exercise as near_states
from rlrobot_course.assignment_4.exercises.next_temperature import exercise as next_temperature
from rlrobot_course.assignment_4.exercises.period import exercise as period

__all__ = ["bias_table", "drive", "near_states", "next_temperature", "period"]
