"""The exercises of lesson 16b, a file each: solution, typical mistakes, hints."""
