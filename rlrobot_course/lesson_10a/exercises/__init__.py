"""The exercise of lesson 10a: solution, typical mistakes, hints."""
