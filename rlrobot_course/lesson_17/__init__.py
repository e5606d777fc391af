"""Lesson 17, planning: a robot thinks between its steps, at random or of what has changed."""

from rlrobot_course.lesson_17.exercises import check as check
