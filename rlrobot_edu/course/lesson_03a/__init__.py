"""Lesson 03a, temperatures, units and rules: an appendix to lesson 03.

`solutions` holds the right answers, `check` the exercises; `figures` shows what units do and which rule earns most.
"""
