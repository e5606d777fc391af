"""Lesson 01, states, actions, rewards.

`solutions` holds the right answers, `check` the exercises; `figures` draws bins and the spread of values.
"""
