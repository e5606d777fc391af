"""One notebook is run, and each of its answers is judged by the checks of the grader's own process."""

from __future__ import annotations

import json
import shutil
import tempfile
import time
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any

from rlrobot_grading.answers.source import COURSES_OWN
from rlrobot_grading.answers.values import Unkept
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.marking.cell import bound, changes_checks, hints_asked
from rlrobot_grading.marking.kernel import EndedError, GoneError, Kernel, ended
from rlrobot_grading.marking.marks import HINTS, NO_RULES, Limits, Marked, Rules, Score
from rlrobot_grading.marking.remote_function import away
from rlrobot_grading.marking.secret import secret_twin
from rlrobot_grading.marking.serialization import read
from rlrobot_grading.marking.submission import Submission, exercises_of, read_submission
from rlrobot_grading.marking.variants import variant_of

MOST_LEFT_OUT = 5  # cells that end the kernel; after so many the rest is not run
ASKING = 60.0  # for what a cell has handed in [s]
WAITS = "waiting"
NOT_GIVEN = "NotGivenError"  # what a cell ends with that wants something which is not there while it is graded
ONLY_THESE_NUMBERS = (
    "Right with the notebook's numbers, but not with others: it must compute the answer from its arguments, and take "
    "no numbers from the notebook."
)


def mark_file(
    path: Path, lesson: str, seed: int, limits: Limits, rules: Rules = NO_RULES
) -> Marked:
    """Run and judge one notebook; its scores say what is wrong with it."""
    submission = read_submission(path, lesson)
    if submission.problem:
        names = list(submission.answered_in) or ["notebook"]
        problem = submission.problem
        scores = [Score(name, 0.0, problem, rules.points_of(name)) for name in names]
        return Marked(
            submission.name, submission.lesson, scores, [problem], problem=problem
        )
    return Marking(path, submission, seed, limits, rules).marked()


@lru_cache(
    maxsize=4
)  # it takes seconds to draw tapes that show all mistakes, and a class hands in one lesson
def with_twins(
    lesson: str, student: str, seed: int
) -> tuple[dict[str, Exercise | Question], dict[str, Exercise | None]]:
    """The exercises of a lesson, or of a student's variant of it, and their secret twins; both by name."""
    exercises = (
        variant_of(lesson, student).exercises if student else exercises_of(lesson)
    )
    return exercises, {
        name: secret_twin(exercise, seed) for name, exercise in exercises.items()
    }


class Marking:
    """The marking of one submission."""

    def __init__(
        self,
        path: Path,
        submission: Submission,
        seed: int,
        limits: Limits,
        rules: Rules = NO_RULES,
    ) -> None:
        self._path, self._submission, self._limits, self._rules = (
            path,
            submission,
            limits,
            rules,
        )
        self._exercises, self._twins = with_twins(
            submission.lesson, submission.made_for, seed
        )
        self._end = time.monotonic() + limits.seconds
        self._left_out: dict[int, str] = {}  # cells that end the kernel, and how
        self._errors: dict[int, str] = {}  # exceptions that cells end with
        self._unsettled = set(
            range(len(submission.cells))
        )  # cells of which a late end of the kernel may come
        self._is_careful = False  # whether each cell is waited for, since one of them has ended the kernel
        self._missing: set[str] = (
            set()
        )  # names without a value, since the grader gives none
        self._judged: dict[str, dict[int, Verdict]] = {
            name: {} for name in self._exercises
        }
        self._checked: set[tuple[str, int]] = (
            set()
        )  # answers that were handed to their checks
        self._shares: dict[
            tuple[str, int], float
        ] = {}  # of the cases of a wrong answer, those that are right
        self._lent: dict[
            tuple[str, int], list[str]
        ] = {}  # functions in whose place the right ones were called

    def marked(self) -> Marked:
        """Run all cells and judge the answers. A cell that ends the kernel is left out, and all others run again."""
        while (
            not self._run()
            and len(self._left_out) <= MOST_LEFT_OUT
            and self._time_left() > 0
        ):
            pass
        scores = [self._score(name) for name in self._exercises]
        made_for = self._submission.made_for
        return Marked(
            self._submission.name,
            self._submission.lesson,
            scores,
            self._notes(),
            made_for=made_for,
        )

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
        lesson, memory = self._submission.lesson, self._limits.memory
        with (
            self._limits.guard.of_one_job() as guard,
            tempfile.TemporaryDirectory(
                prefix="rlrobot-grade-", ignore_cleanup_errors=True
            ) as temporary,
        ):
            folder, home = Path(temporary, "work"), Path(temporary, "home")
            folder.mkdir()
            home.mkdir()
            shutil.copy(self._path, folder)
            with Kernel(
                folder, home, lesson, list(self._exercises), memory, guard
            ) as kernel:
                for place, source in enumerate(
                    self._submission.cells[: self._submission.last_cell]
                ):
                    if (
                        place not in self._left_out
                        and self._time_left() > 0
                        and not self._cell(kernel, place, source)
                    ):
                        return False
        return True

    def _cell(self, kernel: Kernel, place: int, source: str) -> bool:
        """Run one cell, and judge what it answers; false if the kernel has to be begun anew."""
        try:
            self._errors.pop(place, None)  # from an earlier run
            kind, text = kernel.run(source, self._share())
            if self._is_careful and place in self._unsettled:
                kernel.settle()
                self._unsettled.discard(place)
            if self._is_the_graders(kind, text):
                self._missing |= bound(source, by_take=True)
            elif kind:
                self._errors[place] = (
                    f"Code cell {1 + place} {ended(kind, text, self._limits.memory)}"
                )
            told = json.loads(
                kernel.ask(
                    f"taken_in({self._submission.answered_by(place, self._left_out)!r})",
                    ASKING,
                )
            )
            if not told["is_full"]:
                self._take_in(kernel, place, told["answers"])
            if told["is_full"] or (
                told["answers"] and kernel.ask("is_full()", ASKING) == "True"
            ):
                self._left_out[place] = (
                    f"fills the {self._limits.memory} MiB of memory that a submission may use"
                )
        except GoneError as error:
            if self._is_careful:
                self._left_out[place] = str(error)
            self._is_careful = True
            return False
        except (EndedError, TimeoutError) as error:
            self._left_out[place] = str(error)
        except (
            ValueError,
            KeyError,
            TypeError,
            AttributeError,
        ):  # the kernel's side has been changed by the learner
            self._left_out[place] = (
                "leaves the kernel in a state in which it can tell nothing"
            )
        return place not in self._left_out

    def _is_the_graders(self, kind: str, text: str) -> bool:
        """Whether a cell ends because something is missing that only the learner's own notebook has."""
        return kind == NOT_GIVEN or (
            kind == "NameError" and any(f"'{name}'" in text for name in self._missing)
        )

    def _take_in(self, kernel: Kernel, place: int, told: dict[str, Any]) -> None:
        """Judge what a cell answers: what it hands to a check, and what it only defines."""
        for name, answer in told.items():
            if name in self._exercises:
                self._judged[name][place] = self._judge(kernel, place, name, answer)
                if answer["checked"]:
                    self._checked.add((name, place))

    def _judge(
        self, kernel: Kernel, place: int, name: str, told: dict[str, str]
    ) -> Verdict:
        """The verdict on one answer; where it calls functions that are wrong, with the right ones in their place."""
        exercise = self._exercises[name]
        judge = exercise.judge if isinstance(exercise, Exercise) else exercise
        if told["kind"] == "solution":
            return Verdict("wrong", COURSES_OWN, id="courses_own")
        if told["kind"] == "value":
            return judge(read(told["value"]))
        if not isinstance(exercise, Exercise):
            return judge(Unkept("a function"))
        unfinished = (
            told["value"] == "unfinished"
        )  # counts only if it is wrong, as in the learner's own check
        answer = away(kernel, name, self._submission.lesson, self._share, unfinished)
        try:
            verdict = self._on_both_tapes(name, answer)
            if verdict or verdict.status == WAITS:
                return verdict
            if wrong := self._wrong_ones_in(name):
                right = {other: self._exercises[other].right for other in wrong}
                answer = away(
                    kernel, name, self._submission.lesson, self._share, lent=right
                )
                verdict = self._on_both_tapes(
                    name, answer
                )  # what it does by itself, right or wrong
                self._lent[name, place] = wrong
                if verdict:
                    return verdict
            if self._rules.partial:
                tapes = [
                    tape for tape in (exercise, self._twins[name]) if tape is not None
                ]
                self._shares[name, place] = min(tape.share(answer) for tape in tapes)
        except EndedError as error:
            if self._is_careful or not isinstance(error, GoneError):
                self._judged[name][place] = Verdict("wrong", f"Your function {error}.")
            raise
        return verdict

    def _on_both_tapes(self, name: str, answer: Callable[..., Any]) -> Verdict:
        """The verdict on the notebook's tape, and if it is right there, on the secret one."""
        exercise, twin = self._exercises[name], self._twins[name]
        verdict = exercise.judge(answer)
        secret = twin.judge(answer) if verdict and twin is not None else verdict
        if secret or not verdict:
            return verdict
        known = secret.hint in [
            mistake.hint for mistake in exercise.mistakes
        ]  # any other hint may tell numbers
        return Verdict(
            "wrong",
            ONLY_THESE_NUMBERS,
            hint=secret.hint if known else "",
            id="these_numbers_alone",
        )

    def _wrong_ones_in(self, name: str) -> list[str]:
        """The functions of other exercises that an answer calls, or that those call, and that are not right so far."""
        others = [
            other
            for other in self._exercises
            if other in self._submission.called_by(name) - {name}
        ]
        return [
            other
            for other in others
            if isinstance(self._exercises[other], Exercise)
            and not any(self._last(other))
        ]

    def _last(self, name: str) -> list[Verdict]:
        """The verdict on the last answer; empty if there is none."""
        return [verdict for _, verdict in sorted(self._answers(name).items())][-1:]

    def _answers(self, name: str) -> dict[int, Verdict]:
        """The verdicts on the answers that are not blank: on those handed in, and if there are none, those defined."""
        answers = {
            place: verdict
            for place, verdict in self._judged[name].items()
            if verdict.status != WAITS
        }
        return {
            place: answers[place] for place in answers if (name, place) in self._checked
        } or answers

    def _score(self, name: str) -> Score:
        """The last answer that is not blank counts."""
        answers = self._answers(name)
        points = self._rules.points_of(name)
        if not answers:
            return Score(name, 0.0, self._why_none(name), points)
        place = max(answers)
        verdict, output = answers[place], repr(answers[place])
        if len(answers) > 1:
            cells = ", ".join(str(1 + i) for i in sorted(answers))
            output += (
                f"\nIt is answered in the code cells {cells}; the last one counts."
            )
        if not verdict and place in self._errors:
            output += f"\n{self._errors[place]}"
        if lent := " and ".join(self._lent.get((name, place), [])):
            output += (
                f"\nJudged with the right {lent}, since that of the notebook is not."
            )
        share, asked = float(bool(verdict)) or self._shares.get((name, place), 0.0), 0
        if 0 < share < 1:
            got = f"{share * points:.2g} of {points:g} points for that."
            output += f"\nRight in {100 * share:.0f} % of the cases: {got}"
        if self._rules.hint_off and (
            asked := hints_asked(self._submission.cells, name)
        ):
            output += f"\nHints asked for: {asked}; each costs {100 * self._rules.hint_off:g} % of its points."
        score = round(points * share * (1 - min(1.0, asked * self._rules.hint_off)), 2)
        mistake = HINTS if verdict and asked else verdict.id
        return Score(
            name,
            score,
            output,
            points,
            is_answered=True,
            mistake=mistake,
            hint=verdict.hint,
            lent=lent,
        )

    def _why_none(self, name: str) -> str:
        for place in sorted(
            {
                *self._submission.answered_in[name],
                *self._submission.defined_in.get(name, ()),
            }
        ):
            if place in self._left_out:
                return f"✗ Not answered: code cell {1 + place} {self._left_out[place]}."
            if place in self._errors and place not in self._judged[name]:
                return f"✗ Not answered. {self._errors[place]}"
        if waiting := list(self._judged[name].values()):
            return repr(waiting[-1])
        if not self._submission.answered_in[name]:
            return f"✗ Not answered: no cell defines {name}, or hands it to its check."
        if self._time_left() <= 0:
            return f"✗ Not answered: the notebook had used up its {self._limits.seconds:.0f} seconds before."
        if len(self._left_out) > MOST_LEFT_OUT:
            return f"✗ Not answered: before it, more than {MOST_LEFT_OUT} cells have ended the kernel."
        return f"✗ Not answered: no cell that runs hands {name} to its check."

    def _notes(self) -> list[str]:
        notes = [
            f"Code cell {1 + place} {how}; it is left out."
            for place, how in sorted(self._left_out.items())
        ]
        for place, source in enumerate(self._submission.cells):
            if changes_checks(source):
                notes.append(
                    f"Code cell {1 + place} changes the checks; the grader has its own."
                )
        return notes + [
            self._errors[place]
            for place in sorted(self._errors.keys() - self._left_out.keys())[:3]
        ]
