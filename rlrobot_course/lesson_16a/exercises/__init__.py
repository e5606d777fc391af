"""The exercise of lesson 16a: solution, cases, typical mistakes, hints.

Wrong answers as learners write them stand in the Markdown file beside the function (see `grading.answers`).
"""
