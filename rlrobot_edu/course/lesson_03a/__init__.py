"""Lesson 03a, temperatures, units and rules: an appendix to lesson 03.

`exercises` has a file for each exercise; `figures` shows what units do and which rule earns most.
"""
