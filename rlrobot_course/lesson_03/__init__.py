"""Lesson 03, Q-learning."""

from rlrobot_course.lesson_03.exercises import check as check
