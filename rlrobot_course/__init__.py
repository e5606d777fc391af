"""The code that the notebooks need beyond the library: one folder for each lesson, and code that lessons share.

The folder of a lesson, `lesson_NN`, belongs to notebook NN and imports nothing from other lessons:

- `update.md`, a page for each exercise: what is asked, three hints, and the typical mistakes, each with its id, its
  hint, the small edit that makes it, and wrong answers as learners write them (`rlrobot_grading/exercises/page.py`
  says how);
- `exercises.py`: right answers and cases; its `check` has the exercises by their names, so that the notebook says
  ``check.update(update)``;
- `fixtures.py`, if exercises share something: a world, a table;
- `figures.py`: the pictures that the notebook shows, in its order; larger things have files of their own;
- `handles.py`, in seven: what the reader moves, each with its program in JavaScript beside it;
- `challenge.py`, in six: what counts in the open challenge, and how one robot or agent fares with an answer.

The folders `assignment_1` to `assignment_5`, for the notebooks in `notebooks/homework/`, are built in the same way;
right answers in them are not kept for later lessons.

Lessons share these folders:

- `exercises`: what an `exercises.py` is made of, on top of `rlrobot_grading`;
- `worlds`: where exercises and robots act: recorded transitions without chance (`tapes`), an arm as a table
  (`arm_world`), any environment behind two short methods (`short_world`), a robot with a reward of one's own
  (`own_reward`), and a task measured against the best loop in it (`clinic`);
- `learner`: what belongs to the learner: copies of the notebooks (`my_course`), right answers that are kept
  (`my_functions`, read by `sections`), files that lose nothing (`learners_files`), how far a learner is (`progress`),
  and whether all answers of an assignment's last cell are written (`finished`);
- `questions`: what the reader expects, and the outcome (`prediction`), and what earlier lessons taught
  (`old_questions`); both read `questions.toml`;
- `play`: an answer gets a score (`challenge`), the course's robot lesson by lesson (`scoreboard`) and its picture
  (`staircase`), and the numbers of the reproduction (`report`);
- `handles`: pictures that the reader moves, by sliders, a scrubber, switches and clicks;
- `trace_lab`: what lessons 07 and 08 let the reader move: a path over a grid, its traces and its values;
- `thread`: the learner's own rows, model and robot through lessons 14, 16 and 18;
- `figures`: what figures begin with (`plots`), ways through a room (`paths`), and curves of runs (`runs`).

Exercises, verdicts and hints are `rlrobot_grading`. `commands` are those of ``rlrobot-edu``.
Begin with lesson_03: `update.md`, `exercises.py`, then the docstring of `rlrobot_grading`.

`authoring` is for authors of lessons. ``rlrobot-edu course new NN "Title"`` makes lesson NN from a template, and
it passes its checks at once. Replace its parts one by one, and check them with ``rlrobot-edu course check NN``:

1. In the notebook each exercise is a cell with the tag ``exercise`` that ends with ``check.name(name)``.
2. `exercises.py` holds an `Exercise` or a `Question` of the same name.
3. `name.md` asks for it, and has the mistakes that you have seen learners make. Loading it reports an edit that does
   not fit. At least four wrong answers are written differently from the edits, each below the mistake that the check
   must name. Other right answers are in `tests/right_answers.py`.
4. `questions.toml` has, for the name of each prediction, the right answer and the reason.
"""
