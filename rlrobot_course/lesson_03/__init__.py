"""Lesson 03, exploration.

`exercises` has a file for each exercise; `figures` draws how an action is drawn.
"""
