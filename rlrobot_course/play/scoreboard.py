"""One robot, one scoreboard: what the learner's code so far earns on the robot that walls hold, lesson by lesson."""

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

from rlrobot_course.figures.plots import (
    BLUE,
    GREY,
    SKY,
    Picture,
    chart,
    legend_below,
    plain,
)
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.learner.learners_files import enter, entries
from rlrobot_course.play.challenge import Score, score_of
from rlrobot_course.play.report import rows_of
from rlrobot_course.worlds.short_world import ShortWorld
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.progress import progress_bar
from rlrobot_edu.robots.realism import Realism
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
AGAINST = {
    "06": "04"
}  # lessons that the title compares with another one than the one before
LOOKS = {
    "your": (BLUE, ""),
    "partly your": (SKY, ".."),
    "the given": ("white", "//"),
}  # of a bar, by its owner


class Bar(NamedTuple):
    """A lesson's bar. owner: of its functions, as `my_functions.owner_of` says it"""

    label: str
    score: Score
    owner: str = "the given"


def scoreboard(
    lesson: str,
    learn: Callable[[ShortWorld, int], object],
    owner: str,
) -> Picture:
    """Let sixteen robots learn for an hour by a lesson's code, and show its bar beside those of the lessons before.

    A lesson that the learner has not finished has the bar of `studies/scoreboard.py`, marked as given.

    lesson: its number, "04"; learn(world, steps): the lesson's loop, which learns in a world for so many steps
    owner: of the functions that `learn` calls, from `my_functions.owner_of`; the score of "your" functions is kept for
        the later lessons, in a notebook and beside it; in a browser only four robots learn, whose score is not kept

    Raises ValueError if the scoreboard has no such lesson, or if `learn` takes more or fewer steps.
    """
    bars = {number: bar for number, bar in library_bars().items() if number <= lesson}
    if lesson not in bars:
        raise ValueError(
            f"the scoreboard has no lesson {lesson!r:.200}, only {', '.join(library_bars())}"
        )
    score = Score(*mean_and_half(earned(learn, IN_TIME)))
    if is_notebook():
        kept = entries(FILE, score_of)
        bars |= {
            number: Bar(bar.label, kept[number], "your")
            for number, bar in bars.items()
            if number in kept
        }
        if owner == "your" and IN_TIME == ROBOTS:
            told = enter(FILE, lesson, score, score_of)
            if told:
                print(told)
    bars[lesson] = Bar(bars[lesson].label, score, owner)
    title = f"Lesson {lesson}: {score} a step" + f" ({IN_TIME} robots)" * (
        IN_TIME < ROBOTS
    )
    for before in [AGAINST.get(lesson, one) for one in [*bars][-2:-1]]:
        more, clear = (
            score.mean - bars[before].score.mean,
            np.hypot(score.half, bars[before].score.half),
        )
        title += (
            f", {abs(more):.2f} {'more' if more > 0 else 'less'} than lesson {before}"
        )
        title += f" (below {clear:.2f}: may be chance)" * bool(abs(more) < clear)
    return plot_bars(bars, title)


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


def library_bars(robot: str = "held", robots: int = ROBOTS) -> dict[str, Bar]:
    """By lesson, the bar of the library's agents. robot: "held", by walls, or "ideal"; robots: how many of the study"""
    return {
        row["lesson"]: Bar(row["label"], score_of((row["mean"], row["half"])))
        for row in rows_of(GIVEN)
        if (row["robot"], row["robots"]) == (robot, str(robots))
    }


def plot_bars(bars: Mapping[str, Bar], title: str) -> Picture:
    """A bar with its 95 % interval for each lesson, by its number; how it is filled says whose functions they are."""
    figure, ax = chart(
        (7.4, 3.6), "", f"reward a step, {ROBOTS} robots", title, grid="y"
    )
    told, names, owners = list[str](), list[str](), [bar.owner for bar in bars.values()]
    for at, (lesson, (label, score, owner)) in enumerate(bars.items()):
        colour, hatch = LOOKS[owner]
        name = f"{owner} functions" if owners.index(owner) == at else None
        ax.bar(
            at,
            score.mean,
            0.7,
            yerr=score.half,
            capsize=4,
            color=colour,
            hatch=hatch,
            edgecolor=GREY,
            label=name,
        )
        ax.annotate(
            f"{score.mean:.2f}",
            (at, score.mean + score.half),
            (0, 3),
            textcoords="offset points",
            ha="center",
        )
        names.append(plain(f"{lesson} {label}".replace(" ", "\n")))
        told.append(f"lesson {lesson}, {label}: {score} ({owner} functions)")
    ax.set_xticks(range(len(bars)), names)
    ax.set_xlim(-0.6, max(len(bars), 4) - 0.4)
    ax.margins(y=0.12)
    legend_below(figure, 3)
    figure.alt = f"What {ROBOTS} robots earn a step in their first hour, means with 95 % intervals: {'; '.join(told)}."
    return figure
