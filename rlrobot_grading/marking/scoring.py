"""The points of a marked notebook, and what is said of each answer."""

from __future__ import annotations

from dataclasses import dataclass, field

from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.marking.cell import changes_checks, hints_asked
from rlrobot_grading.marking.marks import HINTS, Rules, Score
from rlrobot_grading.marking.submission import Submission

WAITS = "waiting"


@dataclass
class Outcomes:
    """What came of running a notebook. Cells are numbered from 0.

    judged: by exercise and cell, the verdict on an answer
    checked: answers that were handed to their checks, as (exercise, cell)
    shares: of a wrong answer the share of the cases that are right
    substituted: functions in whose place the right ones were called
    left_out: cells that end the kernel, and how
    errors: the exceptions that cells end with
    """

    judged: dict[str, dict[int, Verdict]]
    checked: set[tuple[str, int]] = field(default_factory=set)
    shares: dict[tuple[str, int], float] = field(default_factory=dict)
    substituted: dict[tuple[str, int], list[str]] = field(default_factory=dict)
    left_out: dict[int, str] = field(default_factory=dict)
    errors: dict[int, str] = field(default_factory=dict)

    def answers(self, name: str) -> dict[int, Verdict]:
        """The verdicts on the answers that are not blank: on those handed in, and if there are none, those defined."""
        answers = {}
        checked = {}
        for place, verdict in self.judged[name].items():
            if verdict.status == WAITS:
                continue
            answers[place] = verdict
            if (name, place) in self.checked:
                checked[place] = verdict
        return checked or answers

    def is_right(self, name: str) -> bool:
        """Whether the last answer is right."""
        answers = self.answers(name)
        return bool(answers) and bool(answers[max(answers)])


class Scoring:
    """The scores of one submission.

    too_late: why an answer may not have been reached; empty if all cells have run
    """

    def __init__(
        self, submission: Submission, rules: Rules, outcomes: Outcomes, too_late: str
    ) -> None:
        self._submission = submission
        self._rules = rules
        self._outcomes = outcomes
        self._too_late = too_late

    def score(self, name: str) -> Score:
        """The last answer that is not blank counts."""
        answers = self._outcomes.answers(name)
        points = self._rules.points_of(name)
        if not answers:
            return Score(name, 0.0, self._why_none(name), points)
        place = max(answers)
        verdict = answers[place]
        lines = [repr(verdict)]
        if len(answers) > 1:
            cells = ", ".join(str(1 + i) for i in sorted(answers))
            lines.append(
                f"It is answered in the code cells {cells}; the last one counts."
            )
        if not verdict and place in self._outcomes.errors:
            lines.append(self._outcomes.errors[place])
        substituted = " and ".join(self._outcomes.substituted.get((name, place), []))
        if substituted:
            lines.append(
                f"Judged with the right {substituted}, since that of the notebook is not."
            )
        share = 1.0 if verdict else self._outcomes.shares.get((name, place), 0.0)
        if 0 < share < 1:
            lines.append(
                f"Right in {100 * share:.0f} % of the cases: {share * points:.2g} of {points:g} points for that."
            )
        asked = 0
        if self._rules.hint_off:
            asked = hints_asked(self._submission.cells, name)
        if asked:
            lines.append(
                f"Hints asked for: {asked}; each costs {100 * self._rules.hint_off:g} % of its points."
            )
        kept = 1 - min(1.0, asked * self._rules.hint_off)
        return Score(
            name,
            round(points * share * kept, 2),
            "\n".join(lines),
            points,
            is_answered=True,
            mistake=HINTS if verdict and asked else verdict.id,
            hint=verdict.hint,
            substituted=substituted,
        )

    def _why_none(self, name: str) -> str:
        answered = self._submission.answered_in[name]
        defined = self._submission.defined_in.get(name, ())
        for place in sorted({*answered, *defined}):
            if place in self._outcomes.left_out:
                return f"✗ Not answered: code cell {1 + place} {self._outcomes.left_out[place]}."
            if (
                place in self._outcomes.errors
                and place not in self._outcomes.judged[name]
            ):
                return f"✗ Not answered. {self._outcomes.errors[place]}"
        waiting = list(self._outcomes.judged[name].values())
        if waiting:
            return repr(waiting[-1])
        if not answered:
            return f"✗ Not answered: no cell defines {name}, or hands it to its check."
        if self._too_late:
            return f"✗ Not answered: {self._too_late}."
        return f"✗ Not answered: no cell that runs hands {name} to its check."

    def notes(self) -> list[str]:
        notes = [
            f"Code cell {1 + place} {how}; it is left out."
            for place, how in sorted(self._outcomes.left_out.items())
        ]
        for place, source in enumerate(self._submission.cells):
            if changes_checks(source):
                notes.append(
                    f"Code cell {1 + place} changes the checks; the grader has its own."
                )
        return notes + [
            self._outcomes.errors[place]
            for place in sorted(
                self._outcomes.errors.keys() - self._outcomes.left_out.keys()
            )[:3]
        ]
