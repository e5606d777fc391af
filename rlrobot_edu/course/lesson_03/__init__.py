"""Lesson 03. Exploration: ε-greedy and softmax regression."""
