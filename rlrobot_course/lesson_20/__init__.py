"""Lesson 20, teaching by hand: a robot is driven, and an agent learns from it before it explores by itself.

`driver` drives where no person does; `pupils` are agents that are taught, then learn; `figures` shows what became of
them.
"""

from rlrobot_course.lesson_20.exercises import check as check
