"""Numbers that lessons quote and do not compute: ``python studies/lesson_numbers.py`` writes lesson_numbers.csv.

Each is a mean with half of its 95 % interval (Student's t), of robots; in lesson 06 the median error over a journey.
It takes three minutes of two cores. tests/studies/test_headlines.py holds that the lessons say these numbers.
"""

import csv
from pathlib import Path

import numpy as np
from joblib import Parallel, delayed
from scipy import stats

import rlrobot_edu as rl
from rlrobot_edu.course.lesson_06 import forward_view

HERE = Path(__file__).parent
Row = tuple[str, str, int, float, float]


def mean_and_half(x: np.ndarray) -> tuple[float, float]:
    """Mean, and half of its 95 % interval."""
    return float(x.mean()), float(stats.sem(x) * stats.t.ppf(0.975, len(x) - 1))


def lesson_05() -> list[Row]:
    """How much λ on the robot: the cell's own agents, thirty of each kind, for an hour."""
    rows: list[Row] = []
    for lam in (0, 0.5, 0.9, 0.99):
        runs = rl.repeat("wander_1k", "SL+SR", repetitions=30, steps=3600, seed=0, lam=lam, loop_evasion=False,
                         progress=False)  # fmt: skip
        for steps in (1000, 2000, 3600):
            rows.append(("05", f"{lam}", steps, *mean_and_half(runs.curves[:, steps - 1])))
    return rows


def lesson_06() -> list[Row]:
    """How far three traces are from the ideal, on the lesson's journey, by the learning rate of the learners."""
    env = rl.make_env("wander_1k", seed=0)
    agent = rl.Agent("wander_1k", "TOSL+SR", alpha=0.5, seed=0, loop_evasion=False)
    journey = [(x.s, x.a, x.r, x.s_next, x.a_next, x.terminated) for x in rl.steps(agent, env, steps=150)]
    return [
        ("06", f"{trace}, α = {alpha}", 150,
         float(np.median(forward_view.errors(trace, journey, "wander_1k", alpha=alpha, traces="full"))), 0.0)
        for alpha in (0.5, 0.1) for trace in ("accumulating", "replacing")
    ]  # fmt: skip


def _one_of_07(method: str, seed: int, temperature: float) -> float:
    env = rl.make_env("wander_1k", seed=seed)
    same = {"seed": seed, "traces": "full", "loop_evasion": False, "temperature": temperature}
    return rl.learn(rl.Agent(env, method, **same), env, 2000, progress=False).final_average_reward


def lesson_07() -> list[Row]:
    """The bias against a colder softmax: the cell's own `library`, sixty robots of each kind, 2000 steps."""
    rows: list[Row] = []
    for method, temperature in (("TOSL+QBIASSR", 1.0), ("TOSL+SR", 1.0), ("TOSL+SR", 0.8), ("TOSL+SR", 0.5)):
        final = Parallel(n_jobs=-1)(delayed(_one_of_07)(method, seed, temperature) for seed in range(60))
        rows.append(("07", f"{method}, T = {temperature}", 2000, *mean_and_half(np.array(final))))
    return rows


if __name__ == "__main__":
    with open(HERE / "lesson_numbers.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(("lesson", "of", "steps", "value", "half_interval"))
        for lesson, of, steps, value, half in lesson_05() + lesson_06() + lesson_07():
            writer.writerow((lesson, of, steps, f"{value:.4f}", f"{half:.4f}"))
