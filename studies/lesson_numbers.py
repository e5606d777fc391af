"""Numbers that lessons quote and do not compute: ``python studies/lesson_numbers.py`` writes lesson_numbers.csv.

Each is a mean with half of its 95 % interval (Student's t), of robots; in lesson 06 exact steps, in lessons 11 and 12
also a number of robots, in lesson 18 what one robot lost. It takes some minutes of two cores.
tests/studies/test_headlines.py holds that the lessons say these numbers.
"""

import copy
import csv
from collections.abc import Callable, Mapping
from dataclasses import replace
from math import hypot
from pathlib import Path

import numpy as np
from scipy import stats
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

import rlrobot_edu as rl
from rlrobot_course.lesson_12.worlds import OwnReward
from rlrobot_edu.learning.history import History
from rlrobot_edu.robots.arenas import ARENAS, Arena
from rlrobot_edu.widgets.playground.cliff import cliff_model, greedy_path
from rlrobot_ros import RobotLink, ServedRobot

HERE = Path(__file__).parent
Row = tuple[str, str, int, float, float]


def mean_and_half(x: np.ndarray) -> tuple[float, float]:
    """Mean, and half of its 95 % interval."""
    return float(x.mean()), float(stats.sem(x) * stats.t.ppf(0.975, len(x) - 1))


def lesson_07() -> list[Row]:
    """How much λ, on the robot that slides along walls and on one that they hold: thirty of each kind, for an hour."""
    settings = {f"λ = {lam}": {"method": "SL+SR", "lam": lam} for lam in (0, 0.5, 0.9)}
    rows: list[Row] = []
    for walls, realism in (("slide", None), ("hold", rl.Realism.vrep())):
        runs = rl.compare(
            "wander_1k",
            settings,
            30,
            realism=realism,
            loop_evasion=False,
            progress=False,
        )
        for label in settings:
            for steps in (1000, 3600):
                at_steps = runs[label].curves[:, steps - 1]
                rows.append(
                    ("07", f"{label}, walls {walls}", steps, *mean_and_half(at_steps))
                )
    return rows


def lesson_06() -> list[Row]:
    """How many steps the best way along the cliff takes if an agent explores, γ = 0.9."""
    model = cliff_model()
    s_next, r, terminated = (
        x.reshape(-1, model.n_actions)
        for x in (model.s_next, model.r, model.terminated)
    )

    def best(epsilon: float) -> np.ndarray:
        q = np.zeros(r.shape)
        for _ in range(500):
            worth = (1 - epsilon) * q.max(axis=1) + epsilon * q.mean(axis=1)
            q = r + 0.9 * np.where(terminated, 0, worth[s_next])
        return q

    return [
        ("06, best way", f"ε = {e}", 0, len(greedy_path(best(e))) - 1, 0.0)
        for e in (0.11, 0.1, 0.004, 0.0035)
    ]


def _waits(history: History, task: rl.Task) -> float:
    """Mean number of steps until the next 10, from each step that begins with a wall in front."""
    paid = np.flatnonzero(history.rewards == 10)
    walls = [
        t
        for t, s in enumerate(history.s[: paid[-1] + 1])
        if task.states.bins(s)[0] == 0
    ]
    return float(np.mean(paid[np.searchsorted(paid, walls)] - walls + 1))


def lesson_11() -> list[Row]:
    """Thirty robots where the cells have one or three: other walls, another arena."""
    task = rl.load_task("wander_1k")
    arena = replace(task, scene="maze_4x4_goal")
    walls = {"ideal walls": None, "walls that hold": rl.Realism.vrep()}
    rows: list[Row] = []

    def drive(
        agent: rl.Agent,
        its: rl.Task,
        seed: int,
        steps: int,
        realism: rl.Realism | None = None,
    ) -> History:
        return rl.learn(
            agent,
            rl.make_env(its, seed=seed, realism=realism),
            steps,
            progress=False,
            keep=True,
        )

    paid: dict[str, list[float]] = {}
    waits: dict[str, list[float]] = {name: [] for name in walls}
    forward = dict.fromkeys(walls, 0)
    for seed in range(30):
        trained = {name: rl.Agent(task, seed=seed) for name in walls}
        for name, realism in walls.items():
            waits[name].append(
                _waits(drive(trained[name], task, seed, 2400, realism), task)
            )
            forward[name] += trained[name].policy[15] in (0, 8)  # fast and slow
        ideal = trained["ideal walls"]
        for name, history in {
            "trained, on ideal walls": drive(copy.deepcopy(ideal), task, seed, 600),
            "trained, on walls that hold": drive(
                copy.deepcopy(ideal), task, seed, 600, rl.Realism.vrep()
            ),
            "trained, in the arena": drive(ideal, arena, seed, 600),
            "beginners, in the arena": drive(
                rl.Agent(arena, seed=seed), arena, seed, 600
            ),
            "random, in the arena": drive(
                rl.Agent(arena, "Q+RANDOM", seed=seed), arena, seed, 600
            ),
        }.items():
            paid.setdefault(name, []).append(float(history.rewards.mean()))
    rows += [("11", name, 600, *mean_and_half(np.array(x))) for name, x in paid.items()]
    rows += [
        ("11, waits", name, 2400, *mean_and_half(np.array(x)))
        for name, x in waits.items()
    ]
    rows += [
        ("11, forward in state 15", name, 2400, n, 0.0) for name, n in forward.items()
    ]
    return rows


def _way_to_goal(
    arena: Arena, grid: float = 0.05, clear: float = 0.25
) -> tuple[np.ndarray, np.ndarray]:
    """Places on a grid that keep clear of the walls, array (places, 2), and the way from each to the goal [m]."""
    x_goal, y_goal, _ = arena.goal
    axis = np.arange(-2.0, 2.0 + grid / 2, grid)
    x, y = np.meshgrid(axis, axis, indexing="ij")
    free = np.ones(x.shape, dtype=bool)
    for wall in arena.walls:
        (left, low), (right, high) = (
            wall.corners().min(axis=0) - clear,
            wall.corners().max(axis=0) + clear,
        )
        free &= ~((left < x) & (x < right) & (low < y) & (y < high))
    number = np.full(x.shape, -1)
    number[free] = np.arange(free.sum())
    n, edges = len(axis), []
    for i, j in ((1, 0), (0, 1), (1, 1), (1, -1)):  # each pair of neighbours once
        here = (slice(0, n - i), slice(max(0, -j), n - max(0, j)))
        there = (slice(i, n), slice(max(0, j), n - max(0, -j)))
        both = free[here] & free[there]
        edges.append(
            (
                number[here][both],
                number[there][both],
                np.full(both.sum(), grid * hypot(i, j)),
            )
        )
    start, end, length = (np.concatenate(parts) for parts in zip(*edges, strict=True))
    places = np.column_stack([x[free], y[free]])
    goal = np.hypot(*(places - (x_goal, y_goal)).T).argmin()
    ways = dijkstra(
        csr_array((length, (start, end)), shape=(len(places),) * 2),
        directed=False,
        indices=goal,
    )
    return places[np.isfinite(ways)], ways[np.isfinite(ways)]


def lesson_12() -> list[Row]:
    """Robots that may reverse, with a potential: how many of nine reach the goal in 3 hours.

    And of four in their last 1000 steps, by the potential of their start: in how many states they are, at what pay.
    """
    task = replace(rl.load_task("navigation_1k"), command=None)
    arena = ARENAS[task.scene]
    places, ways = _way_to_goal(arena)

    def straight(readings: Mapping[str, float]) -> float:
        return hypot(readings["x"] - arena.goal[0], readings["y"] - arena.goal[1])

    def around(readings: Mapping[str, float]) -> float:
        apart = np.hypot(*(places - (readings["x"], readings["y"])).T)
        return float(ways[apart.argmin()] + apart.min())

    def drive(
        far: Callable[[Mapping[str, float]], float],
        factor: float,
        seed: int,
        zero: float = 0.0,
    ) -> History:
        def pay(
            before: Mapping[str, float],
            after: Mapping[str, float],
            r: float,
            terminated: bool,
        ) -> float:
            honest = r if r in (10, -2, -10) else -0.1  # nothing for coming nearer
            return (
                honest
                - 0.9 * factor * (far(after) - zero) * (not terminated)
                + factor * (far(before) - zero)
            )

        env = OwnReward(rl.make_env(task, seed=seed), pay)
        return rl.learn(
            rl.Agent(task, seed=seed), env, steps=10_800, progress=False, keep=True
        )

    kinds = {"straight distance": straight, "way round the walls": around}
    start = {"x": arena.start[0], "y": arena.start[1]}
    last: list[Row] = []
    for name, zero in {"start −61.8": 0.0, "start 0": around(start)}.items():
        ends = [drive(around, 10, seed, zero) for seed in range(4)]
        states = np.array([len(np.unique(history.s[-1000:])) for history in ends])
        pay = np.array([history.rewards[-1000:].mean() for history in ends])
        last.append(
            ("12, states in the last 1000 steps", name, 10_800, *mean_and_half(states))
        )
        last.append(
            ("12, pay in the last 1000 steps", name, 10_800, *mean_and_half(pay))
        )
    return last + [
        ("12", f"{factor} times the {name}: robots that arrived", 10_800,
         float(sum(drive(far, factor, seed).terminated.any() for seed in range(9))), 0.0)
        for factor in (10, 1) for name, far in kinds.items()
    ]  # fmt: skip


def _twenty_minutes(name: str, seed: int) -> rl.Agent:
    agent = rl.Agent(name, seed=seed)
    rl.learn(agent, rl.make_env(name, seed=seed), steps=1200, progress=False)
    return agent


def _lost_over_a_link(name: str, seed: int) -> float:
    """What a robot earns a step in its simulator, less what it earns over a link, for 100 steps."""
    agent = _twenty_minutes(name, seed)
    alone = rl.learn(
        copy.deepcopy(agent), rl.make_env(name, seed=7), steps=100, progress=False
    ).rewards.mean()
    with ServedRobot(name, port=0, simulated_time=True) as served:
        link = RobotLink(
            served.address, confirmed=True, simulated_time=True, max_speed=0.2
        )
        env = rl.make_env(name, link=link, seed=0)
        linked = rl.learn(agent, env, steps=100, progress=False).rewards.mean()
        env.close()
    return float(alone - linked)


def lesson_18() -> list[Row]:
    """What four robots of each kind lose over a link."""
    return [
        ("18, over a link", f"{name}, seed {seed}", 100, _lost_over_a_link(name, seed), 0.0)
        for name in ("giraff_wander_simple", "wander_1k") for seed in range(4)
    ]  # fmt: skip


if __name__ == "__main__":
    lessons = (
        lesson_07,
        lesson_06,
        lesson_11,
        lesson_12,
        lesson_18,
    )
    found = [row for rows in lessons for row in rows()]
    with open(HERE / "lesson_numbers.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(("lesson", "of", "steps", "value", "half_interval"))
        for lesson, of, steps, value, half in found:
            writer.writerow((lesson, of, steps, f"{value:.4f}", f"{half:.4f}"))
