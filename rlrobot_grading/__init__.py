"""Exercises whose checks name the first wrong step and the likely mistake; `marking` makes points of their verdicts.

This package knows nothing of robots and of reinforcement learning, and imports neither `rlrobot_edu` nor the course.
What an exercise does with a right answer, as keeping it, is given to it.

Read in this order; each folder imports those below it alone:

- `exercises`: what an exercise is. `verdict` is what a check says to the learner; `exercise` has `Exercise`, whose
  answer is a function, and `question` has `Question`, whose answer is a value; `page` reads the Markdown file of one.
- `hints`: how the hint for a wrong answer is found. `evidence` is what a detector is given, `detectors` their list.
- `answers`: how an answer is run, and when two values count as the same.
- `marking`: notebooks that are handed in are graded by the same checks.

An exercise in a few lines, here without a page:

>>> from rlrobot_grading.exercises.exercise import Exercise
>>> from rlrobot_grading.exercises.mistake import Mistake
>>> def redundancy(states):
...     return len(states) / len(set(states))
>>> check = Exercise(
...     redundancy,
...     [{"states": [5, 7, 5]}, {"states": [5, 7, 5, 7]}],
...     task="write how many states are in the queue for each different one",
...     returns="redundancy",
...     mistakes={"whole": Mistake("// cuts off the fraction; divide with /.", {"/": "//"})},
... )
>>> def answer(states):
...     return len(states) // len(set(states))
>>> check(answer)
✗ Case 1 of 2 is the first that differs.
  called with states = [5, 7, 5]
               expected   got
  redundancy        1.5     1
Hint: // cuts off the fraction; divide with /.

A wrong answer is recognised by what it computes, not by how it is written. It gets the hint of the first detector that
has one, in this order:

1. Chance: asked again, it answers differently.
2. A known mistake: in every case it does what an edit of the right function does (a case in which it fails is excused).
3. Relations between numbers: rounded, of the other sign, too large by 3, in every case.
4. Two of the known mistakes at once.
5. Notebook: an argument is taken from there, not from what the function is given.
6. One change: in every case it does what the right function does with one thing in it changed.
7. Events: the first call that differs, and does harm, of those that a loop makes of the functions that it is given.
8. Memory: more of a table changes than should, or always so many times too much.
9. Code: an argument is never read.
10. Cases: it is wrong just where an argument is True, or 0, or negative.
11. What is left: one part of the result is right and another wrong, or all that is wrong is too large.

An answer that stops with an exception has no values to compare, so `errors` says what the exception means. A verdict
carries the id of its mistake, or the detector's name; tests ask for that and not for words. The tape needs steps in
which every mistake shows, each in a step of its own.
"""
