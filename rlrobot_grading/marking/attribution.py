"""Which student handed in which notebook, and which of several notebooks of a student counts."""

from __future__ import annotations

import re
import unicodedata
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from typing import NamedTuple

from rlrobot_grading.marking.marks import Marked
from rlrobot_grading.marking.students import NOBODY, Student
from rlrobot_grading.marking.submission import Submission

NO_NOTEBOOK = "No notebook was handed in."
NO_ID = "No id of a student is in its name, nor in that of a folder around it."


class Owner(NamedTuple):
    """The student who handed in a notebook, and what the teacher should know of how that was found out."""

    student: Student
    note: str = ""


def owners_of(
    submissions: Sequence[Submission], students: Sequence[Student]
) -> list[Owner]:
    """Return the owner of each notebook: the student whose id is a word in the name of its file or of a folder.

    If files and folders name different students, those names count that distinguish most students of the class. The
    number of the lesson at the beginning of a file's name, or beside an id, is none. If no name has an id, it is the
    student for whom the notebook was made. If there is no list, the id is the name of the file, or its path if several
    files have the same name. A notebook that fits nobody, or two, is nobody's, and a note says so. Raises ValueError
    if that is true of all.
    """
    if not students:
        stems = [Path(one.name).stem for one in submissions]
        if len(set(stems)) < len(stems):
            stems = [Path(one.name).with_suffix("").as_posix() for one in submissions]
        return [Owner(Student(stem)) for stem in stems]
    by_id = {_fold(student.id): student for student in students}
    found = []
    for one in submissions:
        stem, *folders = [_ids_in(name, by_id) for name in _names(one)]
        if len(stem) > 1:  # as in 7_assignment_1
            stem.discard(_number(one))
        found.append([stem, *folders])
    levels = zip_longest(*found, fillvalue=set())
    spread = [len(set().union(*level)) for level in levels]
    owners = [
        _owner(one, ids, spread, by_id)
        for one, ids in zip(submissions, found, strict=True)
    ]
    if submissions and all(owner.student is NOBODY for owner in owners):
        raise ValueError(
            f"{submissions[0].name}: no id of a student is in its name, nor in that of a folder around it; nor is "
            f"there one in any other. The list's first id is {students[0].id}"
        )
    return owners


def _owner(
    one: Submission,
    ids: Sequence[set[str]],
    spread: Sequence[int],
    by_id: dict[str, Student],
) -> Owner:
    """Return the owner of one notebook.

    ids: those in the name of the file, of its folder, and so on outwards
    spread: how many ids of the class stand in the names of each of these levels
    """
    named = [level for level, here in enumerate(ids) if here]
    if not named:
        student = by_id.get(_fold(one.made_for))
        if student is None:
            return Owner(NOBODY, NO_ID)
        return Owner(
            student,
            f"No id of a student is in its name; it is the notebook that was made for {student.id}.",
        )
    best = max(named, key=lambda level: (spread[level], -level))
    here = sorted(by_id[id].id for id in ids[best])
    if len(here) > 1:
        both = " and ".join(here)
        return Owner(
            NOBODY, f"The ids {both} are both in its name: rename it by one of them."
        )
    others = sorted(by_id[id].id for id in set().union(*ids) - ids[best])
    notes = []
    if others:
        notes.append(
            f"The id {others[0]} is in its name, too; it counts as {here[0]}'s."
        )
    if one.made_for and _fold(one.made_for) != _fold(here[0]):
        notes.append(
            f"This is the notebook that was made for {one.made_for}, not for {here[0]}."
        )
    return Owner(by_id[_fold(here[0])], " ".join(notes))


def _ids_in(name: str, ids: Sequence[str] | dict[str, Student]) -> set[str]:
    """Return the ids that stand as words in a name of a file or folder; of "ada" and "ada-marie" the longer."""
    spans = {}
    for id in ids:
        for match in re.finditer(rf"(?<![^\W_]){re.escape(id)}(?![^\W_])", name):
            spans[match.span()] = id
    found = set()
    for (start, end), id in spans.items():
        around = [(a, b) for a, b in spans if a <= start and end <= b]
        if around == [(start, end)]:
            found.add(id)
    return found


def _names(one: Submission) -> list[str]:
    """Return the names of the file, without the number of its lesson, and of its folders, from the inside out."""
    path = Path(one.name)
    stem = path.stem.removeprefix(f"{_number(one)}_")
    return [_fold(name) for name in (stem, *reversed(path.parent.parts))]


def _number(one: Submission) -> str:
    return one.lesson.removeprefix("assignment_")


def _fold(text: str) -> str:
    # macOS writes an ü as two signs
    return unicodedata.normalize("NFC", text).lower()


def class_of(
    marked: Sequence[Marked], students: Sequence[Student]
) -> tuple[list[Marked], list[str]]:
    """Return the notebooks that count, in the order of the list, and notes.

    For each student and lesson one counts, of several the one with the most points, and of several with the same
    points the last by name. A student who handed in none has a line without points.
    """
    known_lesson = {one.student.id: one.lesson for one in marked if one.lesson}
    tries: dict[tuple[str, str], list[Marked]] = defaultdict(list)
    for one in marked:
        owner = one.student.id or f"nobody's {one.name}"
        # a file whose lesson is unknown is another try at the student's lesson
        lesson = one.lesson or known_lesson.get(one.student.id, "")
        tries[owner, lesson].append(one)
    counting = []
    notes = []
    for several in tries.values():
        best = max(several, key=_rank)
        if len(several) > 1:
            note = _which_counts(best, several)
            notes.append(note)
            best = replace(best, notes=[*best.notes, note])
        counting.append(best)
    handed_in = {one.student.id for one in counting}
    absent = [student for student in students if student.id not in handed_in]
    for student in absent:
        counting.append(Marked("", "", [], student=student, problem=NO_NOTEBOOK))
    ungraded = [one.name for one in counting if one.problem and one.name]
    unknown = [one.name for one in counting if students and not one.student.id]
    if absent:
        ids = ", ".join(student.id for student in absent)
        notes.append(f"There is no notebook of {ids}.")
    if ungraded:
        notes.append(
            f"Not graded: {', '.join(ungraded)}. The table has empty cells for that, not 0 points."
        )
    if unknown:
        notes.append(f"Of no student of the list: {', '.join(unknown)}.")
    place = {student.id: i for i, student in enumerate(students)}
    counting.sort(key=lambda one: place.get(one.student.id, len(place)))
    return counting, notes


def _rank(one: Marked) -> tuple[bool, float, list[tuple[int, str]]]:
    """Return a key for sorting by points, then by name, where 9 comes before 10."""
    parts = []
    for part in re.split(r"(\d+)", Path(one.name).stem):
        parts.append((int(part), "") if part.isdecimal() else (-1, part))
    return not one.problem, one.score, parts


def _which_counts(best: Marked, several: Sequence[Marked]) -> str:
    """Return a note on which of several notebooks of a student counts, and what each has got."""
    points = {one.name: f"{one.score:g}" for one in several}
    for one in several:
        if one.problem:
            points[one.name] = "not graded"
    others = [
        f"{name} ({points[name]})" for name in sorted(points) if name != best.name
    ]
    return (
        f"{len(several)} notebooks of {best.student.id}: the one with the most points counts, "
        f"{best.name} ({points[best.name]}), and not {' nor '.join(others)}."
    )
