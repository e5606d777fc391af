"""Lesson 16, planning: a robot thinks between its steps, at random or of what has changed."""

from rlrobot_course.lesson_16.exercises import check as check
