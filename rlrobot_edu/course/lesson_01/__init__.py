"""Lesson 01, states, actions, rewards. `check` holds the exercises, `solutions` the right answers; `figures` draws bins and the spread of values."""
