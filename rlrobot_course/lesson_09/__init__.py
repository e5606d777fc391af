"""Lesson 09, loop evasion; `figures` draws a loop, and the way out of it."""

from rlrobot_course.lesson_09.exercises import check as check
