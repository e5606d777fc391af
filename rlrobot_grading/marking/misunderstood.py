"""What a class has misunderstood: the mistakes that were recognised, counted over all notebooks."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from typing import NamedTuple

from rlrobot_grading.hints.detectors import DETECTORS
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.marks import Marked, Score
from rlrobot_grading.marking.tables import as_csv

ONLY_THESE = "these_numbers_alone"  # the mistake of an answer that is right for the notebook's numbers only


class Misunderstood(NamedTuple):
    """A mistake in an exercise: in a word or two, the hint that was given, and the notebooks that made it."""

    lesson: str
    exercise: str
    mistake: str
    hint: str
    notebooks: list[str]


def misunderstood(course: Course, marked: Sequence[Marked]) -> list[Misunderstood]:
    """Return all mistakes, exercise by exercise in the order of the lesson, the most frequent first.

    Wrong answers that fit no known mistake are together if one detector has found their hints, or if all got the same:
    a detector's hint may name variables of the learner's.
    """
    answers: dict[tuple[str, str], list[tuple[str, Score]]] = defaultdict(list)
    for one in marked:
        for score in one.scores:
            if score.max_score and not one.problem:
                answers[one.lesson, score.exercise].append((one.name, score))
    found = []
    for (lesson, exercise), scores in answers.items():
        mistakes = course.exercises_of(lesson)[exercise].mistakes
        known = {mistake.id for mistake in mistakes} | {ONLY_THESE}
        made: dict[tuple[str, str], list[tuple[str, str]]] = defaultdict(list)
        for notebook, score in scores:
            if not score.is_right:
                made[_mistake(score, known)].append((notebook, score.hint))
        for (mistake, _), hinted in sorted(
            made.items(), key=lambda item: (-len(item[1]), item[0])
        ):
            # some hints name a number of the learner's, and differ: the one that most of them got
            hints = Counter(hint for _, hint in hinted if hint).most_common(1)
            hint = hints[0][0] if hints else ""
            notebooks = [notebook for notebook, _ in hinted]
            found.append(Misunderstood(lesson, exercise, mistake, hint, notebooks))
    return found


def _mistake(score: Score, known: set[str]) -> tuple[str, str]:
    """Return what a mistake is called, and which detector or hint distinguishes it from others of this name."""
    if not score.is_answered:
        return "not answered", ""
    is_known = known.issuperset(score.mistake.split("+"))
    if score.mistake and (is_known or not score.hint):
        return score.mistake.replace("_", " ").replace("+", " and "), ""
    return "not recognised", score.mistake if score.mistake in DETECTORS else score.hint


def mistakes_table(course: Course, marked: Sequence[Marked]) -> str:
    """Return a CSV table: a line for each mistake, with the notebooks that made it."""
    rows: list[list[object]] = [
        ["lesson", "exercise", "mistake", "how many", "hint", "notebooks"]
    ]
    for one in misunderstood(course, marked):
        names = " ".join(one.notebooks)
        rows.append([*one[:3], len(one.notebooks), one.hint, names])
    return as_csv(rows)
