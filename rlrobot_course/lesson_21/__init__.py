"""Lesson 21, transfer: what one robot has learned, carried over to the bins and actions of another one."""

from rlrobot_course.lesson_21.exercises import check as check
