"""Lesson 16, beyond the paper: thinking between steps, knowledge that moves from robot to robot, and the bias again."""
