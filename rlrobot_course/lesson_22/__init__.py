"""Lesson 22, the bias again: `vbiassr` is a bias weighted by visits, and `figures` shows what a blind robot earns."""

from rlrobot_course.lesson_22.exercises import check as check
