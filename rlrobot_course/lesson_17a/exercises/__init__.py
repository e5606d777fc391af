"""The exercise of lesson 17a: solution, typical mistakes, hints."""
