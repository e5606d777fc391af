"""Lesson 05a, the register: how many traces are enough, and which λ gives how long a memory."""

from rlrobot_course.lesson_05a.exercises import check as check
