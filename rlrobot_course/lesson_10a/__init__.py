"""Lesson 10a, where to cut: which bins a robot on wheels should have."""
