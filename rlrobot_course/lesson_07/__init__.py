"""Lesson 07, eligibility traces; `figures` draws how a reward spreads, `handles` has a path with its traces."""

from rlrobot_course.lesson_07.exercises import check as check
