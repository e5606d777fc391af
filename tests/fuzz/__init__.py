"""The attack on the library: bad files and bad calls by the thousand, and what each must answer.

Read in this order:

- `contract`: what any call may do with any input, and `attempt`, which makes a call and says whether it kept to that.
- `strategies`: how a valid file is damaged, and which values are given where others were expected.
- `seeds`: the valid files, one of each kind.
- `things`: what programs can name: environments that lie, objects that misbehave, ways to use what came back.
- `targets`: a `Target` draws cases, and attacks with one. A case is a few files, so that it can be kept and read.
- `files`: the readers; a case is a damaged file. `programs`: all other calls; a case is a short Python program, of
  `values`. Which, say `learning`, `describing`, `surroundings`; `task_files` has those that a learner writes.
- `worker`: attacks with many cases in a process of its own, since a bad one may crash it. With atheris, which counts
  what part of the library a case has reached, it looks for cases that reach more.
- `run`: what ``make fuzz`` starts: workers for all targets, one line each of what they found.

What was found stays in ``found/<target>/`` and is tried again in ``tests/library/test_fuzz.py``.
"""
