"""Lesson 16a, transfer: what one robot has learned, carried over to the bins and actions of another one."""
