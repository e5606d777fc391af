"""Lesson 08, true online SARSA(λ).

`forward_view` is the ideal, the online λ-return algorithm, and the agents that learn from the same steps; `figures`
compares them, and in `handles` the reader does.
"""

from rlrobot_course.lesson_08.exercises import check as check
