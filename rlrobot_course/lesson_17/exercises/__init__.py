"""The exercises of lesson 17, a file each: solution, cases, typical mistakes, hints.

Wrong answers as learners write them stand in the Markdown file beside each function (see `grading.answers`).
"""
