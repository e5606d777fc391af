"""The exercises of lesson 12a, a file each: solution, cases, typical mistakes, hints.

Wrong answers as learners write them stand in the Markdown file beside the function (see `grading.answers`).
"""
