"""Lesson 04, SARSA."""

from rlrobot_course.lesson_04.exercises import check as check
