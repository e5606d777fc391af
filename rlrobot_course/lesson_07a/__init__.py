"""Lesson 07a, the register: how many traces are enough, and which λ gives how long a memory."""

from rlrobot_course.lesson_07a.exercises import check as check
