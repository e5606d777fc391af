"""The landmarks of the open challenges: writes rlrobot_course/play/challenges.csv, ``python studies/challenges.py``.

For each lesson, what a few known answers score: first one that does nothing or acts by chance, then the course's own,
last the best that we found. It takes two minutes.
"""

from __future__ import annotations

import csv
import importlib
from collections.abc import Mapping
from typing import Any

import numpy as np

from rlrobot_course.play.challenge import LANDMARKS, Challenge

Readings = Mapping[str, float]


def softmax(x: np.ndarray, temperature: float = 1.0) -> np.ndarray:
    """Probabilities."""
    powers = np.exp((x - x.max()) / temperature)
    return powers / powers.sum()


def hopeful(q_s: np.ndarray, tries_s: np.ndarray, t: int) -> np.ndarray:
    """Lesson 04: cold, and a little hope for what was tried seldom."""
    return softmax(q_s + 0.3 / (1 + tries_s), 0.1)


def bias_by(weigh: bool, factor: float) -> Any:
    """Lesson 05: the bias over states that share all inputs but one, weighed by visits or not, times a factor."""

    def bias(
        q: np.ndarray, tries: np.ndarray, shape: tuple[int, ...], s: int
    ) -> np.ndarray:
        table, at, means = q.reshape(*shape, -1), np.unravel_index(s, shape), []
        counts = tries.reshape(table.shape) if weigh else np.ones(table.shape)
        for i in range(len(shape)):
            line = (*at[:i], slice(None), *at[i + 1 :])
            means.append(
                (table[line] * counts[line]).sum(axis=0)
                / np.maximum(1, counts[line].sum(axis=0))
            )
        return factor * np.mean(means, axis=0)

    return bias


def after_ten(a: np.ndarray, b: np.ndarray) -> str:
    """Lesson 15: ten agents of each, and then the larger mean."""
    return "more" if len(a) < 10 else "ab"[int(b.mean() > a.mean())]


def sequential(a: np.ndarray, b: np.ndarray) -> str:
    """Lesson 15: until the sums are far enough apart, for any number of agents."""
    return "more" if abs(a.sum() - b.sum()) < 4 else "ab"[int(b.mean() > a.mean())]


def turns_early(readings: Readings, a: int) -> int:
    """Lesson 18: it spins to one side as soon as something is near."""
    ahead = min(
        readings[f"laser_{where}"] for where in ("front", "front_left", "front_right")
    )
    return a if ahead > 0.2 else 2


FRONT = ("laser_front", "laser_front_left", "laser_front_right")
NINE = np.full(9, 1 / 9)

# by lesson, {landmark: answer}; the first one does nothing, or acts by chance
ANSWERS: dict[str, dict[str, Any]] = {
    "04": {
        "at random": lambda q_s, tries_s, t: NINE,
        "softmax, T = 1": lambda q_s, tries_s, t: softmax(q_s),
        "best known": hopeful,
    },
    "05": {
        "no bias": lambda q, tries, shape, s: np.zeros(9),
        "QBIASSR": bias_by(weigh=False, factor=1),
        "best known": bias_by(weigh=True, factor=8),
    },
    "11": {
        "one laser to the rear": {"laser_rear": [4.9]},
        "three lasers, the task's cuts": {laser: [0.27, 0.53, 0.80] for laser in FRONT},
        "best known": dict(zip(FRONT, ([0.45], [0.25], [0.25]), strict=True)),
    },
    "15": {
        "a guess": lambda a, b: "a",
        "after ten of each": after_ten,
        "best known": sequential,
    },
    "18": {"no guard": lambda readings, a: a, "best known": turns_early},
}


def challenge_of(lesson: str) -> Challenge:
    """The challenge of a lesson."""
    module = importlib.import_module(f"rlrobot_course.lesson_{lesson}.challenge")
    return module.challenge


def rows_of(lesson: str) -> list[tuple[str, str, str, str]]:
    """The landmarks of a lesson: its number, the landmark, mean and half of the interval."""
    rows, challenge = [], challenge_of(lesson)
    for landmark, answer in ANSWERS[lesson].items():
        score = challenge.score(answer)
        rows.append((lesson, landmark, f"{score.mean:.4f}", f"{score.half:.4f}"))
        print(*rows[-1], flush=True)
    return rows


def main() -> None:
    """Measure, and write the table."""
    with LANDMARKS.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("lesson", "landmark", "mean", "half"))
        for lesson in ANSWERS:
            table.writerows(rows_of(lesson))


if __name__ == "__main__":
    main()
