"""Lesson 04. SARSA, and how it differs from Q-learning."""
