"""Lesson 17a asks for no prediction."""

OUTCOMES: dict[str, tuple[str, str]] = {}
