"""Lesson 16b, the bias again: four others beside it, and what a robot earns that sees nothing."""

from rlrobot_course.lesson_16b.exercises import check as check
