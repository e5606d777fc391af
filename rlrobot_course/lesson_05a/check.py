"""The exercises of lesson 05a, gathered from their files."""

from rlrobot_course.lesson_05a.exercises.lam_for import exercise as lam_for
from rlrobot_course.lesson_05a.exercises.n_traces import exercise as n_traces

__all__ = ["lam_for", "n_traces"]
