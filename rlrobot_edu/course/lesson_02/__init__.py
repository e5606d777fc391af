"""Lesson 02, Q-learning.

`solutions` holds the right answers, `check` the exercises; `figures` follows one entry of the Q table.
"""
