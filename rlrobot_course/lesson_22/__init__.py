"""Lesson 22, the bias again: four others beside it, and what a robot earns that sees nothing."""

from rlrobot_course.lesson_22.exercises import check as check
