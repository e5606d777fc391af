"""Appendix 06a, the ideal behind true online SARSA(λ), and how large α may be.

`solutions` holds the right answers, `check` the exercises. The ideal itself and the figures are those of lesson 06.
"""
