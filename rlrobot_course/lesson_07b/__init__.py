"""Lesson 07b, what the bias is worth. Its figure is one of lesson 07's."""

from rlrobot_course.lesson_07b.exercises import check as check
