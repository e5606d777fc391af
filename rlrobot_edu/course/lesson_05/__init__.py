"""Lesson 05, eligibility traces.

`check` holds the exercises, `solutions` the right answers; `figures` draws traces, both views of λ and how a reward spreads.
"""
