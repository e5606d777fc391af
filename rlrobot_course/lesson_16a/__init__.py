"""Lesson 16a, transfer: what one robot has learned, carried over to the bins and actions of another one."""

from rlrobot_course.lesson_16a.exercises import check as check
