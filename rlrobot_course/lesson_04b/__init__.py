"""Lesson 04b, SARSA at a cliff.

`exercises` has the file of its question; `cliff` is the environment in which SARSA and Q-learning
part, with the ways that agents take in it; `figures` draws both.
"""

from rlrobot_course.lesson_04b.exercises import check as check
