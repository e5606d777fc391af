"""Lesson 06. True online SARSA(λ)."""
