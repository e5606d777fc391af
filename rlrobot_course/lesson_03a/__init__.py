"""Lesson 03a, what α and γ do; `figures` follows one entry of the Q table."""

from rlrobot_course.lesson_03a.exercises import check as check
