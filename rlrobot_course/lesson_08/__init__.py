"""Lesson 08, loop evasion; `figures` draws a loop, and the way out of it."""

from rlrobot_course.lesson_08.exercises import check as check
