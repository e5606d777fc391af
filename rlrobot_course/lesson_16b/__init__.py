"""Lesson 16b, the bias again: four others beside it, and what a robot earns that sees nothing."""
