"""Lesson 08b, what exactness is worth. Its ideal and its figures are those of lesson 08."""

from rlrobot_course.lesson_08b.exercises import check as check
