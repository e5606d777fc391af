"""Lesson 07b, λ from both sides: returns of n steps, and how much λ is good.

`figures` draws both views of λ, and `random_walk` is a world in which the values are known.
"""

from rlrobot_course.lesson_07b.exercises import check as check
