"""Lesson 04, exploration; `figures` draws how an action is drawn."""

from rlrobot_course.lesson_04.exercises import check as check
