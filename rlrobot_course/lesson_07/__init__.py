"""Lesson 07, eligibility traces; `figures` draws traces and how a reward spreads."""

from rlrobot_course.lesson_07.exercises import check as check
