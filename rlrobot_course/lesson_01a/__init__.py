"""Lesson 01a, returns and values; `figures` draws how values spread through a grid."""

from rlrobot_course.lesson_01a.exercises import check as check
