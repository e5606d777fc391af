"""The questions of lesson 08a, a file each: the answer, typical mistakes, hints."""
