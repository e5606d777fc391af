"""Grading of many notebooks: ``python -m rlrobot_edu grade NOTEBOOK…``."""

from __future__ import annotations

import glob
import multiprocessing
import secrets
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

from rlrobot_edu.course.grading.values import one_line
from rlrobot_edu.course.homework.alike import alike as alike_table
from rlrobot_edu.course.homework.guard import OPEN, Digests, Guard
from rlrobot_edu.course.homework.kernel import end_with_parent
from rlrobot_edu.course.homework.marking import mark_file
from rlrobot_edu.course.homework.marks import Limits, Marked, Score
from rlrobot_edu.course.homework.misunderstood import as_page, as_table
from rlrobot_edu.course.homework.reports import as_gradescope, as_junit, as_sheet, as_text
from rlrobot_edu.course.homework.rules import NO_RULES, Rules, read_rules
from rlrobot_edu.course.homework.students import read_students, students_of
from rlrobot_edu.course.homework.submission import exercises_of, read_submission, sections_of
from rlrobot_edu.course.homework.tables import table_for
from rlrobot_edu.files import write_whole


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
    junit: str = "",
    gradescope: str = "",
    mistakes: str = "",
    feedback: str = "",
    alike: str = "",
) -> int:
    """Grade notebooks, say how, and write the reports that are asked for; returns the exit code.

    notebooks: files, folders and patterns
    lesson: of all of them, looked for in each if not given; seed: of the secret tapes, drawn if not given
    roster, rules: paths of a list of students and of what counts how much
    csv, junit, gradescope: paths of reports, of which the first is written for a system as canvas
    feedback: folder of a sheet for each notebook; alike: path of a table of answers that are alike to the token
    mistakes: path of what was misunderstood: a page if it ends with .html, else a table that names the notebooks
    Returns 0 if all notebooks have all points, 1 otherwise. Raises ValueError or OSError for what cannot be done.
    """
    limits = limits or Limits()
    paths = [path for name in notebooks for path in _files(name)]
    if gradescope and len(paths) != 1:
        raise ValueError(f"--gradescope writes the results of one notebook, and {len(paths)} are given")
    if limits.seconds <= 0 or limits.memory < 256 or jobs < 1 or (seed is not None and seed < 0):
        raise ValueError("--seconds must be above 0, --memory at least 256, --jobs at least 1, --seed not negative")
    if lesson:
        exercises_of(lesson)
    seed = secrets.randbits(64) if seed is None else seed
    limits.guard.check(paths)
    if not limits.guard:
        print(OPEN, file=sys.stderr)
    digests = Digests()
    students, what_counts = read_students(roster) if roster else [], read_rules(rules) if rules else NO_RULES
    whose, marked = students_of(paths, students), []
    for one, student in zip(marked_files(paths, lesson, seed, limits, jobs, what_counts), whose, strict=True):
        digests.check(one.name)
        if students and one.made_for and one.made_for.lower() != student.id.lower():
            one.notes.append(f"This is the notebook that was made for {one.made_for}, not for {student.id}.")
        marked.append(replace(one, student=student, off=what_counts.off(student.late, one.score)))
        print(as_text(marked[-1]), flush=True)
    full = sum(one.is_full for one in marked)
    if absent := [one.id for one in students if one not in whose]:
        print(f"There is no notebook of {', '.join(absent)}.")
    print(f"{full} of {len(marked)} notebooks have all points. Repeat this grading with --seed {seed}")
    print(f"The grader's own files have the digest {digests}, before and after.")
    counted = as_page if mistakes.endswith(".html") else as_table
    for path, write in ((csv, lambda marked: table_for(system, marked)), (junit, as_junit), (mistakes, counted)):
        if path:
            write_whole(path, write(marked))
    if alike:
        write_whole(alike, alike_table([read_submission(path, lesson) for path in paths]))
    if gradescope:
        write_whole(gradescope, as_gradescope(marked[0]))
    if feedback:
        Path(feedback).mkdir(parents=True, exist_ok=True)
        for one, path in zip(marked, paths, strict=True):
            write_whole(Path(feedback, _sheet_of(path)), as_sheet(one, sections_of(path)))
    return 0 if full == len(marked) else 1


def _files(name: str) -> list[Path]:
    """The notebooks that a name stands for: a file, all in a folder, or a pattern that the shell has left as it is."""
    path = Path(name)
    if path.is_file():
        return [path]
    found = path.rglob("*.ipynb") if path.is_dir() else map(Path, glob.glob(name, recursive=True))
    files = sorted(file for file in found if file.is_file() and ".ipynb_checkpoints" not in file.parts)
    if not files:
        raise FileNotFoundError(f"{name}: there is no such file, nor a notebook in it; name what is to be graded")
    return files


def _sheet_of(path: Path) -> str:
    """The name of a notebook's sheet: with its folders, for in some hand-ins all notebooks have the same name."""
    near = path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
    return "__".join(part for part in near.with_suffix(".md").parts if part not in (near.anchor, ".."))


def marked_files(
    paths: Sequence[Path], lesson: str, seed: int, limits: Limits, jobs: int, rules: Rules = NO_RULES
) -> Iterator[Marked]:
    """Mark notebooks side by side, in `jobs` processes; yields them in the given order.

    A process that fails, or is killed, costs no more than the notebook that it was at: what it should have done after
    that is done by another.
    """
    ahead = list(paths)
    while ahead:
        with _pool(jobs) as pool:
            waiting = [pool.submit(mark_file, path, lesson, seed, limits, rules) for path in ahead]
            try:
                for future in waiting:
                    error = future.exception()
                    if error is None:
                        yield future.result()
                    elif isinstance(error, ImportError):  # nothing can be graded without it
                        raise error
                    else:
                        yield _failed(ahead[0], error)
                        ahead.pop(0)
                        break
                    ahead.pop(0)
            finally:  # whoever stops early does not wait for the rest
                pool.shutdown(wait=False, cancel_futures=True)


def _pool(jobs: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(jobs, mp_context=multiprocessing.get_context("spawn"), initializer=end_with_parent)


def _failed(path: Path, error: BaseException) -> Marked:
    told = (
        f"The grader itself failed at this notebook ({one_line(f'{type(error).__name__}: {error}')}); grade it again."
    )
    return Marked(str(path), "", [Score("notebook", 0.0, told)], [told])


def run(arguments: dict[str, object]) -> None:
    """Grade as the command line says, and exit: 0 all points, 1 not, 2 wrong usage."""
    seconds, memory, user, container = (arguments.pop(name) for name in ("seconds", "memory", "user", "container"))
    try:
        limits = Limits(seconds, memory, Guard(user, container))  # type: ignore[arg-type]
        code = grade(**arguments, limits=limits)  # type: ignore[arg-type]
    except (ValueError, OSError, ImportError) as error:
        print(error, file=sys.stderr)
        code = 2
    sys.exit(code)
