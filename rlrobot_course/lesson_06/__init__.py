"""Lesson 06, true online SARSA(λ).

`forward_view` is the ideal, the online λ-return algorithm, and the agents that learn from the same steps; `figures`
compares them. Lessons 06a and 06b work with the same ideal.
"""

from rlrobot_course.lesson_06.exercises import check as check
