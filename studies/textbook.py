"""Do the textbook's results come out? Writes docs/studies/textbook.md.

``python studies/textbook.py``; it takes about a minute.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import textbook_worlds as worlds
from gymnasium.envs.toy_text import FrozenLakeEnv, TaxiEnv

import rlrobot_edu as rl
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_edu.learning.history import History

PAGE_FILE = Path(__file__).parents[1] / "docs" / "studies" / "textbook.md"
GAMMA = 1 - 1e-9  # of the examples without discounting
LONG = 100_000  # steps, more than all episodes of a run take
BOOK, SOLVED = "Sutton & Barto", "table of Gymnasium, solved"


def run(
    model: rl.SampleModel,
    method: str,
    seed: int,
    episodes: int,
    steps: int = LONG,
    **parameters: float,
) -> History:
    """One agent in one world."""
    agent = rl.Agent(
        model, method, seed=2 * seed, r_max=1.0, **parameters
    )  # r_max: ε-greedy does not look at it
    env = rl.make_env(model, seed=2 * seed + 1)
    return rl.learn(agent, env, steps, episodes=episodes, progress=False)


def cliff(method: str, runs: int) -> np.ndarray:
    """Mean return of the last 100 of 500 episodes on the cliff, array (runs,)."""
    model, parameters = worlds.cliff(), {"alpha": 0.5, "epsilon": 0.1, "gamma": GAMMA}
    return np.array(
        [
            run(model, f"{method}+EG", i, 500, **parameters).returns[-100:].mean()
            for i in range(runs)
        ]
    )


def windy(runs: int) -> np.ndarray:
    """Episodes of SARSA that end within 8000 steps in the windy gridworld, array (runs,)."""
    model, parameters = (
        worlds.windy_gridworld(),
        {"alpha": 0.5, "epsilon": 0.1, "gamma": GAMMA},
    )
    histories = (
        run(model, "SARSA+EG", i, 8000, 8000, **parameters) for i in range(runs)
    )
    return np.array([history.terminated.sum() for history in histories])


def maze(planning_steps: int, runs: int, episodes: int = 50) -> np.ndarray:
    """Steps of each episode in the Dyna maze, array (runs, episodes)."""
    model, parameters = (
        worlds.dyna_maze(),
        {"alpha": 0.1, "epsilon": 0.1, "gamma": 0.95},
    )
    planner = (
        {"planner": "dyna", "planning_steps": planning_steps} if planning_steps else {}
    )
    histories = (
        run(model, "Q+EG", i, episodes, **parameters, **planner) for i in range(runs)
    )
    return np.array(
        [
            np.diff(np.flatnonzero(history.terminated), prepend=-1)
            for history in histories
        ]
    )


def good_from(steps: np.ndarray, most: float = 25.0) -> int:
    """The first episode, from 1, from which on the mean of so many runs takes at most `most` steps."""
    bad = np.flatnonzero(steps.mean(axis=0) > most)
    return int(bad[-1]) + 2 if len(bad) else 1


def walk_error(values: np.ndarray) -> float:
    """RMS error of the values of the random walk, array (cells,)."""
    true = np.linspace(-1, 1, worlds.WALK_CELLS + 2)[1:-1]
    return float(np.sqrt(np.mean((values - true) ** 2)))


def walk(lam: float, alpha: float, runs: int) -> np.ndarray:
    """RMS error of true online TD(λ) at the ends of the first 10 episodes of the walk, their mean, array (runs,)."""
    model, errors = worlds.random_walk(), np.empty((runs, 10))
    for i in range(runs):
        parameters = {"alpha": alpha, "gamma": GAMMA, "lam": lam, "traces": "full"}
        agent, env = (
            rl.Agent(model, "TOSL+RANDOM", seed=2 * i, **parameters),
            rl.make_env(model, seed=2 * i + 1),
        )
        for episode in range(10):
            rl.learn(agent, env, LONG, episodes=1, progress=False)
            errors[i, episode] = walk_error(agent.q[:, 0])
    return errors.mean(axis=1)


def frozen_lake(size: str) -> float:
    """The optimal value of the start on the slippery lake, γ = 0.99."""
    return float(
        rl.value_iteration(
            worlds.of_gymnasium(FrozenLakeEnv(map_name=size)), gamma=0.99
        ).v[0]
    )


def taxi() -> np.ndarray:
    """Return of the planned trip from each of the 300 starts, array (starts,); there is no chance in it."""
    model = worlds.of_gymnasium(TaxiEnv())
    policy, returns = rl.value_iteration(model, gamma=0.99).policy, []
    for s in model.starts:
        total, terminated = 0.0, False
        while not terminated:
            ((s, r, terminated, _),) = model.outcomes(int(s), int(policy[s]))
            total += r
        returns.append(total)
    return np.array(returns)


def told(sample: Sequence[float] | np.ndarray) -> str:
    """Mean and 95 % interval."""
    mean, half = mean_and_half(list(sample))
    digits = 3 if abs(mean) < 1 else 1
    return f"{mean:.{digits}f} ± {half:.{digits}f}".replace("-", "−")


def rows(runs: int) -> list[tuple[str, str, str, str]]:
    """Result, what is published, where, and what comes out here."""
    figure = f"{BOOK}, example 6.6, figure"
    mazes = {n: maze(n, runs) for n in (0, 5, 50)}
    fifth = {n: f"{steps[:, 4].mean():.0f}" for n, steps in mazes.items()}
    good = {n: good_from(steps) for n, steps in mazes.items()}
    return [
        ("cliff, return in the last 100 of 500 episodes: SARSA", "about −25", figure, told(cliff("SARSA", runs))),
        ("… Q-learning", "about −50", figure, told(cliff("Q", runs))),
        ("… expected SARSA", "better than both", f"{BOOK}, section 6.6", told(cliff("ESARSA", runs))),
        ("windy gridworld, episodes in 8000 steps: SARSA", "about 170", f"{BOOK}, example 6.5", told(windy(runs))),
        (
            "Dyna maze, first episode from which on at most 25 steps are needed: 0, 5, 50 planning steps",
            "about 25, 5, 3",
            f"{BOOK}, example 8.1",
            f"{good[0]}, {good[5]}, {good[50]}",
        ),
        ("… steps in episode 5", "falls with planning", f"{BOOK}, figure 8.2", f"{fifth[0]}, {fifth[5]}, {fifth[50]}"),
        (
            "19-state random walk, true online, λ = 0.8, α = 0.4: RMS error in the first 10 episodes",
            "between 0.25 and 0.3",
            f"{BOOK}, figure 12.8",
            told(walk(0.8, 0.4, 5 * runs)),
        ),
        ("FrozenLake 4 × 4, γ = 0.99: value of the start", "0.542", SOLVED, f"{frozen_lake('4x4'):.4f}"),
        ("FrozenLake 8 × 8, γ = 0.99: value of the start", "0.415", SOLVED, f"{frozen_lake('8x8'):.4f}"),
        ("Taxi: mean return of the best trips", "7.93", SOLVED, f"{taxi().mean():.2f}"),
    ]  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--runs",
        type=int,
        default=40,
        help="repetitions; with another number the page is only printed",
    )
    runs: int = parser.parse_args().runs
    table = "\n".join(f"| {' | '.join(row)} |" for row in rows(runs))
    page = PAGE.format(table=table, runs=runs, walks=5 * runs)
    print(page)
    if runs == parser.get_default("runs"):
        PAGE_FILE.write_text(page, encoding="utf-8")


PAGE = """\
# Textbook results

Does the library find what textbooks print? Each row compares a published result with ours: the mean of {runs} runs with
its 95 % interval, and of {walks} runs for the random walk. The rows of the Dyna maze are read off the mean of {runs}
runs. The last three rows are exact. The worlds are in [textbook_worlds.py](../../studies/textbook_worlds.py), and small
versions of all rows are tests. Written by `python studies/textbook.py`.

| result | published | where | here |
|---|---|---|---|
{table}

Most of the book's results are curves, so the numbers read off them are approximate. Its examples do not discount,
except the maze; here γ is 1 − 10⁻⁹, which changes no digit shown. "Table of Gymnasium, solved" is the value that any
planner must find in the environment's own table of outcomes.

The book: R. S. Sutton and A. G. Barto, *Reinforcement Learning: An Introduction*, second edition, MIT Press, 2018.
"""

if __name__ == "__main__":
    main()
