"""Lesson 06b, SARSA at a cliff, where Q-learning goes another way; `figures` draws both."""

from rlrobot_course.lesson_06b.exercises import check as check
