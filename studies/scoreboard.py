"""The course's scoreboard: ``python studies/scoreboard.py`` writes rlrobot_course/play/scoreboard.csv.

For each lesson from 03 on, what the library's agents earn a step in their first hour in the maze of wander_1k: on the
robot that walls hold, which is the paper's, and on the ideal one. The scoreboard shows the rows of 16 robots, which are
the robots of its learners. The rows of all robots have narrower intervals (Student's t, 95 %), and further agents that
the lessons' text can quote. The rows that the scoreboard shows also have their robots one by one.

The parameters are the paper's: α = 0.1, γ = λ = 0.9, T = 1. Two settings are the lessons': every trace is kept
(`traces="full"`, where the paper drops small ones), and loop evasion is off until lesson 09. It takes eight minutes of
one core.
"""

import csv
from typing import Any

from joblib import Parallel, delayed

import rlrobot_edu as rl
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.play.scoreboard import FIRST_SEED, GIVEN, HOUR, ROBOTS, TASK

COLUMNS = (
    "lesson", "label", "method", "robot", "robots", "mean", "half", "each robot"
)  # fmt: skip
ALL = 32  # robots of each row that is for readers of the table
EVADES = {"loop_evasion": True}
WORLDS = {"held": rl.Realism.vrep(), "ideal": None}
# by lesson: what its stair is called, the agents' method and their settings
LESSONS: dict[str, tuple[str, str, dict[str, Any]]] = {
    "03": ("at random", "Q+RANDOM", {}),
    "04": ("softmax", "Q+SR", {}),
    "05": ("QBIASSR", "Q+QBIASSR", {}),
    "06": ("SARSA", "SARSA+SR", {}),
    "07": ("traces", "SL+SR", {}),
    "08": ("true online", "TOSL+SR", {}),
    "09": ("loop evasion", "TOSL+SR", EVADES),
    "10": ("all of it", "TOSL+QBIASSR", EVADES),
}
COLD = {"temperature": 0.01}
# agents of a lesson that have no stair, on the held robot
FURTHER: dict[str, tuple[str, str, dict[str, Any]]] = {
    "03 greedy": ("greedy", "Q+GREEDY", {}),
    "04 ε-greedy": ("ε = 0.1", "Q+EG", {}),
    "09 cold": ("T = 0.01", "TOSL+SR", COLD),
    "09 cold, evading": ("T = 0.01, loop evasion", "TOSL+SR", COLD | EVADES),
    "10 without evasion": ("T = 1", "TOSL+QBIASSR", {}),
    "10 cold": ("T = 0.01", "TOSL+QBIASSR", COLD),
    "10 cold, evading": ("T = 0.01, loop evasion", "TOSL+QBIASSR", COLD | EVADES),
}


def earned(method: str, settings: dict[str, Any], robot: str, seed: int) -> float:
    """Reward a step of one robot in its first hour."""
    agent = rl.Agent(
        TASK, method, seed=seed, **{"traces": "full", "loop_evasion": False, **settings}
    )
    with rl.make_env(TASK, seed=seed, realism=WORLDS[robot]) as env:
        return float(rl.learn(agent, env, HOUR, progress=False).rewards.mean())


def rows_of(lesson: str, robot: str) -> list[tuple[str, ...]]:
    """A lesson's row of sixteen robots, and the one of all; of further agents the latter alone."""
    label, method, settings = (LESSONS | FURTHER)[lesson]
    seeds = range(FIRST_SEED, FIRST_SEED + ALL)
    means = Parallel(n_jobs=-1)(
        delayed(earned)(method, settings, robot, seed) for seed in seeds
    )
    rows = []
    for robots in (ROBOTS, ALL) if lesson in LESSONS else (ALL,):
        mean, half = mean_and_half(means[:robots])
        each = ""
        if robot == "held" and robots == ROBOTS:
            each = " ".join(f"{value:.4f}" for value in means[:robots])
        row = (lesson, label, method, robot, str(robots), f"{mean:.4f}", f"{half:.4f}")
        print(*row, flush=True)
        rows.append((*row, each))
    return rows


def main() -> None:
    """Measure, and write the table."""
    rows = [
        row for robot in WORLDS for lesson in LESSONS for row in rows_of(lesson, robot)
    ]
    rows += [row for lesson in FURTHER for row in rows_of(lesson, "held")]
    with GIVEN.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        table.writerows(rows)


if __name__ == "__main__":
    main()
