"""One notebook is run, and each of its answers is judged by the checks of the grader's own process."""

from __future__ import annotations

import json
import shutil
import tempfile
import time
from functools import lru_cache
from pathlib import Path
from typing import Any

from rlrobot_grading.answers.source import COURSES_OWN
from rlrobot_grading.answers.values import Function, Unkept
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.marking.cell import bound
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.kernel import EndedError, GoneError, Kernel, ended
from rlrobot_grading.marking.marks import NO_RULES, Limits, Marked, Rules, Score
from rlrobot_grading.marking.remote_function import remote_function
from rlrobot_grading.marking.scoring import WAITS, Outcomes, Scoring
from rlrobot_grading.marking.secret import secret_twin
from rlrobot_grading.marking.serialization import read
from rlrobot_grading.marking.submission import Submission, read_submission
from rlrobot_grading.marking.variants import variant_of

MOST_LEFT_OUT = 5  # cells that end the kernel; after so many the rest is not run
ASKING = 60.0  # for what a cell has handed in [s]
NOT_GIVEN = "NotGivenError"  # what a cell ends with that wants something which is not there while it is graded
ONLY_THESE_NUMBERS = (
    "Right with the notebook's numbers, but not with others: it must compute the answer from its arguments, and take "
    "no numbers from the notebook."
)


def mark_file(
    course: Course,
    path: Path,
    lesson: str,
    seed: int,
    limits: Limits,
    rules: Rules = NO_RULES,
) -> Marked:
    """Run and judge one notebook; its scores say what is wrong with it."""
    submission = read_submission(course, path, lesson)
    if submission.problem:
        return not_marked(submission, rules)
    return Marking(course, path, submission, seed, limits, rules).marked()


def not_marked(submission: Submission, rules: Rules) -> Marked:
    """What becomes of a submission that has a problem."""
    names = list(submission.answered_in) or ["notebook"]
    problem = submission.problem
    scores = [Score(name, 0.0, problem, rules.points_of(name)) for name in names]
    return Marked(
        submission.name, submission.lesson, scores, [problem], problem=problem
    )


@lru_cache(maxsize=4)
def with_twins(
    course: Course, lesson: str, student: str, seed: int
) -> tuple[dict[str, Exercise | Question], dict[str, Exercise | None]]:
    """The exercises of a lesson, or of a student's variant of it, and their secret twins; both by name.

    They are kept: it takes seconds to draw tapes that show all mistakes, and a class hands in one lesson.
    """
    exercises = course.exercises_of(lesson)
    if student:
        exercises = variant_of(course, lesson, student).exercises
    twins = {name: secret_twin(one, seed) for name, one in exercises.items()}
    return exercises, twins


class Marking:
    """The marking of one submission."""

    def __init__(
        self,
        course: Course,
        path: Path,
        submission: Submission,
        seed: int,
        limits: Limits,
        rules: Rules = NO_RULES,
    ) -> None:
        self._course = course
        self._path = path
        self._submission = submission
        self._limits = limits
        self._rules = rules
        self._exercises, self._twins = with_twins(
            course, submission.lesson, submission.made_for, seed
        )
        self._end = time.monotonic() + limits.seconds
        # cells of which a late end of the kernel may come, and whether each cell is waited for since one has come
        self._unsettled = set(range(len(submission.cells)))
        self._is_careful = False
        # names without a value, since the grader gives none
        self._missing: set[str] = set()
        self._outcomes = Outcomes({name: {} for name in self._exercises})

    def marked(self) -> Marked:
        """Run all cells and judge the answers. A cell that ends the kernel is left out, and all others run again."""
        while not self._run():
            if len(self._outcomes.left_out) > MOST_LEFT_OUT or self._time_left() <= 0:
                break
        scoring = Scoring(
            self._submission, self._rules, self._outcomes, self._too_late()
        )
        scores = [scoring.score(name) for name in self._exercises]
        return Marked(
            self._submission.name,
            self._submission.lesson,
            scores,
            scoring.notes(),
            made_for=self._submission.made_for,
        )

    def _too_late(self) -> str:
        """Why an answer that nobody asked for has not been reached; empty if all cells have run."""
        if self._time_left() <= 0:
            return f"the notebook had used up its {self._limits.seconds:.0f} seconds before"
        if len(self._outcomes.left_out) > MOST_LEFT_OUT:
            return f"before it, more than {MOST_LEFT_OUT} cells have ended the kernel"
        return ""

    def _time_left(self) -> float:
        return self._end - time.monotonic()

    def _share(self) -> float:
        """Seconds that a cell, or one call of an answer, may take now. Raises EndedError when all are used up."""
        if self._time_left() <= 0:
            raise EndedError(
                f"was still at work when the {self._limits.seconds:.0f} seconds were over"
            )
        return max(1.0, min(self._limits.seconds / 3, self._time_left()))

    def _run(self) -> bool:
        """Run what has not been left out; false if a cell ends the kernel."""
        with (
            self._limits.guard.of_one_job() as guard,
            tempfile.TemporaryDirectory(
                prefix="rlrobot-grade-", ignore_cleanup_errors=True
            ) as temporary,
        ):
            folder = Path(temporary, "work")
            home = Path(temporary, "home")
            folder.mkdir()
            home.mkdir()
            shutil.copy(self._path, folder)
            kernel = Kernel(
                folder,
                home,
                self._course,
                self._submission.lesson,
                list(self._exercises),
                self._limits.memory,
                guard,
            )
            with kernel:
                for place in range(self._submission.last_cell):
                    if place in self._outcomes.left_out or self._time_left() <= 0:
                        continue
                    if not self._cell(kernel, place):
                        return False
        return True

    def _cell(self, kernel: Kernel, place: int) -> bool:
        """Run one cell, and judge what it answers; false if the kernel has to be begun anew."""
        source = self._submission.cells[place]
        try:
            self._outcomes.errors.pop(place, None)  # from an earlier run
            kind, text = kernel.run(source, self._share())
            if self._is_careful and place in self._unsettled:
                kernel.settle()
                self._unsettled.discard(place)
            if self._is_the_graders(kind, text):
                self._missing |= bound(source, by_take=True)
            elif kind:
                self._outcomes.errors[place] = (
                    f"Code cell {1 + place} {ended(kind, text, self._limits.memory)}"
                )
            names = self._submission.answered_by(place, self._outcomes.left_out)
            taken = json.loads(kernel.ask(f"taken_in({names!r})", ASKING))
            is_full = taken["is_full"]
            if taken["answers"] and not is_full:
                self._take_in(kernel, place, taken["answers"])
                is_full = kernel.ask("is_full()", ASKING) == "True"
            if is_full:
                self._outcomes.left_out[place] = (
                    f"fills the {self._limits.memory} MiB of memory that a submission may use"
                )
        except GoneError as error:
            if self._is_careful:
                self._outcomes.left_out[place] = str(error)
            self._is_careful = True
            return False
        except (EndedError, TimeoutError) as error:
            self._outcomes.left_out[place] = str(error)
        except (
            ValueError,
            KeyError,
            TypeError,
            AttributeError,
        ):  # the kernel's side has been changed by the learner
            self._outcomes.left_out[place] = (
                "leaves the kernel in a state in which it cannot be asked"
            )
        return place not in self._outcomes.left_out

    def _is_the_graders(self, kind: str, text: str) -> bool:
        """Whether a cell ends because something is missing that only the learner's own notebook has."""
        return kind == NOT_GIVEN or (
            kind == "NameError" and any(f"'{name}'" in text for name in self._missing)
        )

    def _take_in(self, kernel: Kernel, place: int, answers: dict[str, Any]) -> None:
        """Judge what a cell answers: what it hands to a check, and what it only defines."""
        for name, answer in answers.items():
            if name in self._exercises:
                self._outcomes.judged[name][place] = self._judge(
                    kernel, place, name, answer
                )
                if answer["checked"]:
                    self._outcomes.checked.add((name, place))

    def _judge(
        self, kernel: Kernel, place: int, name: str, described: dict[str, str]
    ) -> Verdict:
        """The verdict on one answer; where it calls functions that are wrong, with the right ones in their place."""
        exercise = self._exercises[name]
        if described["kind"] == "solution":
            return Verdict("wrong", COURSES_OWN, id="courses_own")
        answer: Any = Unkept("a function")
        if described["kind"] == "value":
            answer = read(described["value"])
        if not isinstance(exercise, Exercise):
            return exercise(answer)
        if described["kind"] == "value":
            return exercise.judge(answer)
        # dots count only if it is wrong, as in the learner's own check
        is_unfinished = described["value"] == "unfinished"
        try:
            return self._judge_function(kernel, place, name, is_unfinished)
        except EndedError as error:
            if self._is_careful or not isinstance(error, GoneError):
                self._outcomes.judged[name][place] = Verdict(
                    "wrong", f"Your function {error}."
                )
            raise

    def _judge_function(
        self, kernel: Kernel, place: int, name: str, is_unfinished: bool
    ) -> Verdict:
        course = self._course
        lesson = self._submission.lesson
        answer = remote_function(
            course, kernel, lesson, name, self._share, is_unfinished
        )
        verdict = self._on_both_tapes(name, answer)
        if verdict or verdict.status == WAITS:
            return verdict
        wrong = self._wrong_ones_in(name)
        if wrong:
            right = {other: self._exercises[other].right for other in wrong}
            answer = remote_function(
                course, kernel, lesson, name, self._share, substitutes=right
            )
            # what it does by itself, right or wrong
            verdict = self._on_both_tapes(name, answer)
            self._outcomes.substituted[name, place] = wrong
            if verdict:
                return verdict
        if self._rules.partial:
            tapes = [self._exercises[name], self._twins[name]]
            shares = [tape.share(answer) for tape in tapes if tape is not None]
            self._outcomes.shares[name, place] = min(shares)
        return verdict

    def _on_both_tapes(self, name: str, answer: Function) -> Verdict:
        """The verdict on the notebook's tape, and if it is right there, on the secret one."""
        exercise = self._exercises[name]
        twin = self._twins[name]
        verdict = exercise.judge(answer)
        if not verdict or twin is None:
            return verdict
        secret = twin.judge(answer)
        if secret:
            return verdict
        # any other hint may contain numbers
        known = [mistake.hint for mistake in exercise.mistakes]
        hint = secret.hint if secret.hint in known else ""
        return Verdict("wrong", ONLY_THESE_NUMBERS, hint=hint, id="these_numbers_alone")

    def _wrong_ones_in(self, name: str) -> list[str]:
        """The functions of other exercises that an answer calls, or that those call, and that are not right so far."""
        called = self._submission.called_by(name) - {name}
        wrong = []
        for other, exercise in self._exercises.items():
            is_called = other in called and isinstance(exercise, Exercise)
            if is_called and not self._outcomes.is_right(other):
                wrong.append(other)
        return wrong
