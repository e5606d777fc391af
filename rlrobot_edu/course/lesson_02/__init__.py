"""Lesson 02, Q-learning. `check` holds the exercises; `figures` follows one entry of the Q table."""
