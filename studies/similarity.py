"""When does similarity help? Measures it; writes similarity.json and, from it, docs/when_similarity_helps.md.

``python studies/similarity.py`` takes some ten minutes on two cores; ``--page`` writes the page and its figures
alone anew.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from similarity_numbers import LENGTHS, LONG_WORKED_EXAMPLE, METHOD, TRIED
from similarity_page import write_page
from similarity_split import factors, spectrum
from similarity_worlds import SHAPE, EvenWorld, rewards_of_order

import rlrobot_edu as rl
from rlrobot_edu.files import write_whole

NUMBERS = Path(__file__).parent / "similarity.json"
SEED = 20261129

# 1. Worlds of one order
WORLDS = 24
TEMPERATURES = (1.0, 0.2)
EVEN = {"gamma": 0.0, "alpha": 0.3, "r_max": 100.0, "loop_evasion": False}

# 2. Spectra
TASKS = ("wander_simple", "wander_1k", "arm_1k")
SPECTRUM_METHODS = (METHOD, "Q+SR")
HOUR, SPECTRUM_ROBOTS = 3600, 20

# 3. Advice: steps and episodes of a robot whose reward is measured
LENGTH_OF = {
    "worked_example": (HOUR, None),
    "wander_simple": (HOUR, None),
    "wander_1k": (HOUR, None),
    "wander_4k": (HOUR, None),
    "wander_12k": (HOUR, None),
    "navigation_1k": (3 * HOUR, 3),
    "arm_1k": (HOUR, 30),
    "arm_4k": (HOUR, 30),
}
ROBOTS, TEACHERS = 30, 4
LONG = 1_000_000  # steps of a teacher


def seeds(*key: int) -> list[np.random.SeedSequence]:
    """Seeds of an agent and its world, from these numbers alone."""
    return np.random.SeedSequence(SEED, spawn_key=key).spawn(2)


def averages(
    method: str, temperature: float, rewards: np.ndarray, key: tuple[int, ...]
) -> list[float]:
    """Reward a step of one agent in its first 3600, 20,000 and 200,000 steps."""
    agent_seed, world_seed = seeds(*key)
    env = EvenWorld(rewards, world_seed)
    agent = rl.Agent(env, method, seed=agent_seed, temperature=temperature, **EVEN)
    earned = rl.learn(agent, env, LENGTHS[-1], progress=False).rewards
    return [round(float(earned[:steps].mean()), 5) for steps in LENGTHS]


def measure_orders() -> dict[str, Any]:
    """By temperature, order and method: a row for each world. The three agents of a world see the same states."""
    found: dict[str, Any] = {}
    n = len(SHAPE)
    for temperature in TEMPERATURES:
        by_order = []
        for k, factor in enumerate(factors(n)):
            rows: dict[str, list[list[float]]] = {
                "SR": [],
                "QBIASSR": [],
                "SR, fair T": [],
            }
            for world in range(WORLDS):
                rng = np.random.default_rng(seeds(0, world)[0])
                rewards = rewards_of_order(k, rng)
                run = (rewards, (1, world))
                rows["SR"].append(averages("Q+SR", temperature, *run))
                rows["QBIASSR"].append(averages("Q+QBIASSR", temperature, *run))
                rows["SR, fair T"].append(averages("Q+SR", temperature / factor, *run))
            by_order.append(rows)
            print(
                temperature,
                k,
                {name: np.mean(its, axis=0) for name, its in rows.items()},
                flush=True,
            )
        found[f"{temperature:g}"] = by_order
    return found


def env_of(task: str, seed: np.random.SeedSequence) -> Any:
    """The task's world; robots are moved by geometry alone."""
    if task == "worked_example":
        return rl.make_env(task, seed)
    return rl.make_env(task, seed, engine="kinematic")


def measure_spectra() -> dict[str, Any]:
    """By task: its bins and, by method, the spectrum of each robot's Q after an hour."""
    found: dict[str, Any] = {}
    for number, task in enumerate(TASKS):
        its: dict[str, Any] = {"shape": list(rl.load_task(task).states.shape)}
        for method_number, method in enumerate(SPECTRUM_METHODS):
            its[method] = []
            for robot in range(SPECTRUM_ROBOTS):
                agent_seed, env_seed = seeds(2, number, method_number, robot)
                with env_of(task, env_seed) as env:
                    agent = rl.Agent(env, method, seed=agent_seed)
                    rl.learn(agent, env, HOUR, progress=False)
                shares = spectrum(agent.q, agent.shape)
                its[method].append(np.round(shares, 5).tolist())
            print(task, method, np.mean(its[method], axis=0).round(3), flush=True)
        found[task] = its
    return found


def advice(q: np.ndarray, shape: tuple[int, ...], s: int) -> np.ndarray:
    """The bias of `s` without the value of `s` itself, array (n_actions,).

    That is the mean, over the inputs, of the others' mean. An input with one bin has no others and does not count.
    """
    table = q.reshape(*shape, -1)
    bins = np.unravel_index(s, shape)
    opinions = []
    for i, size in enumerate(shape):
        if size > 1:
            row = table[(*bins[:i], slice(None), *bins[i + 1 :])]
            opinions.append((row.sum(axis=0) - q[s]) / (size - 1))
    return np.mean(opinions, axis=0)


def skill(q: np.ndarray, shape: tuple[int, ...], states: np.ndarray) -> float:
    """How good the advice is in these states, by the values `q`.

    1 if its favourite is always the best action, 0 if it is as good as an action drawn at random. Ties go to the first.
    """
    lost = 0.0
    lost_by_chance = 0.0
    for s in states:
        favourite = int(advice(q, shape, s).argmax())
        lost += q[s].max() - q[s, favourite]
        lost_by_chance += q[s].max() - q[s].mean()
    return float(1 - lost / lost_by_chance)


def measure_advice() -> dict[str, Any]:
    """By task: the skill of the advice in each teacher's table, and what robots earn with and without the bias."""
    found: dict[str, Any] = {}
    for number, (task, (steps, episodes)) in enumerate(LENGTH_OF.items()):
        its: dict[str, Any] = {"skill": [], "states": [], "SR": [], "QBIASSR": []}
        long = LONG_WORKED_EXAMPLE if task == "worked_example" else LONG
        for teacher in range(TEACHERS):
            agent_seed, env_seed = seeds(3, number, 0, teacher)
            with env_of(task, env_seed) as env:
                agent = rl.Agent(env, "Q+RANDOM", seed=agent_seed)
                rl.learn(agent, env, long, progress=False)
            known = np.flatnonzero((agent.visits >= TRIED).all(axis=1))
            its["skill"].append(round(skill(agent.q, agent.shape, known), 5))
            its["states"].append(len(known))
        for selection_number, selection in enumerate(("SR", "QBIASSR")):
            for robot in range(ROBOTS):
                agent_seed, env_seed = seeds(3, number, 1 + selection_number, robot)
                with env_of(task, env_seed) as env:
                    agent = rl.Agent(env, f"Q+{selection}", seed=agent_seed)
                    history = rl.learn(
                        agent, env, steps, episodes=episodes, progress=False
                    )
                its[selection].append(round(float(history.final_average_reward), 5))
        print(task, {name: np.mean(x).round(3) for name, x in its.items()}, flush=True)
        found[task] = its
    return found


def main() -> None:
    """Measure, unless it has been measured, and write."""
    if "--page" not in sys.argv:
        found = {
            "orders": measure_orders(),
            "spectra": measure_spectra(),
            "advice": measure_advice(),
        }
        write_whole(NUMBERS, json.dumps(found) + "\n")
    write_page(json.loads(NUMBERS.read_text(encoding="utf-8")))


if __name__ == "__main__":
    main()
