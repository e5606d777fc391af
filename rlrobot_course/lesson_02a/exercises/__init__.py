"""The question of lesson 02a: the answer, typical mistakes, hints."""
