"""The code that the notebooks need beyond the library: one folder for each lesson, and code that lessons share.

The folder of a lesson, `lesson_NN`, belongs to notebook NN and imports nothing from other lessons:

- `update.md`, a page for each exercise: what is asked, three hints, and the typical mistakes, each with its id, its
  hint, the small edit that makes it, and wrong answers as learners write them (`rlrobot_grading/exercises/page.py`
  says how);
- `exercises.py`: right answers and cases; its `check` has the exercises by their names, so that the notebook says
  ``check.update(update)``;
- `given.py`, if exercises share something: a world, a table;
- `figures.py`: the pictures that the notebook shows, in its order; larger things have files of their own;
- `challenge.py`, in six: what counts in the open challenge, and how one robot or agent fares with an answer.

The folders of the assignments, `assignment_1` to `assignment_5` for the notebooks in `homework/`, are built in the same
way; right answers in them are not kept for later lessons.

They share: `exercises` (what an `exercises.py` is made of, on top of `rlrobot_grading`), `tapes` (recorded
transitions without chance, which exercises replay),
`plots` (what figures begin with), `paths` (ways through a room), `arm_world` (an arm as a table), `short_world`,
`runs`, `prediction` (what the reader expects, and the outcome), `old_questions`
(what earlier lessons taught; both read `questions.toml`), `challenge` (an answer gets a score), `paid` (a robot with
another reward), `clinic` (a task measured against the best loop in it), `my_functions` (right answers are kept; its
file is read by `sections`), `learners_files` (files that belong to the learner lose nothing), `progress` (how far a
learner is), and `finished` (whether all answers that the end of an assignment combines are written). `homework` grades
notebooks that are handed in, by the same checks. `my_course` opens the learner's copies of the notebooks.
Begin with lesson_03: `update.md`, `exercises.py`, then the docstring of `grading`.

`authoring` is for authors of lessons. ``rlrobot-edu course new NN "Title"`` makes lesson NN from a template, and
it passes its checks at once. Replace its parts one by one, and check them with ``rlrobot-edu course check NN``:

1. In the notebook each exercise is a cell with the tag ``exercise`` that ends with ``check.name(name)``.
2. `exercises.py` holds an `Exercise` or a `Question` of the same name.
3. `name.md` asks for it, and has the mistakes that you have seen learners make. Loading it reports an edit that does
   not fit. At least four wrong answers are written differently from the edits, each below the mistake that the check
   must name. Other right answers are in `tests/right_answers.py`.
4. `questions.toml` has, for the name of each prediction, the right answer and the reason.
"""
