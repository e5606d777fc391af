"""Lesson 08, loop evasion.

`exercises` has a file for each exercise; `figures` draws a loop, and the way out of it.
"""
