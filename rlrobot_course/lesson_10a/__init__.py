"""Lesson 10a, where to cut: which bins a robot on wheels should have."""

from rlrobot_course.lesson_10a.exercises import check as check
