"""Lesson 04b, SARSA at a cliff.

`exercises` holds right answers, a page (`.md`) asks for each; `cliff` is the environment in which SARSA and Q-learning
part, with the ways that agents take in it; `figures` draws both.
"""

from rlrobot_course.lesson_04b.exercises import check as check
