"""Grading of many notebooks: ``python -m rlrobot_edu grade NOTEBOOK…``."""

from __future__ import annotations

import multiprocessing
import secrets
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from datetime import date
from functools import partial
from pathlib import Path

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.attribution import Owner, class_of, owners_of
from rlrobot_grading.marking.guard import OPEN, Digests, Guard
from rlrobot_grading.marking.handed_in import Kept, handed_in
from rlrobot_grading.marking.kernel import end_with_parent
from rlrobot_grading.marking.marking import mark_file
from rlrobot_grading.marking.marks import (
    NO_RULES,
    Limits,
    Marked,
    Rules,
    Score,
    read_rules,
)
from rlrobot_grading.marking.misunderstood import as_table
from rlrobot_grading.marking.reports import (
    as_gradescope,
    as_sheet,
    as_text,
    check_paths,
    placed,
    sheet_names,
    write_each,
)
from rlrobot_grading.marking.students import read_students
from rlrobot_grading.marking.submission import (
    Submission,
    exercises_of,
    read_submission,
    sections_of,
)
from rlrobot_grading.marking.tables import table_for


def grade(
    notebooks: Sequence[str],
    lesson: str = "",
    seed: int | None = None,
    limits: Limits | None = None,
    jobs: int = 1,
    system: str = "plain",
    roster: str = "",
    rules: str = "",
    csv: str = "",
    gradescope: str = "",
    mistakes: str = "",
    feedback: str = "",
) -> int:
    """Grade notebooks, say how, and write the reports that are asked for; returns the exit code.

    notebooks: files, folders and patterns
    lesson: of all of them, looked for in each if not given; seed: of the secret tapes, drawn if not given
    roster, rules: paths of a list of students and of what counts how much
    csv, gradescope: paths of reports, of which the first is written for a system as canvas
    feedback: folder of a sheet for each student
    mistakes: path of a table of what was misunderstood
    Returns 0 if all notebooks have all points, 1 if not, 2 if a report was not written.
    Raises ValueError or OSError for what cannot be done.
    """
    limits = limits or Limits()
    limits.check()
    if jobs < 1 or (seed is not None and seed < 0):
        raise ValueError("--jobs at least 1, --seed not negative")
    if lesson:
        exercises_of(lesson)
    with tempfile.TemporaryDirectory(
        prefix="rlrobot-class-", ignore_cleanup_errors=True
    ) as temporary:
        found = handed_in(notebooks, Path(temporary))
        if gradescope and (n := len(found.notebooks)) != 1:
            raise ValueError(
                f"--gradescope writes the results of one notebook, and {n} are given"
            )
        asked = {"--csv": csv, "--gradescope": gradescope, "--mistakes": mistakes}
        written = {option: path for option, path in asked.items() if path}
        lists = [path for path in (roster, rules) if path]
        check_paths(written, feedback, [*found.files, *lists])
        students = read_students(roster) if roster else []
        what_counts = read_rules(rules) if rules else NO_RULES
        limits.guard.check(found.files)
        if not limits.guard:
            print(OPEN, file=sys.stderr)
        seed = secrets.randbits(64) if seed is None else seed
        digests = Digests()
        _say(found.notes([*written.values(), *lists, feedback]))
        given = [(kept, _submission(kept, lesson)) for kept in found.notebooks.values()]
        owners = owners_of([submission for _, submission in given], students)
        marks = marked_files(
            [kept.copy for kept, _ in given], lesson, seed, limits, jobs, what_counts
        )
        marked: dict[str, Marked] = {}
        for one, (_, submission), owner in zip(marks, given, owners, strict=True):
            digests.check(submission.name)
            one = _of_student(
                placed(one, submission.cells), submission.name, owner, what_counts
            )
            marked[one.name] = one
            print(as_text(one), flush=True)
        rows, notes = class_of([*marked.values()], students)
        counting = [one for one in rows if one.name]
        _say([*notes, *_unused(rules, what_counts, counting)])
        full = sum(one.is_full for one in counting)
        print(
            f"{full} of {len(counting)} notebooks have all points. Repeat this grading with --seed {seed}"
        )
        copies = {submission.name: kept.copy for kept, submission in given}
        texts: dict[str, Callable[[], str]] = {
            "--csv": lambda: table_for(system, rows),
            "--gradescope": lambda: as_gradescope(counting[0]),
            "--mistakes": lambda: as_table(counting),
        }
        made = {path: texts[option] for option, path in written.items()}
        if feedback:
            names = sheet_names(
                [
                    (one.name, one.student.id * bool(students), one.lesson)
                    for one in counting
                ]
            )
            for one, name in zip(counting, names, strict=True):
                made[str(Path(feedback, name))] = partial(_sheet, one, copies[one.name])
        all_written = write_each(made)
    return 2 if not all_written else int(full < len(counting))


def _say(notes: Sequence[str]) -> None:
    for note in notes:
        print(note)


def _submission(kept: Kept, lesson: str) -> Submission:
    """What is in a notebook, under the name of what was handed in, in letters that can be written into reports."""
    name = str(kept.path).encode(errors="backslashreplace").decode()
    return replace(read_submission(kept.copy, lesson), name=name)


def _of_student(one: Marked, name: str, owner: Owner, rules: Rules) -> Marked:
    """A marked notebook under its own name, with the student whose it is, and what that changes."""
    student, notes = owner.student, [*one.notes, *[owner.note] * bool(owner.note)]
    if student.row and one.made_for and one.made_for.lower() != student.id.lower():
        notes.append(
            f"This is the notebook that was made for {one.made_for}, not for {student.id}."
        )
    off = 0.0 if one.problem else rules.off(student.late, one.score)
    return replace(one, name=name, student=student, notes=notes, off=off)


def _unused(path: str, rules: Rules, marked: Sequence[Marked]) -> list[str]:
    """What the rules say of exercises that are not there, as a misspelt name is not."""
    there = {score.exercise for one in marked for score in one.scores}
    unused = [name for name in rules.points if name not in there]
    return (
        [f"{path}: no exercise here is called {', '.join(unused)}."] if unused else []
    )


def _sheet(one: Marked, copy: Path) -> str:
    return as_sheet(one, sections_of(copy), date.today())


def marked_files(
    paths: Sequence[Path],
    lesson: str,
    seed: int,
    limits: Limits,
    jobs: int,
    rules: Rules = NO_RULES,
) -> Iterator[Marked]:
    """Mark notebooks side by side, in `jobs` processes; yields them in the given order.

    A process that fails, or is killed, costs no more than the notebook that it was at: what it should have done after
    that is done by another.
    """
    ahead = list(paths)
    while ahead:
        with _pool(min(jobs, len(ahead))) as pool:
            waiting = [
                pool.submit(mark_file, path, lesson, seed, limits, rules)
                for path in ahead
            ]
            try:
                for future in waiting:
                    error = future.exception()
                    if error is None:
                        yield future.result()
                    elif isinstance(
                        error, ImportError
                    ):  # nothing can be graded without it
                        raise error
                    else:
                        yield _failed(ahead[0], error)
                        ahead.pop(0)
                        break
                    ahead.pop(0)
            finally:  # whoever stops early does not wait for the rest
                pool.shutdown(wait=False, cancel_futures=True)


def _pool(jobs: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(
        jobs,
        mp_context=multiprocessing.get_context("spawn"),
        initializer=end_with_parent,
    )


def _failed(path: Path, error: BaseException) -> Marked:
    fault = one_line(f"{type(error).__name__}: {error}")
    told = f"The grader itself failed at this notebook ({fault}); grade it again."
    return Marked(str(path), "", [Score("notebook", 0.0, told)], problem=told)


def run(arguments: dict[str, object]) -> None:
    """Grade as the command line says, and exit: 0 all points, 1 not, 2 wrong usage."""
    seconds, memory, user, container = (
        arguments.pop(name) for name in ("seconds", "memory", "user", "container")
    )
    try:
        limits = Limits(seconds, memory, Guard(user, container))  # type: ignore[arg-type]
        code = grade(**arguments, limits=limits)  # type: ignore[arg-type]
    except (ValueError, OSError, ImportError) as error:
        print(error, file=sys.stderr)
        code = 2
    sys.exit(code)
