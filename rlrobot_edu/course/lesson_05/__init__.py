"""Lesson 05, eligibility traces.

`solutions` holds the right answers, `check` and `n_step_check` the exercises; `figures` draws traces, both views of λ
and how a reward spreads.
"""
