"""The course's exercises, on top of `rlrobot_grading`.

- `parts`: what the `exercises.py` of a lesson imports, in one line; its `with_pages` has right answers kept in the
  learner's file.
- `design`: `Design`, an exercise in which a reward is designed and tried on pairs of situations.
"""
