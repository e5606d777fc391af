"""How the hint for a wrong answer is found.

Read `evidence` first, which says what a detector is given, then `detectors`, the ordered list of them.

- `as_if`: the hint for an answer that does the same as the right function with one thing in it changed. `changed`
  makes such functions; `simple_changes` and `further_changes` say what may be changed. `formula`: the same for a
  question in numbers.
- `pieces`: which pieces of code such a hint may show.
- `mistakes`: the exercise's own mistakes, alone and two at a time. `in_place`: a table that is made anew.
- `calls`: the calls that a loop makes, noted. `events`: what they tell beside those of the right loop.
  `first_event`: the first of them that differs, as a small table. `first_change`: the same where no call differs, of a
  table that the loop changes or of its result.
- `suspicions`: what the values of an answer have in common that shows no known mistake; `relations`: its numbers.
- `remainders`: which part of a result is wrong, or in which cases, where nothing else is known.
- `errors`: what may lie behind an exception, by its text (`errors.toml`) and by its frames.
"""
