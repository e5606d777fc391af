"""Lesson 02, Q-learning."""

from rlrobot_course.lesson_02.exercises import check as check
