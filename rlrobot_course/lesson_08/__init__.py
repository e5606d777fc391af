"""Lesson 08, true online SARSA(λ).

`forward_view` is the ideal, the online λ-return algorithm, and the agents that learn from the same steps; in `handles`
the reader compares them. `figures` shows who paid for a value, in lesson 19.
"""

from rlrobot_course.lesson_08.exercises import check as check
