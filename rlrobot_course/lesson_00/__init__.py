"""Lesson 00, start here: `figures` marks the laser beams that count."""
