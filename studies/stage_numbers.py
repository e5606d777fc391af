"""What is asking worth? Runs stage_registered.json; writes the numbers of `rl.stage`'s page.

``python studies/stage_numbers.py`` takes some minutes of one core. The page takes its honest line from the file, as
docs/when_similarity_helps.md takes its table.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import similarity_page

import rlrobot_edu as rl
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.files import write_whole
from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.widgets.stage.honest import read_numbers

HERE = Path(__file__).parent
FILE = HERE.parent / "rlrobot_edu/widgets/stage/numbers.json"
REGISTERED: dict[str, Any] = json.loads(
    (HERE / "stage_registered.json").read_text(encoding="utf-8")
)
TASK = rl.load_task(REGISTERED["task"])
STEPS: int = REGISTERED["steps"]
BUMP, PAYS = -2.0, 1.0  # a step bumps if its reward is at most this; it pays above that
WALLS: dict[str, dict[str, Any]] = {
    "ideal": {"engine": "kinematic"},
    "held": {"engine": "pymunk", "realism": rl.Realism.vrep()},
}
GROUPS = {"0": (0, 0), "1 to 3": (1, 3), "4 to 6": (4, 6), "7 or more": (7, 15)}
ALL = "all"


class Moment(NamedTuple):
    """A robot in a state that is new to it.

    known: how many similar states it has been in; chance: of the action that it favours
    pays, bumps: chances of such a step, each action as likely as the others, and with the robot's probabilities
    """

    known: int
    chance: float
    pays: tuple[float, float]
    bumps: tuple[float, float]


class Hour(NamedTuple):
    """A robot's first hour, and the moments at which its state was new."""

    metres: float
    bumps: int
    reward: float
    moments: list[Moment]


def hour_of(method: str, walls: str, seed: int, looks: bool) -> Hour:
    """Let a robot learn for an hour. looks: whether its new states are looked at, which needs ideal walls."""
    agent = rl.Agent(TASK, method, seed=seed)
    env = rl.make_env(TASK, seed=seed, **WALLS[walls])
    tried = Trial() if looks else None
    robot = env.unwrapped.robot  # type: ignore[attr-defined]
    metres, rewards, moments = 0.0, [], []
    place, before = None, None
    seen: set[int] = set()
    for step in rl.steps(agent, env, STEPS):
        if tried and place is not None and step.s not in seen:
            pays = tried.rewards_at(place)
            moments.append(moment(step.s, step.probabilities, pays, seen))
        seen.add(step.s)
        axle = axle_of(robot.readings)
        if before is None:
            before = CHASSIS[TASK.robot].axle_at(*robot.arena.start)
        metres += float(np.hypot(axle[0] - before[0], axle[1] - before[1]))
        before = axle
        rewards.append(step.r)
        if tried:
            place = robot.parts.place.copy()
    env.close()
    r = np.array(rewards)
    return Hour(metres, int((r <= BUMP).sum()), float(r.mean()), moments)


def axle_of(readings: dict[str, float]) -> tuple[float, float]:
    """Where the axle is [m]."""
    chassis = CHASSIS[TASK.robot]
    return chassis.axle_at(readings["x"], readings["y"], readings["theta"])


class Trial:
    """A second robot, which tries all actions from a place of the first."""

    def __init__(self) -> None:
        env = rl.make_env(TASK, seed=0, **WALLS["ideal"])
        env.reset()
        self.robot = env.unwrapped.robot  # type: ignore[attr-defined]

    def rewards_at(self, place: np.ndarray) -> np.ndarray:
        """The reward of each action there, array (n_actions,)."""
        rewards = []
        for a in range(TASK.actions.n):
            self.robot.parts.place[:] = place
            before = self.robot.look()
            after = self.robot.act(TASK.command_for(a))
            rewards.append(TASK.reward_for(before, after))
        return np.array(rewards)


def moment(s: int, p: np.ndarray, rewards: np.ndarray, seen: set[int]) -> Moment:
    """What asking changes in a state. p: the robot's probabilities; seen: the states it has been in."""
    known = 0
    for states in TASK.states.siblings(s).values():
        known += sum(int(k) in seen for k in states if k != s)
    pays, bumps = rewards > PAYS, rewards <= BUMP
    return Moment(
        known,
        float(p.max()),
        (float(pays.mean()), float(p[pays].sum())),
        (float(bumps.mean()), float(p[bumps].sum())),
    )


def spread(values: Sequence[float]) -> dict[str, float]:
    """Mean, half of its 95 % interval, median, and how many are above zero."""
    x = np.array(values, dtype=float)
    low, high = mean_band(x)
    return {
        "mean": round(float(x.mean()), 4),
        "half": round(float(high - low) / 2, 4),
        "median": round(float(np.median(x)), 4),
        "above": int((x > 0).sum()),
        "robots": len(x),
    }


def differences(without: list[Hour], asking: list[Hour]) -> dict[str, Any]:
    """Of each measure: what robots have that ask nobody, and what asking adds."""
    found = {}
    for name in REGISTERED["measures"]:
        alone = [getattr(hour, name) for hour in without]
        asked = [getattr(hour, name) for hour in asking]
        more = [b - a for a, b in zip(alone, asked, strict=True)]
        found[name] = {
            "alone": spread(alone),
            "asking": spread(asked),
            "more": spread(more),
        }
    return found


def advice(hours: list[Hour]) -> dict[str, Any]:
    """By how many similar states are known: how often a step pays and bumps, by lot and asked."""
    found = {}
    for name, (least, most) in (GROUPS | {ALL: (0, 15)}).items():
        of_each = []
        for hour in hours:
            of_each.append([m for m in hour.moments if least <= m.known <= most])
        moments = [m for its in of_each for m in its]
        found[name] = {
            "moments": len(moments),
            "chance": round(float(np.mean([m.chance for m in moments])), 4),
            "pays": risen([[m.pays for m in its] for its in of_each if its]),
            "bumps": risen([[m.bumps for m in its] for its in of_each if its]),
        }
    return found


def risen(chances: list[list[tuple[float, float]]]) -> dict[str, Any]:
    """The mean chance of all moments, by lot and asked, and the rise in the mean of each robot."""
    lot, asked = np.array([pair for its in chances for pair in its]).mean(axis=0)
    rises = [float(np.mean([b - a for a, b in its])) for its in chances]
    return {"lot": round(lot, 4), "asked": round(asked, 4), "more": spread(rises)}


def typical(seeds: Sequence[int], more: Sequence[float]) -> int:
    """The seed whose difference is nearest to the median of all."""
    away = np.abs(np.array(more) - np.median(more))
    return seeds[int(np.argmin(away))]


def measure(seeds: Sequence[int]) -> dict[str, Any]:
    """All numbers of the page, from these seeds."""
    n_actions = TASK.actions.n
    found: dict[str, Any] = {"seeds": [seeds[0], seeds[-1]], "actions": n_actions}
    for walls in REGISTERED["walls"]:
        for algorithm in REGISTERED["algorithms"]:
            hours: dict[str, list[Hour]] = {}
            for selection in REGISTERED["selections"]:
                looks = walls == "ideal" and selection == "QBIASSR"
                method = f"{algorithm}+{selection}"
                hours[selection] = [
                    hour_of(method, walls, seed, looks) for seed in seeds
                ]
            alone, asking = hours["SR"], hours["QBIASSR"]
            its = differences(alone, asking)
            if walls == "ideal":
                its["advice"] = advice(asking)
            if (walls, algorithm) == ("ideal", "TOSL"):
                more = [b.metres - a.metres for a, b in zip(alone, asking, strict=True)]
                found["shown"] = typical(seeds, more)
            found[f"{algorithm}, {walls}"] = its
            print(f"{algorithm}, {walls}: {time.process_time():.0f} s", flush=True)
    return found


def main(names: Sequence[str]) -> None:
    """Measure and write; with two seeds given, only print what these and all between them give.

    ``--page`` measures nothing, and only writes the table.
    """
    if list(names) == ["--page"]:
        write_table()
        return
    if names:
        first, last = map(int, names)
        print(json.dumps(measure(range(first, last + 1)), indent=1))
        return
    first, last = REGISTERED["seeds"]
    found = measure(range(first, last + 1))
    write_whole(FILE, json.dumps(found, indent=1) + "\n")
    write_table()


def write_table() -> None:
    """The page with the table, which has much from another study, anew."""
    read_numbers.cache_clear()
    others = (HERE / "similarity.json").read_text(encoding="utf-8")
    write_whole(similarity_page.PAGE_OF, similarity_page.page(json.loads(others)))


if __name__ == "__main__":
    main(sys.argv[1:])
