"""An exercise with many right answers: a reward for the arm, judged by all steps and loops that the arm can do."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from rlrobot_course.lesson_13.loops import Loop, best_loop
from rlrobot_course.worlds.arm_world import Places, places_of
from rlrobot_edu.task.task_file import load_task
from rlrobot_grading.answers.limits import Elsewhere, attempt
from rlrobot_grading.answers.replay import Outcome
from rlrobot_grading.answers.source import is_unfinished
from rlrobot_grading.answers.values import safely
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.hints.detectors import known_mistake
from rlrobot_grading.hints.evidence import Hint

CONTACT, NEARER, NOTHING = (
    0.05,
    0.02,
    1e-9,
)  # [m], [m], and what rounding may leave of a sum that is 0


class Broken(NamedTuple):
    """A rule that a reward breaks: what happened, and a hint."""

    text: str
    hint: str


class RewardExercise(Exercise):
    """The answer is a function of the distances before and after a step; it is right if it keeps three rules.

    The tape only serves to recognise mistakes.
    """

    def judge(self, answer: Any) -> Verdict:
        """Judge `answer`; never raises."""
        if not callable(answer):
            return super().judge(answer)
        got = self.outcomes(answer)
        odd = [i for i, outcome in enumerate(got) if not _is_number(outcome)]
        if odd:
            return self._no_number(answer, got, odd)
        rewards, failure, _ = attempt(
            _in_all_steps, answer, endless=issubclass(type(answer), Elsewhere)
        )
        if failure or not np.isfinite(rewards).all():
            return Verdict(
                "wrong",
                "For some steps of the arm this is no number.",
                hint="try many distances.",
            )
        broken = first_broken(rewards)
        if not broken:
            n = f"{len(_arm().angles)} places"
            told = f"Right. The arm can get to {n}: no loop through them, outside contact, pays more than 0 a step."
            return Verdict("right", told, gained=self.gained)
        hint = known_mistake(self.evidence(answer, got)) or Hint("rule", broken.hint)
        return Verdict("wrong", broken.text, hint=hint.text, id=hint.id)

    def _no_number(
        self, answer: Callable[..., Any], got: Sequence[Outcome], odd: Sequence[int]
    ) -> Verdict:
        """The verdict on a function that fails in the cases `odd`, or returns no number there."""
        if safely(False, is_unfinished, answer):
            return self._waits()
        verdict = self._wrong(answer, got, odd[0], len(odd))
        rows = tuple(
            (name, "a number", mine) if name == "reward" else (name, right, mine)
            for name, right, mine in verdict.rows
        )
        if not got[odd[0]].failure and got[odd[0]].values["reward"] is None:
            told = "your function returns nothing here. Does every way through it end with return?"
            return replace(verdict, rows=rows, hint=told, id="form")
        return replace(verdict, rows=rows)


@cache
def _arm() -> Places:
    return places_of(load_task("arm_1k"))


def _is_number(outcome: Outcome) -> bool:
    value = outcome.values.get("reward")
    if type(value) is np.ndarray and value.ndim == 0:
        value = value[()]  # such an array is its number, as for all checks
    return (
        not outcome.failure
        and isinstance(value, int | float | np.number)
        and not isinstance(value, bool)
    )


def _in_all_steps(answer: Callable[[float, float], float]) -> np.ndarray:
    """The reward of every action at every place, array (places, actions)."""
    distance = _arm().distance.tolist()
    return np.array(
        [
            [float(answer(distance[i], distance[j])) for j in row]
            for i, row in enumerate(_arm().next)
        ]
    )


def first_broken(rewards: np.ndarray) -> Broken | None:
    """The first rule that is broken by what each step pays, array (places, actions)."""
    arm = _arm()
    before, after = (
        np.broadcast_to(arm.distance[:, None], rewards.shape),
        arm.distance[arm.next],
    )
    contact, nearer = after <= CONTACT, before - after > NEARER
    for wrong, rule, hint in (
        (contact & (rewards != 10), "it must pay 10, as before",
         "look first whether after is at most 0.05, and return 10.0 then."),
        (~contact & (rewards >= 10), "it must pay less than 10, or the way would be better than its end",
         "make it smaller: at most one step is worth as much as contact, and none outside."),
        (~contact & nearer & (rewards <= 0), "nearer by more than 2 cm and still outside, it must pay more than 0",
         "before − after is above 0 for a step that leads nearer."),
    ):  # fmt: skip
        if wrong.any():
            i, a = np.argwhere(wrong)[0]
            step = f"from {100 * before[i, a]:.1f} to {100 * after[i, a]:.1f} cm"
            return Broken(f"A step {step} pays {rewards[i, a]:.4g}: {rule}.", hint)
    loop = best_loop(arm.next, rewards, arm.distance > CONTACT)
    return _milked(loop) if loop.pays > NOTHING else None


def _milked(loop: Loop) -> Broken:
    """What a loop that pays says of the reward."""
    way = [
        f"{100 * _arm().distance[place]:.1f}"
        for place in (*loop.places, loop.places[0])
    ]
    paid = ", ".join(f"{r:+.3g}" for r in loop.rewards)
    if len(loop.rewards) == 1:
        told = f"Standing still at {way[0]} cm pays {loop.rewards[0]:.3g} a step."
        return Broken(told, "whoever gets no nearer should get no reward.")
    told = f"This loop pays {loop.pays:.3g} a step: distances {' → '.join(way)} cm, rewards {paid}."
    return Broken(
        told,
        "the rewards of a closed path must sum to 0 or less. What could each centimetre be worth?",
    )
