"""Lesson 02, Q-learning. `check` holds the exercises, `solutions` the right answers; `figures` follows one entry of the Q table."""
