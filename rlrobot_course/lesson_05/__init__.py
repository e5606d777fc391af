"""Lesson 05, eligibility traces.

`exercises` has a file for each exercise; `figures` draws traces and how a reward spreads.
"""
