"""Lesson 04a, Expected SARSA: the mean over all next actions in the place of one that is drawn."""

from rlrobot_course.lesson_04a.exercises import check as check
