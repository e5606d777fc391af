"""The question of lesson 06b: the answer, typical mistakes, hints."""
