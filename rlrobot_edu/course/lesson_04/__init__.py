"""Lesson 04, SARSA.

`solutions` holds the right answers, `check` the exercises; `cliff` is the environment in which SARSA and Q-learning
part, with the ways that agents take in it; `figures` draws both.
"""
