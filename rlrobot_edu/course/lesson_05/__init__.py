"""Lesson 05, eligibility traces.

`check` holds the exercises; `figures` draws traces, both views of λ and how a reward spreads.
"""
