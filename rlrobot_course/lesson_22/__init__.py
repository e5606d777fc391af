"""Lesson 22, the bias again: a bias weighted by visits, and what a blind robot earns."""

from rlrobot_course.lesson_22.exercises import check as check
