"""Lesson 05b, what the bias is worth. Its figure is one of lesson 05's."""

from rlrobot_course.lesson_05b.exercises import check as check
