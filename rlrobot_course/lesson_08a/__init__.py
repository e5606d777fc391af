"""Lesson 08a, when heat helps.

`exercises` has a file for each question; `figures` draws how long robots are caught.
"""
