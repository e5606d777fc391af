"""How many of the recorded wrong answers get a hint, and from which detector: with the hand-written mistakes, without.

    .venv-tools/bin/python studies/detectors.py [lesson_03 …]

The answers are those on the pages of the exercises: what a mistake's edit makes, and its witnesses. A detector is
*alone* where it is asked about each answer, whatever the others say; *first* where it is the first that has a hint.
"""

from __future__ import annotations

import importlib
import sys
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import rlrobot_course
from rlrobot_grading.answers import limits
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.hints.detectors import DETECTORS

LESSONS = sorted(
    path.parent.name
    for path in Path(rlrobot_course.__file__).parent.glob("*/exercises.py")
)
WRITTEN = {
    "known_mistake",
    "two_mistakes",
}  # the detectors that need hints written by hand


def exercises(lessons: list[str]) -> Iterator[tuple[str, Any]]:
    """The exercises of these lessons, each with lesson and name."""
    for lesson in lessons:
        check = importlib.import_module(f"rlrobot_course.{lesson}.exercises").check
        yield from (
            (f"{lesson} {name}", exercise) for name, exercise in vars(check).items()
        )


def wrong_answers(exercise: Any) -> list[Any]:
    """All that is recorded as wrong."""
    witnesses = [
        answer for answers in exercise.witnesses.values() for answer in answers
    ]
    if isinstance(exercise, Question):
        return [mistake.wrong for mistake in exercise.mistakes] + witnesses
    return [*exercise.wrong_functions, *witnesses]


def kind_of(id: str, exercise: Any) -> str:
    """The detector whose hint has this id."""
    known = {mistake.id for mistake in exercise.mistakes}
    if "+" in id:
        return "two_mistakes"
    if id in known:
        return "known_mistake"
    return id or "no hint"


def alone(exercise: Any, answer: Any) -> list[str]:
    """The detectors that have a hint for a function."""
    got = exercise.outcomes(answer)
    if next(
        mine.failure
        for right, mine in zip(exercise.expected, got, strict=False)
        if not right.equals(mine)
    ):
        return []
    seen = exercise.evidence(answer, got)
    return [
        name
        for name, detector in DETECTORS.items()
        if name not in WRITTEN and detector(seen)
    ]


def main(lessons: list[str]) -> None:
    """Print a table for functions and one for values."""
    limits.SECONDS = 0.3
    counts: dict[str, Counter[tuple[str, str]]] = {
        "functions": Counter(),
        "values": Counter(),
    }
    slowest, slow = 0.0, ""
    for name, exercise in exercises(lessons):
        bare = replace(exercise, mistakes=())
        count = counts["values" if isinstance(exercise, Question) else "functions"]
        for answer in wrong_answers(exercise):
            begun = time.perf_counter()
            count[kind_of(exercise(answer).id, exercise), "first"] += 1
            if (took := time.perf_counter() - begun) > slowest:
                slowest, slow = took, name
            count[kind_of(bare(answer).id, bare), "without"] += 1
            count["all", "without"] += 1
            count["all", "first"] += 1
            if not isinstance(exercise, Question):
                count.update(
                    (detector, "alone") for detector in alone(exercise, answer)
                )
    for title, count in counts.items():
        print(f"{title:24}   alone   first   without hand-written mistakes")
        for kind in sorted(
            {kind for kind, _ in count}, key=lambda kind: -count[kind, "first"]
        ):
            print(
                f"{kind:24} {count[kind, 'alone']:7} {count[kind, 'first']:7} {count[kind, 'without']:7}"
            )
    print(f"The slowest verdict took {slowest:.1f} s, on {slow}.")


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    with np.errstate(all="ignore"):
        main(sys.argv[1:] or LESSONS)
