"""Lesson 08, loop evasion.

`exercises` has a file for each exercise; `figures` draws loops, and the ways out of them.
"""
