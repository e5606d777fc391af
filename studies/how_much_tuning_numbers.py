"""What how_much_tuning.py describes and does not test: the price of tuning, what the paper's setting beats, luck."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from how_much_tuning import Study
from how_much_tuning_tests import Part

TRIES = (1, 2, 4, 8, 16, 32, 64)


class Price(NamedTuple):
    """What the best of some random settings scores, mean of the six tasks.

    tries: how many settings; estimate, low, high: arrays (tries,), with the 95 % bootstrap interval
    """

    tries: tuple[int, ...]
    estimate: np.ndarray
    low: np.ndarray
    high: np.ndarray

    def worth(self, score: float) -> int | None:
        """How many random tries surely score more than this: the interval lies above; None if no number does."""
        better = np.flatnonzero(self.low > score)
        return self.tries[better[0]] if len(better) else None


def best_of(tries: int, choosing: np.ndarray, judging: np.ndarray) -> float:
    """The expected score of the best of some settings, drawn with replacement.

    choosing, judging: arrays (settings,), the mean by which the best is chosen, and the mean by which it is judged

    Of n settings in rising order, the best of k draws is the i-th with the probability (i / n)^k - ((i - 1) / n)^k.
    """
    judging = judging[np.argsort(choosing, kind="stable")]
    up_to = (np.arange(len(judging) + 1) / len(judging)) ** tries
    return float(np.diff(up_to) @ judging)


def price(study: Study, method: str) -> Price:
    """Half of the robots choose, the other half judges, and the other way round."""
    sizes = study.plan["sizes"]
    n, robots = sizes["settings"], sizes["robots"]
    found = {
        world: np.asarray(study.scored(world, study.swept(world, method)))
        for world in study.plan["tasks"]
    }
    rng = np.random.default_rng(study.plan["seeds"]["bootstrap"])
    estimate = _curve(found, np.arange(n), [np.arange(robots)] * len(found))
    drawn = []
    for _ in range(sizes["price draws"]):
        settings = rng.integers(0, n, n)
        drawn.append(_curve(found, settings, [rng.permutation(robots) for _ in found]))
    low, high = np.percentile(drawn, [2.5, 97.5], axis=0)
    return Price(TRIES, estimate, low, high)


def _curve(
    found: dict[str, np.ndarray], settings: np.ndarray, robots: list[np.ndarray]
) -> np.ndarray:
    """The mean over the tasks of the best of each number of tries."""
    rows = []
    for scores, order in zip(found.values(), robots, strict=True):
        half = len(order) // 2
        one = scores[settings][:, order[:half]].mean(axis=1)
        other = scores[settings][:, order[half:]].mean(axis=1)
        rows.append(
            [(best_of(k, one, other) + best_of(k, other, one)) / 2 for k in TRIES]
        )
    return np.mean(rows, axis=0)


def beaten_by_the_papers(study: Study, method: str) -> float:
    """The share of the settings that score less than the paper's, mean of the six tasks."""
    shares = []
    for world in study.plan["tasks"]:
        paper = study.judged(world, method, "paper").mean()
        shares.append(np.mean(study.swept(world, method).mean(axis=1) < paper))
    return float(np.mean(shares))


def luck(study: Study, method: str) -> float:
    """What the best setting of a sweep seems to score, less what the winner is judged to; mean of the six tasks."""
    gaps = []
    for world in study.plan["tasks"]:
        seeming = study.swept(world, method).mean(axis=1).max()
        judged = study.judged(world, method, study.winner(world, method)).mean()
        gaps.append(study.scored(world, seeming) - study.scored(world, judged))
    return float(np.mean(gaps))


def said(part: Part) -> str:
    """A number with its sign, and its interval."""
    low, high = part.interval
    return f"{signed(part.estimate)} [{signed(low)}, {signed(high)}]"


def plainly(part: Part) -> str:
    """The same without a plus sign, for what is no difference."""
    low, high = part.interval
    return f"{part.estimate:.2f} [{low:.2f}, {high:.2f}]".replace("-", "−")


def signed(value: float) -> str:
    """A number with its sign; zero has none."""
    text = f"{value:+.2f}"
    return "0.00" if float(text) == 0 else text.replace("-", "−")
