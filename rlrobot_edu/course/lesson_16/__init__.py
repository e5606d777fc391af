"""Lesson 16, beyond the paper: a robot that thinks between its steps, knowledge that moves house, and the bias again."""
