"""Lesson 04, SARSA.

`exercises` has a file for each exercise; `cliff` is the environment in which SARSA and Q-learning
part, with the ways that agents take in it; `figures` draws both.
"""
