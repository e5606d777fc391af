"""Lesson 01a, returns and values.

`solutions` holds the right answers, `check` the exercises; `figures` draws how values spread through a grid.
"""
