"""Lesson 05, eligibility traces; `figures` draws traces and how a reward spreads."""

from rlrobot_course.lesson_05.exercises import check as check
