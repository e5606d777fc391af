"""The question of lesson 04b: the answer, typical mistakes, hints."""
