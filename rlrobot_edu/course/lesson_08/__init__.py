"""Lesson 08, loop evasion.

`solutions` holds the right answers, `check`, `temperature_check` and `questions` the exercises; `figures` draws loops,
and the ways out of them.
"""
