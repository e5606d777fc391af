"""Lesson 09a, when heat helps; `figures` draws how long robots are caught."""

from rlrobot_course.lesson_09a.exercises import check as check
