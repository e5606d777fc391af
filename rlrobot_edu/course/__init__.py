"""What the notebooks need beyond the library: one room a lesson, and what several lessons share.

A lesson's room, `lesson_NN`, belongs to notebook NN and imports no other lesson's:

- `exercises/`: one file an exercise. `update.py` holds what is asked, the solution as a learner writes it, the cases,
  three hints and the typical mistakes, each with an id, a hint and the small edit of the solution that makes it.
  `update.md` beside it has wrong answers as learners write them, under the ids by which they must be recognised;
- `solutions.py` and `check.py` gather these, so that the notebook says ``check.update(update)``;
- `given.py`, where exercises share something: a world, a table, a hint;
- `figures.py`: the pictures that the notebook shows, in its order; what is larger than a picture has a file of its own;
- `predictions.py`: what becomes of the predictions, so that no cell of the notebook gives it away before it is run.

The rooms of the assignments, `assignment_1` to `assignment_5` for the notebooks in `homework/`, are built alike; what
is right in them is not kept for later lessons.

What they share: `grading` (exercises and verdicts), `tapes` (experience without chance for exercises to replay),
`stepper` (an agent's steps, forward and back), `bias_explorer`
(who advises whom in QBIASSR), `sliders`, `live_picture` (what follows a slider), `paths` (ways through a room),
`kernels`, `prediction` (what the reader expects, and the outcome), and `finished` (whether the answers are there that
the end of an assignment puts together). `homework` grades notebooks that are handed in, by the same checks. Begin with
lesson_02: `exercises/update.py`, then the docstring of `grading`.

`authoring` is for those who write lessons. ``rlrobot-edu course new NN "Title"`` makes lesson NN from a template, and
it passes its checks at once. Replace it piece by piece, and look with ``rlrobot-edu course check NN``:

1. In the notebook each exercise is a cell with the tag ``exercise`` that ends with ``check.name(name)``.
2. `exercises/name.py` holds an `Exercise` or a `Question` of the same name, with the mistakes that you have seen
   learners make. Loading it tells of an edit that does not fit its solution.
3. `exercises/name.md` has at least four wrong answers to it, in other words than the edits, each under the id by which
   it must be recognised. Other right answers stand in `tests/right_answers.py`.
4. `predictions.py` has for the name of each prediction the answer that is right, and why.
"""
