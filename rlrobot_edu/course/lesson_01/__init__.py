"""Lesson 01, states, actions, rewards. `check` holds the exercises; `figures` draws bins and the spread of values."""
