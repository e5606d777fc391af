"""What a class has misunderstood: the mistakes that were recognised, counted over all notebooks."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

from rlrobot_grading.hints.detectors import DETECTORS
from rlrobot_grading.marking.marks import Marked, Score
from rlrobot_grading.marking.submission import exercises_of
from rlrobot_grading.marking.tables import as_csv

ONLY_THESE = "these_numbers_alone"  # the mistake of an answer that is right for the notebook's numbers only


class Misunderstood(NamedTuple):
    """A mistake in an exercise: in a word or two, the hint that was given, and the notebooks that made it."""

    lesson: str
    exercise: str
    mistake: str
    hint: str
    notebooks: list[str]


def misunderstood(marked: Sequence[Marked]) -> list[Misunderstood]:
    """All mistakes, exercise by exercise in the order of the lesson, the most frequent first.

    Wrong answers that fit no known mistake are together if one detector has found their hints, or if all got the same:
    a detector's hint may name variables of the learner's.
    """
    found = []
    for (lesson, exercise), answers in _answers(marked).items():
        made: dict[tuple[str, str], list[tuple[str, str]]] = defaultdict(list)
        for notebook, score in answers:
            if not score.is_right:
                made[_mistake(lesson, score)].append((notebook, score.hint))
        for (mistake, _), told in sorted(
            made.items(), key=lambda item: (-len(item[1]), item[0])
        ):
            # some hints name a number of the learner's, and differ: the one that most of them got
            hints = Counter(hint for _, hint in told if hint).most_common(1)
            notebooks = [notebook for notebook, _ in told]
            found.append(
                Misunderstood(
                    lesson, exercise, mistake, hints[0][0] if hints else "", notebooks
                )
            )
    return found


def _answers(
    marked: Sequence[Marked],
) -> dict[tuple[str, str], list[tuple[str, Score]]]:
    """By lesson and exercise, the notebooks that were graded and their scores; of exercises that count."""
    answers: dict[tuple[str, str], list[tuple[str, Score]]] = defaultdict(list)
    for one in marked:
        for score in one.scores:
            if score.max_score and not one.problem:
                answers[one.lesson, score.exercise].append((one.name, score))
    return answers


def _mistake(lesson: str, score: Score) -> tuple[str, str]:
    """What a mistake is called, and which detector or hint distinguishes it from others of this name."""
    if not score.is_answered:
        return "not answered", ""
    known = _known(lesson).get(score.exercise, set()) | {ONLY_THESE}
    if score.mistake and (known.issuperset(score.mistake.split("+")) or not score.hint):
        return score.mistake.replace("_", " ").replace("+", " and "), ""
    return "not recognised", score.mistake if score.mistake in DETECTORS else score.hint


@cache
def _known(lesson: str) -> dict[str, set[str]]:
    """The mistakes that each exercise knows, by their ids; any other id is that of a way to find hints."""
    return {
        name: {known.id for known in exercise.mistakes}
        for name, exercise in exercises_of(lesson).items()
    }


def as_table(marked: Sequence[Marked]) -> str:
    """CSV: a line for each mistake, with the notebooks that made it."""
    head = ["lesson", "exercise", "mistake", "how many", "hint", "notebooks"]
    return as_csv(
        [head]
        + [
            [*one[:3], len(one.notebooks), one.hint, " ".join(one.notebooks)]
            for one in misunderstood(marked)
        ]
    )
