"""What the exercises of all lessons share: a verdict on one answer. Points are made of verdicts in `homework`.

Read in this order:

- `verdict`: what a check says to the learner, a `Verdict`: waiting, right or wrong, the first wrong step and a hint.
- `exercise`: `Question` (the answer is a value) and `Exercise` (the answer is a function: a tape of arguments is
  replayed on it, step by step, beside the right function), each with its list of `Mistake`.
- `design`: `Design`, an exercise in which a reward is designed and tried on pairs of situations.
- `detectors`: how the hint for a wrong answer is found: an ordered list; `evidence`: what a detector is given.
- `page`: the Markdown file of an exercise: what is asked, hints, mistakes and wrong answers.
- `parts`: what the `exercises.py` of a lesson imports of all these.
- `one_change`, `further_changes`, `as_if`: all functions that differ from the right one in one thing, and the message
  for an answer that does the same as one of them; `formula`: the same for a question in numbers.
- `events`: the calls that a loop makes, beside those of the right loop.
- `source`: `edited`, which makes a wrong function of the right one, as ``{"max(q[s_next])": "q[s_next].mean()"}`` says.
- `errors`: what may lie behind an exception, by its text (`errors.toml`) and by its frames (`frames`).
- `suspicions`: what the values of an answer have in common that shows no known mistake.
- `values`: when two values count as the same, how they differ, how they are shown.

An exercise in five lines, here without a page::

    def redundancy(states):
        return len(states) / len(set(states))

    check = Exercise(
        redundancy, [{"states": [5, 7, 5, 7]}, {"states": [5, 7, 5]}], returns="redundancy",
        task="return how many states are in the queue for each different one among them",
        mistakes={"whole": Mistake("// cuts off what comes after the point; divide with /.", {"/": "//"})},
    )
    check(learners_function)

A wrong answer is recognised by what it computes, not by how it is written. It gets the hint of the first detector that
has one, in this order:

1. Chance: asked again, it answers differently.
2. A known mistake: in every case it does what an edit of the right function does (a case in which it fails is excused).
3. Relations between numbers: rounded, of the other sign, too large by 3, in every case.
4. Two of the known mistakes at once.
5. Notebook: an argument is taken from there, not from what the function is given.
6. One change: in every case it does what the right function does with one thing in it changed.
7. Events: the first call that differs in the order in which a loop calls the world, `choose` and `update`.
8. Memory: more of a table changes than should, or always so many times too much.
9. Code: an argument is never read.
10. Cases: it is wrong just where an argument is True, or negative, or empty.

An answer that stops with an exception has no values to compare, so `errors` says what the exception means. A verdict
carries the id of its mistake, or the detector's name; tests ask for that and not for words. The tape needs steps in
which every mistake shows, each in a step of its own.
"""
