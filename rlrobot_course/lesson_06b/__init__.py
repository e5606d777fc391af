"""Lesson 06b, what exactness is worth. Its ideal and its figures are those of lesson 06."""

from rlrobot_course.lesson_06b.exercises import check as check
