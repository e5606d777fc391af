"""Whose notebooks these are: by the ids in the names of files and folders; and of several of one, which counts."""

from __future__ import annotations

import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from statistics import median_low
from typing import NamedTuple

from rlrobot_grading.marking.marks import Marked
from rlrobot_grading.marking.students import NOBODY, Student
from rlrobot_grading.marking.submission import Submission

MOODLE = re.compile(
    r"_(\d+)_assignsubmission_"
)  # Ada Lovelace_123456_assignsubmission_file_
CANVAS = re.compile(
    r"[^_]+_(?:late_)?(\d+)_\d{3,}_"
)  # lovelaceada_123456_7890123_02_q_learning-1.ipynb
# How the name of a file ends that was handed in or saved again
COPY = re.compile(
    r"(?:[- ]\d{1,2}|\s*\(\d{1,2}\)|[-–_ ]+(?:copy|kopie|copie|copia|cópia)\d*)+$"
)

NO_NOTEBOOK = "No notebook was handed in."


class Owner(NamedTuple):
    """The student whose notebook it is, and what an instructor should know of how that was found out."""

    student: Student
    note: str = ""


def owners_of(
    submissions: Sequence[Submission], students: Sequence[Student]
) -> list[Owner]:
    """Whose each notebook is: the student whose id is a word in the name of the file, or in that of a folder around it.

    If files and folders name different students, those names count that tell most students of the class apart. The
    number of the assignment itself is no id. If no name has an id, it is the student for whom the notebook was made.
    If there is no list, the id is the name of the file, or of its folders if several files have the same name.
    A notebook that fits nobody, or two, is nobody's, and a note says so. Raises ValueError if that is true of all.
    """
    if not students:
        return [
            Owner(Student(name))
            for name in _different([Path(one.name) for one in submissions])
        ]
    found = _students_named(submissions, students)
    apart = [len(set().union(*level)) for level in zip_longest(*found, fillvalue=set())]
    by_word = {word: student for student in students for word in _folded(student.words)}
    owners = [
        _owner(_names(one), levels, apart, by_word.get(_fold(one.made_for)))
        for one, levels in zip(submissions, found, strict=True)
    ]
    if submissions and all(owner.student is NOBODY for owner in owners):
        raise ValueError(
            f"{submissions[0].name}: no id of a student is in its name, nor in that of a folder around it; nor is "
            f"there one in any other. The list's first id is {students[0].id}"
        )
    return owners


def _owner(
    names: list[str],
    levels: list[set[Student]],
    apart: Sequence[int],
    made_for: Student | None,
) -> Owner:
    named = [i for i, students in enumerate(levels) if students]
    if not named and made_for is None:
        return Owner(
            NOBODY,
            "No id of a student is in its name, nor in that of a folder around it.",
        )
    if not named:
        return Owner(
            made_for,
            f"No id of a student is in its name; it is the notebook that was made for {made_for.id}.",
        )
    # in a tie a name that is the id and nothing else, and then the nearest
    best = max(
        named,
        key=lambda i: (
            apart[i],
            any(names[i] in _folded(one.words) for one in levels[i]),
            -i,
        ),
    )
    ids = sorted(student.id for student in levels[best])
    if len(ids) > 1:
        return Owner(
            NOBODY,
            f"The ids {' and '.join(ids)} are both in its name: rename it by one of them.",
        )
    (student,) = levels[best]
    others = sorted({other.id for i in named for other in levels[i]} - {student.id})
    return Owner(
        student,
        f"The id {others[0]} is in its name, too; it counts as {student.id}'s."
        if others
        else "",
    )


def _students_named(
    submissions: Sequence[Submission], students: Sequence[Student]
) -> list[list[set[Student]]]:
    """For each notebook the students whose ids are in the file's name, in that of its folder, and so on outwards."""
    own = [one.lesson.removeprefix("assignment_") for one in submissions]
    often = [
        sum(len(_word(n).findall(name)) for name in _names(one))
        for one, n in zip(submissions, own, strict=True)
    ]
    by_lesson: dict[str, list[int]] = defaultdict(list)
    for n, times in zip(own, often, strict=True):
        by_lesson[n].append(times)
    # how often the number of the assignment stands in a name by itself, as in 1_a_robots_day_as_numbers
    usual = {
        n: median_low(times) if len(times) > 2 else min(1, *times)
        for n, times in by_lesson.items()
    }
    words = [
        (_word(word), word, student)
        for student in students
        for word in _folded(student.words)
    ]
    found = []
    for one, n, times in zip(submissions, own, often, strict=True):
        known = [word for word in words if word[1] != n or times > usual[n]]
        first = [
            _in(name, known, COPY.search(name)) for name in _names(one)
        ]  # the 1 of work-1.ipynb is rarely an id
        found.append(
            first if any(first) else [_in(name, known) for name in _names(one)]
        )
    for level, named in enumerate(zip_longest(*found, fillvalue=set())):
        if (
            2 < len(found) < 2 * sum(map(bool, named)) and len(set().union(*named)) == 1
        ):  # as in week 3/7/02.ipynb
            for levels in found:
                if len(
                    [students for students in levels if students]
                ) > 1 and level < len(levels):
                    levels[level] = set()
    return found


def _in(
    name: str,
    words: Iterable[tuple[re.Pattern[str], str, Student]],
    copy: re.Match[str] | None = None,
) -> set[Student]:
    """The students who are named in a name of a file or folder; of "ada" and "ada-marie" the longer.

    copy: the end of the name that says which copy it is, in which no id is looked for
    """
    place = MOODLE.search(name) or CANVAS.match(name)
    if place and (
        by_number := {student for _, word, student in words if word == place[1]}
    ):
        return by_number
    spans = [
        (match.span(), student)
        for word, _, student in words
        for match in word.finditer(name)
    ]
    spans = [
        (span, student)
        for span, student in spans
        if copy is None or span[0] < copy.start()
    ]
    return {
        student
        for (a, b), student in spans
        if not any(c <= a and b <= d and d - c > b - a for (c, d), _ in spans)
    }


def _names(one: Submission) -> list[str]:
    """The names of the file and of its folders, from the inside to the outside."""
    path = Path(one.name)
    return [_fold(name) for name in (path.stem, *reversed(path.parent.parts))]


def _fold(text: str) -> str:
    return unicodedata.normalize("NFC", text).lower()  # macOS takes an ü apart


def _folded(words: Iterable[str]) -> set[str]:
    return set(map(_fold, words))


def _word(text: str) -> re.Pattern[str]:
    return (
        re.compile(rf"(?<![^\W_]){re.escape(text)}(?![^\W_])")
        if text
        else re.compile(r"(?!)")
    )


def _different(paths: Sequence[Path]) -> list[str]:
    """Names of files, or of their folders if several files have the same; of whole paths if that is not enough."""
    if len({path.stem for path in paths}) == len(paths):
        return [path.stem for path in paths]
    folders = {path.parent for path in paths}
    differ = len({folder.name for folder in folders}) == len(folders)
    return [path.parent.name if differ else path.parent.as_posix() for path in paths]


def class_of(
    marked: Sequence[Marked], students: Sequence[Student]
) -> tuple[list[Marked], list[str]]:
    """The notebooks that count, in the order of the list, with a line for each student who handed in none; and notes.

    For each student and lesson one counts, of several the one with the most points. One that could not be graded is
    another try at the lesson of those that could.
    """
    graded = {_whose(one): one.lesson for one in reversed(marked) if not one.problem}
    tries: dict[tuple[str, str], list[Marked]] = defaultdict(list)
    for one in marked:
        tries[
            _whose(one), graded.get(_whose(one), "") if one.problem else one.lesson
        ].append(one)
    counting, notes = [], []
    for several in tries.values():
        best = max(
            several, key=lambda one: (not one.problem, one.score, _in_order(one.name))
        )
        if len(several) > 1:
            notes.append(_which(best, several))
            best = replace(best, notes=[*best.notes, notes[-1]])
        counting.append(best)
    handed_in = {one.student.id for one in counting}
    if absent := [student for student in students if student.id not in handed_in]:
        counting += [
            Marked("", "", [], student=student, problem=NO_NOTEBOOK)
            for student in absent
        ]
        notes.append(
            f"There is no notebook of {', '.join(student.id for student in absent)}."
        )
    if ungraded := [one.name for one in counting if one.problem and one.name]:
        notes.append(
            f"Not graded: {', '.join(ungraded)}. Tables have empty cells for that, not 0 points."
        )
    if nobodys := [one.name for one in counting if students and not one.student.id]:
        notes.append(
            f"Not known whose: {', '.join(nobodys)}. Only the plain table has a line for that."
        )
    place = {student.id: i for i, student in enumerate(students)}
    return sorted(
        counting, key=lambda one: place.get(one.student.id, len(place))
    ), notes


def _which(best: Marked, several: Sequence[Marked]) -> str:
    """Which of several notebooks of a student counts, and what each has got."""
    got = {
        one.name: "not graded" if one.problem else f"{one.score:g}" for one in several
    }
    others = [
        f"{name} ({got[name]})"
        for name in sorted(got, key=_in_order)
        if name != best.name
    ]
    return (
        f"{len(several)} notebooks of {best.student.id}: the one with the most points counts, "
        f"{best.name} ({got[best.name]}), and not {' nor '.join(others)}."
    )


def _whose(one: Marked) -> str:
    return one.student.id or f"nobody's {one.name}"


def _in_order(name: str) -> list[tuple[int, str]]:
    """A key for sorting by which 9 comes before 10."""
    return [
        (int(part), "") if part.isdecimal() else (-1, part)
        for part in re.split(r"(\d+)", Path(name).stem)
    ]
