"""Homework: submitted notebooks are graded by the checks of their lesson, from ``rlrobot-edu grade``.

Two processes take part, and only data goes from the second to the first:

- the grader's holds the checks and the tapes, calls, compares and decides; no line of a learner's runs in it;
- a fresh kernel runs the notebook, and calls the learner's functions with the arguments that it is sent. There the
  lesson's checks only take answers in.

What the grader must know of a course is a value, `course.Course`, which is passed on. Read in this order:

- `kernel_side`: the kernel's side; `kernel`: a kernel with limits, from the grader's side;
- `serialization`: values as text, so that nothing of a learner's is unpickled; `remote_function`: a function that runs
  in the kernel, which a check takes like any other;
- `guard`: what a kernel runs behind, another user or a container, and whether the grader's own files are as they were;
  `left_behind`: what is cleared away after it;
- `secret`: another tape for an exercise, drawn from a seed; `variants`: another variant of an assignment for each
  student;
- `handed_in`: which files are notebooks; `text`: their encoding; `submission`: which lesson a notebook belongs to, and
  which of its cells answer what, as far as `cell` can read it off; `one_notebook`: one notebook, run and judged;
  `scoring`: what that is worth; `marks`: scores and rules; `students`: a class; `attribution`: who handed in which
  notebook, and which counts;
- `grade`: many of them, side by side; `options`: what can be typed; `reports`: text and sheets; `tables`: points as
  CSV; `misunderstood`: the class's mistakes.

What this withstands: a verdict that is printed, checks that are changed or taken out, numbers of the notebook learned
by heart (another tape is drawn from a secret seed), endless loops, exits, too much memory.

The solutions ship in every student's package: they are public, and a copied one is right. Without a guard, that is
with `--trust`, a submission runs with the rights of whoever grades, and one that means harm can read and delete files.
"""
