"""Lesson 06, true online SARSA(λ).

`exercises` has a file for each exercise; `forward_view` is the ideal, the online λ-return algorithm, and the agents
that learn from the same steps; `figures` compares them. The appendix, 06a, works with the same ideal; its exercises
are in a room of their own.
"""
