"""Lesson 06, SARSA."""

from rlrobot_course.lesson_06.exercises import check as check
