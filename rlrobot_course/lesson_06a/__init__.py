"""Lesson 06a, Expected SARSA: the mean over all next actions in the place of one that is drawn."""

from rlrobot_course.lesson_06a.exercises import check as check
