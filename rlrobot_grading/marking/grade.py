"""Grading of many notebooks: ``rlrobot-edu grade NOTEBOOK…``."""

from __future__ import annotations

import multiprocessing
import secrets
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from datetime import date
from functools import partial
from pathlib import Path

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.attribution import Owner, class_of, owners_of
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.guard import Digests, Guard
from rlrobot_grading.marking.handed_in import HandIn, handed_in, notes_on
from rlrobot_grading.marking.kernel import NotStartedError, end_with_parent
from rlrobot_grading.marking.marks import (
    NO_RULES,
    Limits,
    Marked,
    Rules,
    Score,
    read_rules,
)
from rlrobot_grading.marking.misunderstood import mistakes_table
from rlrobot_grading.marking.one_notebook import mark_file, not_marked
from rlrobot_grading.marking.reports import (
    as_sheet,
    as_text,
    check_paths,
    sheet_names,
    with_cells_shown,
    write_each,
)
from rlrobot_grading.marking.students import read_students
from rlrobot_grading.marking.submission import (
    Submission,
    read_submission,
    sections_of,
)
from rlrobot_grading.marking.tables import points_table


def grade(
    course: Course,
    notebooks: Sequence[str],
    lesson: str = "",
    seed: int | None = None,
    limits: Limits | None = None,
    jobs: int = 1,
    roster: str = "",
    rules: str = "",
    csv: str = "",
    mistakes: str = "",
    feedback: str = "",
) -> int:
    """Grade notebooks, print their points, and write the reports that are asked for; returns the exit code.

    Parameters
    ----------
    course : Course
        Whose notebooks these are.
    notebooks : sequence of str
        Files, folders and patterns.
    lesson : str
        Of all of them; looked for in each if not given.
    seed : int
        Of the secret tapes; drawn if not given.
    roster, rules : str
        Paths of a list of students, and of what counts how much.
    csv, mistakes : str
        Paths of tables: the points, and what was misunderstood.
    feedback : str
        Folder of a sheet for each student.

    Returns
    -------
    int
        0 if all notebooks have all points, 1 if not, 2 if a report was not written.

    Raises
    ------
    ValueError, OSError
        For what cannot be done.
    """
    limits = limits or Limits()
    limits.check()
    if jobs < 1 or (seed is not None and seed < 0):
        raise ValueError("--jobs at least 1, --seed not negative")
    if lesson:
        course.folder_of(lesson)
    with tempfile.TemporaryDirectory(
        prefix="rlrobot-class-", ignore_cleanup_errors=True
    ) as temporary:
        found, others = handed_in(notebooks, Path(temporary))
        paths = [one.path for one in found]
        outputs = {"--csv": csv, "--mistakes": mistakes, "--feedback": feedback}
        outputs = {option: path for option, path in outputs.items() if path}
        inputs = [path for path in (roster, rules) if path]
        check_paths(outputs, [*paths, *inputs])
        students = read_students(roster) if roster else []
        what_counts = read_rules(rules) if rules else NO_RULES
        limits.guard.check(course, paths)
        print(limits.guard.protects, file=sys.stderr)
        seed = secrets.randbits(64) if seed is None else seed
        digests = Digests(course)
        _print_each(notes_on(others, [*outputs.values(), *inputs]))

        submissions = [_submission(course, one, lesson) for one in found]
        owners = owners_of(submissions, students)
        copies = [one.copy for one in found if not one.fault]
        marks = marked_files(course, copies, lesson, seed, limits, jobs, what_counts)
        marked = []
        for hand_in, submission, owner in zip(found, submissions, owners, strict=True):
            one = not_marked(submission, what_counts) if hand_in.fault else next(marks)
            digests.check(submission.name)
            one = with_cells_shown(one, submission.cells)
            one = _of_student(one, submission.name, owner, what_counts)
            if hand_in.note:
                one.notes.append(hand_in.note)
            marked.append(one)
            print(as_text(one), flush=True)

        rows, notes = class_of(marked, students)
        counting = [one for one in rows if one.name]
        _print_each([*notes, *_unused(rules, what_counts, counting)])
        full = sum(one.is_full for one in counting)
        print(
            f"{full} of {len(counting)} notebooks have all points. Repeat this grading with --seed {seed}"
        )
        reports: dict[str, Callable[[], str]] = {}
        if csv:
            reports[csv] = lambda: points_table(rows)
        if mistakes:
            reports[mistakes] = lambda: mistakes_table(course, counting)
        if feedback:
            copy_of = {
                one.name: hand_in.copy
                for one, hand_in in zip(marked, found, strict=True)
            }
            for one, name in zip(counting, sheet_names(counting), strict=True):
                path = str(Path(feedback, name))
                reports[path] = partial(_sheet, one, copy_of[one.name])
        if not write_each(reports):
            return 2
    return int(full < len(counting))


def _print_each(notes: Sequence[str]) -> None:
    for note in notes:
        print(note)


def _submission(course: Course, one: HandIn, lesson: str) -> Submission:
    """What is in a notebook, under the name of what was handed in, in letters that can be written into reports."""
    name = str(one.path).encode(errors="backslashreplace").decode()
    read = read_submission(course, one.copy, lesson)
    return replace(read, name=name, problem=one.fault or read.problem)


def _of_student(one: Marked, name: str, owner: Owner, rules: Rules) -> Marked:
    """A marked notebook under its own name, with the student whose it is, and what that changes."""
    student = owner.student
    notes = list(one.notes)
    if owner.note:
        notes.append(owner.note)
    off = 0.0 if one.problem else rules.off(student.late, one.score)
    return replace(one, name=name, student=student, notes=notes, off=off)


def _unused(path: str, rules: Rules, marked: Sequence[Marked]) -> list[str]:
    """What the rules say of exercises that are not there, as a misspelt name is not."""
    there = {score.exercise for one in marked for score in one.scores}
    unused = [name for name in rules.points if name not in there]
    if not unused:
        return []
    return [f"{path}: no exercise here is called {', '.join(unused)}."]


def _sheet(one: Marked, copy: Path) -> str:
    return as_sheet(one, sections_of(copy), date.today())


def marked_files(
    course: Course,
    paths: Sequence[Path],
    lesson: str,
    seed: int,
    limits: Limits,
    jobs: int,
    rules: Rules = NO_RULES,
) -> Iterator[Marked]:
    """Mark notebooks side by side, in `jobs` processes; yields them in the given order.

    A process that fails, or is killed, costs no more than the notebook that it was at: what it should have done after
    that is done by another. A process that is killed takes the others with it, and nobody knows which one it was; so
    the notebooks at which they were are marked anew, one at a time.
    """
    ahead = list(paths)
    suspects = 0  # how many of the next may have had their process killed
    while ahead:
        batch = ahead[:1] if suspects else list(ahead)
        suspects = max(0, suspects - 1)
        n_processes = min(jobs, len(batch))
        with _pool(n_processes) as pool:
            waiting = [
                pool.submit(mark_file, course, path, lesson, seed, limits, rules)
                for path in batch
            ]
            try:
                for path, future in zip(batch, waiting, strict=True):
                    error = future.exception()
                    if isinstance(error, ImportError):
                        # nothing can be graded without it
                        raise error
                    if isinstance(error, BrokenProcessPool) and n_processes > 1:
                        suspects = n_processes
                        break
                    ahead.pop(0)
                    if error is not None:
                        yield _failed(path, error)
                        break
                    yield future.result()
            finally:  # whoever stops early does not wait for the rest
                pool.shutdown(wait=False, cancel_futures=True)


def _pool(jobs: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(
        jobs,
        mp_context=multiprocessing.get_context("spawn"),
        initializer=end_with_parent,
    )


def _failed(path: Path, error: BaseException) -> Marked:
    if isinstance(error, NotStartedError):
        problem = str(error)
    elif isinstance(error, BrokenProcessPool):
        problem = (
            "The process that marked this notebook was killed, and it was the only one. See whether this computer has "
            "memory left, look into the notebook, and grade it again behind --user or --container."
        )
    else:
        fault = one_line(f"{type(error).__name__}: {error}")
        problem = (
            f"The grader has a mistake that shows at this notebook ({fault}). That says nothing about the notebook: "
            "mark it by hand, and report the mistake."
        )
    return Marked(str(path), "", [Score("notebook", 0.0, problem)], problem=problem)


def run(
    course: Course,
    seconds: float,
    memory: int,
    user: str,
    container: str,
    trust: bool,
    **arguments: object,
) -> None:
    """Grade as the command line says, and exit: 0 all points, 1 not, 2 wrong usage."""
    try:
        limits = Limits(seconds, memory, Guard(user, container, trust))
        code = grade(course, limits=limits, **arguments)  # type: ignore[arg-type]
    except (ValueError, OSError, ImportError) as error:
        print(error, file=sys.stderr)
        code = 2
    sys.exit(code)
