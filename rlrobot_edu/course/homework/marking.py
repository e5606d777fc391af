"""One notebook is run, and each of its answers is judged by the checks of the grader's own process."""

from __future__ import annotations

import json
import shutil
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.values import Unkept, one_line
from rlrobot_edu.course.grading.verdict import Verdict
from rlrobot_edu.course.homework.away import away
from rlrobot_edu.course.homework.kernel import TIME_OUT, EndedError, Kernel
from rlrobot_edu.course.homework.secret import secret_twin
from rlrobot_edu.course.homework.submission import Submission, bound, changes_checks, exercises_of, read_submission
from rlrobot_edu.course.homework.wire import read

MOST_LEFT_OUT = 5  # cells that end the kernel; after so many the rest is not run
ASKING = 60.0  # for what a cell has handed in [s]
WAITS = "waiting"
ONLY_THESE_NUMBERS = (
    "Right with the notebook's numbers, but not with others: it must compute the answer from its arguments, and take "
    "no numbers from the notebook."
)


@dataclass(frozen=True)
class Limits:
    """What a submission may use: seconds in all, a third of them in one cell or one call; memory [MiB]."""

    seconds: float = 300.0
    memory: int = 4096


@dataclass(frozen=True)
class Score:
    """What an exercise has got.

    output: why, for the learner; is_answered: whether there was anything to judge
    mistake, hint: the id of the mistake that was recognised, and its hint; empty where there is none
    """

    exercise: str
    score: float
    output: str
    max_score: float = 1.0
    is_answered: bool = False
    mistake: str = ""
    hint: str = ""

    @property
    def reason(self) -> str:
        """Why points are missing, in a word or two; empty if none are."""
        if self.score == self.max_score:
            return ""
        return (self.mistake.replace("_", " ") or "not recognised") if self.is_answered else "not answered"


@dataclass
class Marked:
    """A submission with its scores; notes: what the instructor should know."""

    name: str
    lesson: str
    scores: list[Score]
    notes: list[str] = field(default_factory=list)

    @property
    def score(self) -> float:
        """Points in all."""
        return sum(score.score for score in self.scores)

    @property
    def max_score(self) -> float:
        """Points that there are."""
        return sum(score.max_score for score in self.scores)

    @property
    def is_full(self) -> bool:
        """Whether it has all points."""
        return self.score == self.max_score


def mark_file(path: Path, lesson: str, seed: int, limits: Limits) -> Marked:
    """Run and judge one notebook; what is wrong with it is told in its scores."""
    submission = read_submission(path, lesson)
    if submission.problem:
        names = list(submission.answered_in) or ["notebook"]
        scores = [Score(name, 0.0, submission.problem) for name in names]
        return Marked(submission.name, submission.lesson, scores, [submission.problem])
    return Marking(path, submission, seed, limits).marked()


class Marking:
    """The marking of one submission."""

    def __init__(self, path: Path, submission: Submission, seed: int, limits: Limits) -> None:
        self._path, self._submission, self._limits = path, submission, limits
        self._exercises = exercises_of(submission.lesson)
        self._twins = {
            name: secret_twin(exercise, seed) for name, exercise in self._exercises.items() if _is_function(exercise)
        }
        self._end = time.monotonic() + limits.seconds
        self._left_out: dict[int, str] = {}  # cells that end the kernel, and how
        self._errors: dict[int, str] = {}  # exceptions that cells end with
        self._judged: dict[str, dict[int, Verdict]] = {name: {} for name in self._exercises}

    def marked(self) -> Marked:
        """Run all cells and judge the answers. A cell that ends the kernel is left out, and all others run again."""
        while not self._run() and len(self._left_out) <= MOST_LEFT_OUT and self._time_left() > 0:
            pass
        scores = [self._score(name) for name in self._exercises]
        return Marked(self._submission.name, self._submission.lesson, scores, self._notes())

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
            lesson, memory = self._submission.lesson, self._limits.memory
            with Kernel(folder, home, lesson, list(self._exercises), memory) as kernel:
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
        """The verdict on one answer: on the notebook's tape, and if it is right there, on the secret one."""
        exercise = self._exercises[name]
        judge = exercise.judge if isinstance(exercise, Exercise) else exercise
        if told["kind"] == "value":
            return judge(read(told["value"]))
        if not _is_function(exercise):
            return judge(Unkept("a function"))
        unfinished = told["value"] == "unfinished"  # counts only if it is wrong, as in the learner's own check
        answer = away(kernel, name, self._submission.lesson, self._share, unfinished)
        try:
            verdict, twin = judge(answer), self._twins[name]
            if not verdict or twin is None:
                return verdict
            secret = twin.judge(answer)
        except EndedError as error:
            self._judged[name][place] = Verdict("wrong", f"Your function {error}.")
            raise
        if secret:
            return verdict
        known = secret.hint in [mistake.hint for mistake in exercise.mistakes]  # any other hint may tell numbers
        return Verdict("wrong", ONLY_THESE_NUMBERS, hint=secret.hint if known else "", id="these_numbers_alone")

    def _score(self, name: str) -> Score:
        """The last answer that is not blank counts."""
        answers = {place: verdict for place, verdict in self._judged[name].items() if verdict.status != WAITS}
        if not answers:
            return Score(name, 0.0, self._why_none(name))
        place = max(answers)
        verdict, output = answers[place], repr(answers[place])
        if len(answers) > 1:
            cells = ", ".join(str(1 + i) for i in sorted(answers))
            output += f"\nIt is answered in the code cells {cells}; the last one counts."
        if not verdict and place in self._errors:
            output += f"\n{self._errors[place]}"
        return Score(name, float(bool(verdict)), output, is_answered=True, mistake=verdict.id, hint=verdict.hint)

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
