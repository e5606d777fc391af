"""How an answer is run, what is kept of what it does, and when two values count as the same.

- `notebook`: whether there is one around.
- `limits`: runs a learner's function, which may raise, print, call exit() or never end; `compiling`: under numba's
  decorators it is judged as the Python that it is.
- `frames`: what the frames of an exception tell about its cause.
- `replay`: one case is tried; an `Outcome` is what came of it.
- `source`: `edited`, a wrong function made of the right one; `is_unfinished`, whether an answer is still to be written.
- `values`: when two values are the same, how they differ, how they are shown.
"""
