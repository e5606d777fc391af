"""What an exercise is made of, and what its check says.

- `verdict`: what a check says to the learner, a `Verdict`: waiting, right or wrong, the first wrong step and a hint.
- `exercise`: `Exercise`, whose answer is a function; `question`: `Question`, whose answer is a value.
- `mistake`: a typical wrong answer with its hint; `copying`: the hint where an argument is changed that should be read.
- `page`: the Markdown file of an exercise: what is asked, hints, mistakes and wrong answers.
"""
