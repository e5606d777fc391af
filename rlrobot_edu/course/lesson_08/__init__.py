"""Lesson 08, loop evasion. `check` holds the exercises; `figures` draws loops, and the ways out of them."""
