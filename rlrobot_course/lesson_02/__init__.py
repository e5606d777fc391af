"""Lesson 02, returns and values; `figures` draws how values spread through a grid."""

from rlrobot_course.lesson_02.exercises import check as check
