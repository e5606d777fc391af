"""Lesson 05. Eligibility traces: SARSA(λ)."""
