"""Lesson 04, SARSA.

`exercises` has a file for each exercise.
"""
