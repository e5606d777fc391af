"""An open challenge: many answers are possible, none is the right one, and each gets a score.

A lesson's `challenge.py` says what counts and how one robot or agent fares with an answer. The score is the mean over
robots that nobody has watched, with its 95 % interval. Beside it stand landmarks, which `studies/challenges.py`
computes.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.learner.learners_files import enter, entries
from rlrobot_course.play.report import rows_of
from rlrobot_course.worlds.tapes import draw
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_grading.answers.limits import attempt
from rlrobot_grading.answers.notebook import is_notebook
from rlrobot_grading.answers.source import is_unfinished, uses_chance
from rlrobot_grading.answers.values import one_line, safely, show
from rlrobot_grading.exercises.verdict import Verdict

FILE = "my_challenges.json"
LANDMARKS = Path(__file__).with_name("challenges.csv")
FIRST_SEED = 29_000  # of the robots that score: no lesson has shown them
SECONDS = 30.0  # of computing that a learner's function may take in all


class Score(NamedTuple):
    """A mean over seeds, and half of its 95 % interval."""

    mean: float
    half: float

    def __str__(self) -> str:
        return f"{self.mean:.2f} ± {self.half:.2f}".replace("-", "−")


@dataclass(frozen=True)
class Challenge:
    """What is to be done better than anybody has, and how it is measured; call it with an answer.

    lesson: its number; rules: what counts, in three sentences; unit: of the score, "m in 100 steps"
    read: an answer -> what is tried; raises ValueError for an answer that does not fit
    trial: what was read, seed of a robot -> its score; raises ValueError, too
    seeds: how many robots; least_wins: whether less is better
    """

    lesson: str
    rules: str
    unit: str
    read: Callable[[Any], Any]
    trial: Callable[[Any, int], float]
    seeds: int = 24
    least_wins: bool = False

    def __call__(self, answer: Any) -> Verdict:
        """The score of an answer, kept in the learner's folder if it is their best; never raises."""
        if answer is ... or answer is None or safely(False, is_unfinished, answer):
            return Verdict(
                "waiting",
                f"This challenge waits for your answer. {self.rules}",
                gained=self._beside,
            )
        try:
            score = self.score(answer)
        except (
            Exception
        ) as error:  # the answer is a learner's, and so is what goes wrong in it
            return Verdict(
                "wrong", one_line(f"No score: {error}".rstrip(".") + ".", 400)
            )
        text = f"{score} {self.unit}, over {self.seeds} seeds"
        if is_notebook():  # elsewhere nothing is kept, so nobody knows the best
            best, told = self._keep(score)
            yours = "your best so far" if best == score else f"your best is {best}"
            text = f"{text}: {yours}. {told}".strip()
        return Verdict("score", text, gained=self._beside)

    def score(self, answer: Any) -> Score:
        """The score of an answer. Raises ValueError if the answer does not fit, or does not end."""
        if safely(False, uses_chance, answer):
            raise ValueError(
                "your function draws random numbers, so its score would be another one each time"
            )
        tried = self.read(answer)
        return Score(
            *mean_and_half(
                [self.trial(tried, FIRST_SEED + i) for i in range(self.seeds)]
            )
        )

    @property
    def _beside(self) -> str:
        less = " Less is better." * self.least_wins
        known = "; ".join(
            f"{name}: {score}" for name, score in landmarks()[self.lesson].items()
        )
        return f"For comparison ({self.unit}): {known}.{less}"

    def _keep(self, score: Score) -> tuple[Score, str]:
        """The better of this score and the learner's best so far, which is kept; and what is to be said of its file."""
        best = entries(FILE, score_of).get(self.lesson, score)
        best = min(best, score) if self.least_wins else max(best, score)
        return best, enter(FILE, self.lesson, best, score_of)


class Watched:
    """A learner's function: each call is ended in time, and what goes wrong in it is one sentence.

    answer: the function; call: how it is called, "my_rule(q_s, t)"; read: what it returns -> what is used of it; raises
        ValueError for what does not fit
    """

    def __init__(self, answer: Any, call: str, read: Callable[[Any], Any]) -> None:
        if not callable(answer):
            raise ValueError(
                f"a function is expected, {call}, and this is {show(answer)}"
            )
        self.answer, self.call, self.read, self.spent = answer, call, read, 0.0

    def __call__(self, *arguments: Any) -> Any:
        begun = time.process_time()
        value, failure, _ = attempt(self.answer, *arguments)
        self.spent += time.process_time() - begun
        if failure:
            raise ValueError(
                f"{self.call} {failure.text}{f', in the line “{failure.line}”' * bool(failure.line)}"
            )
        if self.spent > SECONDS:
            raise ValueError(
                f"{self.call} has taken more than {SECONDS:.0f} seconds; make it quicker"
            )
        try:
            return self.read(value)
        except (TypeError, ValueError) as error:
            raise ValueError(f"{self.call} returns {show(value)}: {error}") from None


def number(low: float, high: float) -> Callable[[Any], float]:
    """Reads a number from `low` to `high`."""

    def read(value: Any) -> float:
        if (
            np.ndim(value)
            or isinstance(value, str | bool)
            or value is None
            or not low <= float(value) <= high
        ):
            raise ValueError(f"a number from {low:g} to {high:g} is expected")
        return float(value)

    return read


def array(
    n: int, most: float, sums_to: float | None = None
) -> Callable[[Any], np.ndarray]:
    """Reads `n` numbers up to `most`; as probabilities, none below 0, if their sum is to be `sums_to`."""

    def read(value: Any) -> np.ndarray:
        numbers = np.array(value, dtype=float)
        fits = numbers.shape == (n,) and bool(np.all(np.abs(numbers) <= most))
        if not fits or (
            sums_to is not None
            and (numbers.min() < 0 or abs(numbers.sum() - sums_to) > 1e-6)
        ):
            what = (
                f"numbers up to {most:g}"
                if sums_to is None
                else f"probabilities, whose sum is {sums_to:g},"
            )
            raise ValueError(f"{n} {what} are expected")
        return numbers

    return read


Choose = Callable[[Agent, int, int, np.ndarray], np.ndarray]


def mean_reward(choose: Choose, steps: int, seed: int) -> float:
    """The reward a step of a robot that learns wander_1k by Q-learning, chooses in its own way, and goes on for ever.

    choose(agent, s, t, tries) -> probabilities in state s at step t; tries: array like q, how often each pair was tried
    """
    agent = Agent("wander_1k", "Q+SR", seed=seed)
    env = make_env("wander_1k", seed=seed)
    rng, rewards = np.random.default_rng(seed), []
    tries = np.zeros(agent.q.shape, dtype=int)
    s = env.reset()[1]["state"]
    a = draw(choose(agent, s, 0, tries), rng.random())
    for t in range(steps):
        _, r, terminated, _, info = env.step(a)
        s_next = info["state"]
        a_next = draw(choose(agent, s_next, t + 1, tries), rng.random())
        tries[s, a] += 1
        agent.update(s, a, float(r), s_next, a_next, terminated)
        rewards.append(float(r))
        s, a = s_next, a_next
    return float(np.mean(rewards))


@cache
def landmarks() -> dict[str, dict[str, Score]]:
    """By lesson, what known answers score; the first one does nothing or acts by chance, the last is the best known."""
    known: dict[str, dict[str, Score]] = {}
    for row in rows_of(LANDMARKS):
        score = score_of((row["mean"], row["half"]))
        known.setdefault(row["lesson"], {})[row["landmark"]] = score
    return known


def score_of(entry: Any) -> Score:
    """What a file has of a score. Raises ValueError or TypeError if it is none."""
    mean, half = map(float, entry)
    if not np.isfinite(mean):
        raise ValueError("a score is a number")
    return Score(mean, half)
