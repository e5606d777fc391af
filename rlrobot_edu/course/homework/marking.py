"""One notebook is run, and each of its answers is judged by the checks of the grader's own process."""

from __future__ import annotations

import json
import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.values import Unkept, one_line
from rlrobot_edu.course.grading.verdict import Verdict
from rlrobot_edu.course.homework.away import away
from rlrobot_edu.course.homework.kernel import TIME_OUT, EndedError, Kernel
from rlrobot_edu.course.homework.marks import HINTS, Limits, Marked, Score
from rlrobot_edu.course.homework.own import variant_of
from rlrobot_edu.course.homework.rules import NO_RULES, Rules
from rlrobot_edu.course.homework.secret import secret_twin
from rlrobot_edu.course.homework.submission import (
    Submission,
    bound,
    changes_checks,
    exercises_of,
    hints_asked,
    names_in,
    read_submission,
)
from rlrobot_edu.course.homework.wire import read

MOST_LEFT_OUT = 5  # cells that end the kernel; after so many the rest is not run
ASKING = 60.0  # for what a cell has handed in [s]
WAITS = "waiting"
ONLY_THESE_NUMBERS = (
    "Right with the notebook's numbers, but not with others: it must compute the answer from its arguments, and take "
    "no numbers from the notebook."
)


def mark_file(path: Path, lesson: str, seed: int, limits: Limits, rules: Rules = NO_RULES) -> Marked:
    """Run and judge one notebook; what is wrong with it is told in its scores."""
    submission = read_submission(path, lesson)
    if submission.problem:
        names = list(submission.answered_in) or ["notebook"]
        scores = [Score(name, 0.0, submission.problem, rules.points_of(name)) for name in names]
        return Marked(submission.name, submission.lesson, scores, [submission.problem])
    return Marking(path, submission, seed, limits, rules).marked()


class Marking:
    """The marking of one submission."""

    def __init__(self, path: Path, submission: Submission, seed: int, limits: Limits, rules: Rules = NO_RULES) -> None:
        self._path, self._submission, self._limits, self._rules = path, submission, limits, rules
        lesson, student = submission.lesson, submission.made_for
        self._exercises = variant_of(lesson, student).exercises if student else exercises_of(lesson)
        self._twins = {
            name: secret_twin(exercise, seed) for name, exercise in self._exercises.items() if _is_function(exercise)
        }
        self._end = time.monotonic() + limits.seconds
        self._left_out: dict[int, str] = {}  # cells that end the kernel, and how
        self._errors: dict[int, str] = {}  # exceptions that cells end with
        self._judged: dict[str, dict[int, Verdict]] = {name: {} for name in self._exercises}
        self._shares: dict[tuple[str, int], float] = {}  # of the cases of a wrong answer, those that are right
        self._lent: dict[tuple[str, int], list[str]] = {}  # functions in whose place the right ones were called

    def marked(self) -> Marked:
        """Run all cells and judge the answers. A cell that ends the kernel is left out, and all others run again."""
        while not self._run() and len(self._left_out) <= MOST_LEFT_OUT and self._time_left() > 0:
            pass
        scores = [self._score(name) for name in self._exercises]
        made_for = self._submission.made_for
        return Marked(self._submission.name, self._submission.lesson, scores, self._notes(), made_for=made_for)

    def _time_left(self) -> float:
        return self._end - time.monotonic()

    def _share(self) -> float:
        """Seconds that a cell, or one call of an answer, may take now. Raises EndedError when all are used up."""
        if self._time_left() <= 0:
            raise EndedError(f"was still at work when the {self._limits.seconds:.0f} seconds were over")
        return max(1.0, min(self._limits.seconds / 3, self._time_left()))

    def _run(self) -> bool:
        """Run what has not been left out; false if a cell ends the kernel."""
        with tempfile.TemporaryDirectory(prefix="rlrobot-grade-", ignore_cleanup_errors=True) as temporary:
            folder, home = Path(temporary, "work"), Path(temporary, "home")
            folder.mkdir()
            home.mkdir()
            shutil.copy(self._path, folder)
            lesson, memory, guard = self._submission.lesson, self._limits.memory, self._limits.guard
            with Kernel(folder, home, lesson, list(self._exercises), memory, guard) as kernel:
                for place, source in enumerate(self._submission.cells[: self._submission.last_cell]):
                    if place not in self._left_out and self._time_left() > 0 and not self._cell(kernel, place, source):
                        return False
        return True

    def _cell(self, kernel: Kernel, place: int, source: str) -> bool:
        """Run one cell, and judge what it answers; false if that ends the kernel."""
        try:
            kind, text = kernel.run(source, self._share())
            if kind and "while it is graded none is given" not in text:
                self._errors[place] = f"Code cell {1 + place} {_error(kind, text, self._limits.memory)}"
            here = bound(source)
            names = [name for name, places in self._submission.answered_in.items() if place in places and name in here]
            told = json.loads(kernel.ask(f"taken_in({names!r})", ASKING))
            for name, answer in told.items():
                if name in self._exercises:
                    self._judged[name][place] = self._judge(kernel, place, name, answer)
        except (EndedError, TimeoutError) as error:
            self._left_out[place] = str(error)
            return False
        except (ValueError, KeyError, TypeError, AttributeError):  # the kernel's side has been changed by the learner
            self._left_out[place] = "leaves the kernel in a state in which it can tell nothing"
            return False
        return True

    def _judge(self, kernel: Kernel, place: int, name: str, told: dict[str, str]) -> Verdict:
        """The verdict on one answer; where it calls functions that are wrong, with the right ones in their place."""
        exercise = self._exercises[name]
        judge = exercise.judge if isinstance(exercise, Exercise) else exercise
        if told["kind"] == "value":
            return judge(read(told["value"]))
        if not _is_function(exercise):
            return judge(Unkept("a function"))
        unfinished = told["value"] == "unfinished"  # counts only if it is wrong, as in the learner's own check
        answer = away(kernel, name, self._submission.lesson, self._share, unfinished)
        try:
            verdict = self._on_both_tapes(name, answer)
            if verdict or verdict.status == WAITS:
                return verdict
            if wrong := self._wrong_ones_in(place, name):
                right = {other: self._exercises[other].right for other in wrong}
                answer = away(kernel, name, self._submission.lesson, self._share, lent=right)
                verdict = self._on_both_tapes(name, answer)  # what it does by itself, right or wrong
                self._lent[name, place] = wrong
                if verdict:
                    return verdict
            if self._rules.partial:
                self._shares[name, place] = min(
                    tape.share(answer) for tape in (exercise, self._twins[name]) if tape is not None
                )
        except EndedError as error:
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
        known = secret.hint in [mistake.hint for mistake in exercise.mistakes]  # any other hint may tell numbers
        return Verdict("wrong", ONLY_THESE_NUMBERS, hint=secret.hint if known else "", id="these_numbers_alone")

    def _wrong_ones_in(self, place: int, name: str) -> list[str]:
        """The functions of other exercises that a cell calls, or that those call, and that are not right so far."""
        called, ahead = {name}, [place]
        while ahead:
            named = names_in(self._submission.cells[ahead.pop()]) & self._exercises.keys() - called
            called |= named
            ahead += [place for other in named for place in self._submission.answered_in[other]]
        others = [
            other for other in self._exercises if other in called - {name} and _is_function(self._exercises[other])
        ]
        return [other for other in others if not any(self._last(other))]

    def _last(self, name: str) -> list[Verdict]:
        """The verdict on the last answer that is not blank; empty if there is none."""
        return [verdict for _, verdict in sorted(self._judged[name].items()) if verdict.status != WAITS][-1:]

    def _score(self, name: str) -> Score:
        """The last answer that is not blank counts."""
        answers = {place: verdict for place, verdict in self._judged[name].items() if verdict.status != WAITS}
        points = self._rules.points_of(name)
        if not answers:
            return Score(name, 0.0, self._why_none(name), points)
        place = max(answers)
        verdict, output = answers[place], repr(answers[place])
        if len(answers) > 1:
            cells = ", ".join(str(1 + i) for i in sorted(answers))
            output += f"\nIt is answered in the code cells {cells}; the last one counts."
        if not verdict and place in self._errors:
            output += f"\n{self._errors[place]}"
        if lent := " and ".join(self._lent.get((name, place), [])):
            output += f"\nJudged with the right {lent}, since that of the notebook is not."
        share, asked = float(bool(verdict)) or self._shares.get((name, place), 0.0), 0
        if 0 < share < 1:
            output += (
                f"\nRight in {100 * share:.0f} % of the cases: {share * points:.2g} of {points:g} points for that."
            )
        if self._rules.hint_off and (asked := hints_asked(self._submission.cells, name)):
            output += f"\nHints asked for: {asked}; each costs {100 * self._rules.hint_off:g} % of its points."
        score = round(points * share * (1 - min(1.0, asked * self._rules.hint_off)), 2)
        mistake = HINTS if verdict and asked else verdict.id
        return Score(name, score, output, points, is_answered=True, mistake=mistake, hint=verdict.hint, lent=lent)

    def _why_none(self, name: str) -> str:
        for place in self._submission.answered_in[name]:
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
        notes = [f"Code cell {1 + place} {how}." for place, how in sorted(self._left_out.items())]
        for place, source in enumerate(self._submission.cells):
            if changes_checks(source):
                notes.append(f"Code cell {1 + place} changes the checks; the grader has its own.")
        return notes + [self._errors[place] for place in sorted(self._errors)[:3]]


def _error(kind: str, text: str, memory: int) -> str:
    """How a cell ends that does not end well."""
    if "MemoryError" in kind:
        return f"wants more memory than the {memory} MiB that a submission may use."
    if kind == TIME_OUT:
        return f"is endless: {text}."
    return f"stops with {one_line(f'{kind}: {text}')}"


def _is_function(exercise: Exercise | Question) -> bool:
    return isinstance(exercise, Exercise)
