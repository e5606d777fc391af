"""The exercises of assignment 3, gathered from their files."""

from rlrobot_course.assignment_3.exercises.n_step_return import exercise as n_step_return
from rlrobot_course.assignment_3.exercises.td_episode import exercise as td_episode
from rlrobot_course.assignment_3.exercises.trace_after import exercise as trace_after
from rlrobot_course.assignment_3.exercises.true_online_episode import exercise as true_online_episode
from rlrobot_course.assignment_3.exercises.watkins_update import exercise as watkins_update

__all__ = ["n_step_return", "td_episode", "trace_after", "true_online_episode", "watkins_update"]
