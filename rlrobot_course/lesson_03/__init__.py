"""Lesson 03, exploration; `figures` draws how an action is drawn."""

from rlrobot_course.lesson_03.exercises import check as check
