"""Do methods earn the same on the kinematic base as on pymunk's, where walls hold and commands come late?

``python studies/walls_that_hold.py`` measures both engines with `Realism.vrep()` on wander_1k, writes the numbers to
studies/walls_that_hold.json and the table into docs/studies/kinematic_base.md. It takes six minutes of one core.
``--speed`` measures the speed alone, ``--table`` nothing: they write the table anew from the numbers that are there.

The kinematic walls were written by looking at pymunk's steps with other seeds, 1 and 1000 to 1039.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats

import rlrobot_edu as rl
from rlrobot_edu.experiments.statistics import Tukey, mean_band

ROOT = Path(__file__).parents[1]
NUMBERS = ROOT / "studies/walls_that_hold.json"
PAGE = ROOT / "docs/studies/kinematic_base.md"
TASK = "wander_1k"
STEPS = 3600
METHODS = ("Q+SR", "SARSA+SR", "SL+SR", "TOSL+SR", "Q+QBIASSR", "TOSL+QBIASSR")
SEEDS = {"pymunk": range(5000, 5090), "kinematic": range(6000, 6120)}
CONTACTS = (-2, -10)  # rewards of a step after which walls are too near
SIGNIFICANT = 0.05
BEGIN = "<!-- written by studies/walls_that_hold.py -->"
END = "<!-- end -->"


def run(engine: str, method: str, seed: int) -> tuple[float, float]:
    """Reward a step of one robot, and the share of its steps that end at a wall."""
    agent = rl.Agent(TASK, method, seed=seed)
    with rl.make_env(TASK, seed, engine=engine, realism=rl.Realism.vrep()) as env:
        rewards = rl.learn(agent, env, STEPS, progress=False).rewards
    return float(rewards.mean()), float(np.isin(rewards, CONTACTS).mean())


def runs(engine: str, seeds: Sequence[int]) -> dict[str, dict[str, list[float]]]:
    """Of each method: the rewards and the contacts of its robots."""
    found = {}
    for method in METHODS:
        pairs = np.array([run(engine, method, seed) for seed in seeds])
        rewards, contacts = pairs.round(5).T.tolist()
        found[method] = {"rewards": rewards, "contacts": contacts}
        print(engine, method, pairs.mean(axis=0).round(3), flush=True)
    return found


def speeds() -> dict[str, dict[str, float]]:
    """Steps a second of processor time of each engine, by method: medians of five runs; the engines take turns."""
    found: dict[str, dict[str, float]] = {engine: {} for engine in SEEDS}
    for method in ("Q+SR", "TOSL+QBIASSR"):
        seconds: dict[str, list[float]] = {engine: [] for engine in SEEDS}
        for seed in range(6):
            for engine in SEEDS:
                start = time.process_time()
                run(engine, method, seed)
                seconds[engine].append(time.process_time() - start)
        for engine in SEEDS:
            median = np.median(seconds[engine][1:])  # the first one compiles
            found[engine][method] = round(STEPS / float(median))
    return found


def significant_pairs(rewards: Mapping[str, Sequence[float]]) -> list[tuple[str, str]]:
    """The pairs of methods, the better one first, whose means differ by Tukey's test."""
    tukey = Tukey.of({method: np.array(values) for method, values in rewards.items()})
    pairs = []
    for pair in tukey.pairs:
        if pair.p < SIGNIFICANT:
            better, worse = pair.first, pair.second
            if pair.difference < 0:
                better, worse = worse, better
            pairs.append((better, worse))
    return pairs


def table(found: Mapping[str, Any]) -> str:
    """Of each method: what it earns and how often walls are met on both engines, and the difference."""
    there, here = (found[engine] for engine in SEEDS)
    lines = [
        "| wander_1k, 3600 steps | pymunk | kinematic | difference | p | steps at a wall |",
        "|---|---|---|---|---|---|",
    ]
    for method in METHODS:
        one, other = (np.array(its[method]["rewards"]) for its in (there, here))
        means = " | ".join(_mean(values) for values in (one, other))
        test = stats.ttest_ind(other, one, equal_var=False)
        low, high = test.confidence_interval()
        difference = f"{other.mean() - one.mean():+.2f} [{low:+.2f}, {high:+.2f}]"
        walls = " / ".join(
            f"{np.mean(its[method]['contacts']):.3f}" for its in (there, here)
        )
        row = f"| {method} | {means} | {difference} | {test.pvalue:.2f} | {walls} |"
        lines.append(row.replace("-0.", "−0."))
    lines += [
        "",
        f"Steps a second of processor time, learning included: {_speeds(found)}.",
    ]
    return "\n".join(lines)


def _speeds(found: Mapping[str, Any]) -> str:
    """The speeds in words."""
    parts = []
    for method, pymunk in found["speed"]["pymunk"].items():
        kinematic = found["speed"]["kinematic"][method]
        times = kinematic / pymunk
        parts.append(f"{method} {kinematic:,}, {times:.0f} times pymunk's {pymunk:,}")
    return "; ".join(parts)


def _mean(rewards: np.ndarray) -> str:
    """Mean and half of its 95 % interval."""
    low, high = mean_band(rewards)
    return f"{rewards.mean():.2f} ± {(high - low) / 2:.2f}"


def in_page(page: str, written: str) -> str:
    """The page with this table in place of the one between the two marks."""
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    return f"{before}{BEGIN}\n{written}\n{END}{after}"


def main() -> None:
    """Measure, and write the numbers and the table."""
    found = {}
    if NUMBERS.exists():
        found = json.loads(NUMBERS.read_text(encoding="utf-8"))
    if not {"--table", "--speed"} & set(sys.argv):
        for engine, seeds in SEEDS.items():
            found[engine] = runs(engine, seeds)
    if "--table" not in sys.argv:
        found["speed"] = speeds()
    NUMBERS.write_text(json.dumps(found) + "\n", encoding="utf-8")
    page = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(in_page(page, table(found)), encoding="utf-8")
    print(table(found))


if __name__ == "__main__":
    main()
