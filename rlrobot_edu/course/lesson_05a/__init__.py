"""Lesson 05a, the register: how many traces are enough, and which λ gives how long a memory.

`solutions` holds the right answers, `check` the exercises, `figures` draws the register.
"""
