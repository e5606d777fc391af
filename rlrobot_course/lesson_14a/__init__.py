"""Lesson 14a, where a model misleads: what was never tried, what was tried once, and the gap to the robot."""

from rlrobot_course.lesson_14a.exercises import check as check
