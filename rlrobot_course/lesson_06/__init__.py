"""Lesson 06, SARSA at a cliff, where Q-learning goes another way; `figures` draws both."""

from rlrobot_course.lesson_06.exercises import check as check
