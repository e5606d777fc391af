"""Lesson 11a, where to cut: which bins a robot on wheels should have."""

from rlrobot_course.lesson_11a.exercises import check as check
