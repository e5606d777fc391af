"""Lesson 05, eligibility traces.

`exercises` has a file for each exercise; `figures` draws traces, both views of λ and how a reward spreads.
"""
