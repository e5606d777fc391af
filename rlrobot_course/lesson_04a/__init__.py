"""Lesson 04a, Expected SARSA: the mean over all next actions in the place of one that is drawn."""
