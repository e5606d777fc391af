"""The exercise of lesson 13a: solution, typical mistakes, hints."""
