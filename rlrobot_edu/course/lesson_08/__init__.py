"""Lesson 08, loop evasion. `check` holds the exercises, `solutions` the right answers; `figures` draws loops, and the ways out of them."""
