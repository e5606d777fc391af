"""One robot, one scoreboard: what the learner's code so far earns on the robot that walls hold, lesson by lesson."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.learner.learners_files import enter, entries
from rlrobot_course.play.challenge import Score, score_of
from rlrobot_course.play.report import rows_of
from rlrobot_course.play.staircase import Stair, plot_stairs
from rlrobot_course.worlds.short_world import ShortWorld
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.progress import progress_bar
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.show.picture import Picture
from rlrobot_grading.answers.notebook import is_notebook

FILE = "my_scores.json"
GIVEN = Path(__file__).with_name("scoreboard.csv")
TASK, ROBOTS, HOUR, FIRST_SEED = (
    "wander_1k",
    16,
    3600,
    46_000,
)  # no lesson shows the robots of these seeds
IN_TIME = (
    4 if sys.platform == "emscripten" else ROBOTS
)  # a browser runs the kernels as plain Python


def scoreboard(
    lesson: str,
    learn: Callable[[ShortWorld, int], object],
    owner: str,
) -> Picture:
    """Let sixteen robots learn for an hour by a lesson's code, and show its stair after those of the lessons before.

    A lesson that the learner has not finished has the stair of `studies/scoreboard.py`, marked as given.

    lesson: its number, "04"; learn(world, steps): the lesson's loop, which learns in a world for so many steps
    owner: of the functions that `learn` calls, from `my_functions.owner_of`; the score of "your" functions is kept for
        the later lessons, in a notebook and beside it; in a browser only four robots learn, whose score is not kept

    Raises ValueError if the scoreboard has no such lesson, or if `learn` takes more or fewer steps.
    """
    given = library_stairs()
    if lesson not in given:
        raise ValueError(
            f"the scoreboard has no lesson {lesson!r:.200}, only {', '.join(given)}"
        )
    labels = {number: stair.label for number, stair in given.items()}
    each = tuple(map(float, earned(learn, IN_TIME)))
    score = Score(*mean_and_half(each))
    stairs = {number: stair for number, stair in given.items() if number < lesson}
    if is_notebook():
        for number, (its_score, its_robots) in entries(FILE, result_of).items():
            if number in stairs:
                stairs[number] = Stair(labels[number], its_score, "your", its_robots)
        if owner == "your" and IN_TIME == ROBOTS:
            result = {"mean": score.mean, "half": score.half, "each": each}
            told = enter(FILE, lesson, result, result_of)
            if told:
                print(told)
    stairs[lesson] = Stair(labels[lesson], score, owner, each)
    return plot_stairs(stairs, labels)


def result_of(entry: Any) -> tuple[Score, tuple[float, ...]]:
    """What the learner's file has of a lesson: the score, and the reward a step of each robot.

    An older file has the mean and half of its interval alone. Raises an error if the entry is something else.
    """
    if not isinstance(entry, dict):
        return score_of(entry), ()
    each = tuple(map(float, entry["each"]))
    if len(each) != ROBOTS or not np.all(np.isfinite(each)):
        raise ValueError(f"{ROBOTS} numbers are expected, one a robot")
    return score_of((entry["mean"], entry["half"])), each


def earned(
    learn: Callable[[ShortWorld, int], object], robots: int = ROBOTS
) -> np.ndarray:
    """What each of the first robots earns a step in its first hour, array (robots,)."""
    means = []
    with progress_bar(
        robots, shown=True, unit="robot", desc=f"{robots} robots, an hour each"
    ) as bar:
        for seed in range(FIRST_SEED, FIRST_SEED + robots):
            with make_env(TASK, seed=seed, realism=Realism.vrep()) as env:
                world = ShortWorld(env, seed)
                learn(world, HOUR)
            rewards = world.history(world.table()).rewards
            if len(rewards) != HOUR:
                raise ValueError(
                    f"learn(world, steps) should take {HOUR} steps, and took {len(rewards)}"
                )
            means.append(rewards.mean())
            bar.update()
    return np.array(means)


def library_stairs(robot: str = "held", robots: int = ROBOTS) -> dict[str, Stair]:
    """By lesson, the stair of the library's agents. robot: "held", by walls, or "ideal"; robots: 16 or 32.

    The sixteen robots that walls hold are there one by one.
    """
    stairs = {}
    for row in rows_of(GIVEN):
        if (row["robot"], row["robots"]) == (robot, str(robots)):
            score = score_of((row["mean"], row["half"]))
            each = tuple(map(float, row["each robot"].split()))
            stairs[row["lesson"]] = Stair(row["label"], score, each=each)
    return stairs
