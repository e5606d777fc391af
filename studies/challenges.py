"""The landmarks of the open challenges: writes rlrobot_course/challenges.csv, ``python studies/challenges.py``.

For each lesson, what a few known answers score: first one that does nothing or acts by chance, then the course's own,
last the best that we found. It takes two minutes; ``python studies/challenges.py 03 05`` renews these lessons alone.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

import rlrobot_edu as rl
from rlrobot_course.challenge import LANDMARKS, challenge_of, landmarks
from rlrobot_edu.files import write_whole

Readings = Mapping[str, float]


def softmax(x: np.ndarray, temperature: float = 1.0) -> np.ndarray:
    """Probabilities."""
    powers = np.exp((x - x.max()) / temperature)
    return powers / powers.sum()


def pays_nothing(before: Any, after: Any) -> float:
    """A reward."""
    return 0.0


def stays_clear(before: Readings, after: Readings) -> float:
    """Lesson 01: far from the walls, and as far as can be in a step."""
    if min(after["laser_front_left"], after["laser_front_right"]) < 0.10:
        return -10.0
    way = float(np.hypot(after["x"] - before["x"], after["y"] - before["y"]))
    return 10 * min(1, way / 0.1) - 0.5 if way > 0.07 else -2.0


def hopeful(q_s: np.ndarray, tries_s: np.ndarray, t: int) -> np.ndarray:
    """Lesson 03: cold, and a little hope for what was tried seldom."""
    return softmax(q_s + 0.3 / (1 + tries_s), 0.1)


def bias_by(weigh: bool, factor: float) -> Any:
    """Lesson 07: the bias over states that share all inputs but one, weighed by visits or not, times a factor."""

    def bias(q: np.ndarray, tries: np.ndarray, shape: tuple[int, ...], s: int) -> np.ndarray:
        table, at, means = q.reshape(*shape, -1), np.unravel_index(s, shape), []
        counts = tries.reshape(table.shape) if weigh else np.ones(table.shape)
        for i in range(len(shape)):
            line = (*at[:i], slice(None), *at[i + 1 :])
            means.append((table[line] * counts[line]).sum(axis=0) / np.maximum(1, counts[line].sum(axis=0)))
        return factor * np.mean(means, axis=0)

    return bias


def lrle(temperature: float, states: list[int], rewards: list[float]) -> float:
    """Lesson 08: the paper's rule, for a default of 0.01."""
    states, rewards = states[-21:], rewards[-21:]
    redundancy = len(states) / len(set(states))
    is_loop = len(states) == 21 and states[-1] in states[:-1] and np.mean(rewards) < 0 and redundancy > 2
    return min(50, temperature + 0.25 * redundancy) if is_loop else 0.01


def impatient(temperature: float, states: list[int], rewards: list[float]) -> float:
    """Lesson 08: warm after eight steps without pay."""
    return 2.0 if len(rewards) > 8 and max(rewards[-8:]) < 0 else 0.1


def honest_arm(before: float, after: float) -> float:
    """Lesson 12a: contact alone."""
    return 10.0 if after <= 0.05 else -0.02


def leads_away(before: float, after: float) -> float:
    """Lesson 12a: each centimetre away is paid."""
    return 100 * (after - before)


def stays_there(before: float, after: float) -> float:
    """Lesson 12a: contact, a way whose every centimetre has its price, and a fine for leaving."""
    if after <= 0.05:
        return 10.0
    return -5.0 if before <= 0.05 else 50 * (before - after)


def fair(tries_s: np.ndarray, paid_s: np.ndarray, t: int) -> np.ndarray:
    """Lesson 13a: what was tried least."""
    return np.eye(3)[tries_s.argmin()]


def after_ten(a: np.ndarray, b: np.ndarray) -> str:
    """Lesson 14: ten agents of each, and then the larger mean."""
    return "more" if len(a) < 10 else "ab"[int(b.mean() > a.mean())]


def sequential(a: np.ndarray, b: np.ndarray) -> str:
    """Lesson 14: until the sums are far enough apart, for any number of agents."""
    return "more" if abs(a.sum() - b.sum()) < 4 else "ab"[int(b.mean() > a.mean())]


def round_and_round(q: np.ndarray, seen: dict, s: int) -> list:
    """Lesson 16: five of all pairs, others each time, as Dyna by chance."""
    pairs = list(seen)
    return [pairs[(7 * s + 13 * i + 5 * len(pairs)) % len(pairs)] for i in range(5)]


def largest_errors(q: np.ndarray, seen: dict, s: int) -> list:
    """Lesson 16: the five pairs that are furthest from what they should be."""
    apart = {
        pair: abs(r + 0.9 * (0 if terminated else q[s_next].max()) - q[pair])
        for pair, (r, s_next, terminated) in seen.items()
    }
    return sorted(apart, key=apart.__getitem__, reverse=True)[:5]


def turns_early(readings: Readings, a: int) -> int:
    """Lesson 17: it spins to one side as soon as something is near."""
    ahead = min(readings[f"laser_{where}"] for where in ("front", "front_left", "front_right"))
    return a if ahead > 0.2 else 2


SIMPLE, NAVIGATION = rl.load_task("wander_simple"), rl.load_task("navigation_1k")
FRONT = ("laser_front", "laser_front_left", "laser_front_right")
NINE = np.full(9, 1 / 9)

# by lesson, {landmark: answer}; the first one does nothing, or acts by chance
ANSWERS: dict[str, dict[str, Any]] = {
    "01": {
        "a reward of 0": pays_nothing,
        "the task's own": SIMPLE.reward,
        "best known": stays_clear,
    },
    "02a": {
        "at random": {"epsilon": 1.0},
        "α 0.1, γ 0.9, ε 0.1": {"alpha": 0.1, "gamma": 0.9, "epsilon": 0.1},
        "best known": {"alpha": 0.75, "gamma": 0.8, "epsilon": 0.002},
    },
    "03": {
        "at random": lambda q_s, tries_s, t: NINE,
        "softmax, T = 1": lambda q_s, tries_s, t: softmax(q_s),
        "best known": hopeful,
    },
    "04b": {
        "Q-learning, as it comes": {"method": "Q+EG"},
        "SARSA, as it comes": {"method": "SARSA+EG"},
        "best known": {"method": "Q+EG", "alpha": 0.97, "gamma": 0.78, "epsilon": 0.0},
    },
    "05": {
        "no traces": {"lam": 0},
        "the defaults": {"lam": 0.9},
        "best known": {"alpha": 0.6, "gamma": 0.98, "lam": 0.97, "temperature": 0.01},
    },
    "06": {
        "always 0": lambda e, alpha: 0,
        "accumulating": lambda e, alpha: e + 1,
        "replacing": lambda e, alpha: 1,
        "dutch": lambda e, alpha: (1 - alpha) * e + 1,
        "best known": lambda e, alpha: 1.5,
    },
    "07": {
        "no bias": lambda q, tries, shape, s: np.zeros(9),
        "QBIASSR": bias_by(weigh=False, factor=1),
        "best known": bias_by(weigh=True, factor=2),
    },
    "08": {
        "always T = 0.01": lambda temperature, states, rewards: 0.01,
        "LRLE": lrle,
        "best known": impatient,
    },
    "09": {
        "at random": {"method": "Q+RANDOM"},
        "Q+SR": {"method": "Q+SR"},
        "TOSL+QBIASSR": {},
        "best known": {"alpha": 0.68, "gamma": 0.79, "lam": 0.78, "temperature": 0.5},
    },
    "10": {
        "one laser to the rear": {"laser_rear": [4.9]},
        "three lasers, the task's cuts": {laser: [0.27, 0.53, 0.80] for laser in FRONT},
        "best known": dict(zip(FRONT, ([0.45], [0.25], [0.25]), strict=True)),
    },
    "11": {
        "a reward of 0": pays_nothing,
        "only the goal pays": lambda before, after: -0.1,
        "the task's own": NAVIGATION.reward,
    },
    "12a": {
        "away is paid": leads_away,
        "contact alone": honest_arm,
        "best known": stays_there,
    },
    "13a": {
        "always ahead": lambda tries_s, paid_s, t: [1, 0, 0],
        "at random": lambda tries_s, paid_s, t: [1 / 3, 1 / 3, 1 / 3],
        "best known": fair,
    },
    "14": {"a guess": lambda a, b: "a", "after ten of each": after_ten, "best known": sequential},
    "15": {"wander_1k": "wander_1k", "wander_simple": "wander_simple", "the template of new_task": "template"},
    "16": {"no thoughts": lambda q, seen, s: [], "any five": round_and_round, "best known": largest_errors},
    "17": {"standing still": lambda readings, a: 4, "no guard": lambda readings, a: a, "best known": turns_early},
}


def rows_of(lesson: str) -> list[tuple[str, str, str, str]]:
    """The landmarks of a lesson: its number, the landmark, mean and half of the interval."""
    rows, challenge = [], challenge_of(lesson)
    with TemporaryDirectory() as folder:
        for landmark, answer in ANSWERS[lesson].items():
            tried = rl.new_task("template", folder) if answer == "template" else answer
            score = challenge.score(tried)
            rows.append((lesson, landmark, f"{score.mean:.4f}", f"{score.half:.4f}"))
            print(*rows[-1], flush=True)
    return rows


def main() -> None:
    """Measure, and write the table."""
    renewed = sys.argv[1:] or list(ANSWERS)
    known = {} if renewed == list(ANSWERS) else landmarks()
    rows = []
    for lesson in ANSWERS:
        old = [(lesson, name, f"{x.mean:.4f}", f"{x.half:.4f}") for name, x in known.get(lesson, {}).items()]
        rows += rows_of(lesson) if lesson in renewed else old
    lines = [",".join(row) if "," not in row[1] else f'{row[0]},"{row[1]}",{row[2]},{row[3]}' for row in rows]
    write_whole(LANDMARKS, "\n".join(["lesson,landmark,mean,half", *lines]) + "\n")


if __name__ == "__main__":
    main()
