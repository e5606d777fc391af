"""What the rule of loop evasion sees in the queues of robots, step by step, and the picture of it."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import BLUE, GREY, RED, Picture, plain
from rlrobot_course.lesson_09.exercises import new_temperature, redundancy
from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.numerals import with_minus

LENGTH = 21  # of the queues
LOOKS = ((BLUE, "-"), (GREY, "--"))  # of two robots


class Walk(NamedTuple):
    """The states that a robot came to in some steps, and what each step paid."""

    states: Sequence[int]
    rewards: Sequence[float]


class Seen(NamedTuple):
    """What the rule sees after a step: the redundancy and the mean reward of the queue, and the temperature it sets."""

    redundancy: float
    mean: float
    temperature: float


def watch(walk: Walk, default: float) -> list[Seen]:
    """What the rule sees after each step; the queue is empty at first. default: the temperature outside loops"""
    seen = []
    temperature = default
    for end in range(1, len(walk.states) + 1):
        begin = max(end - LENGTH, 0)
        states, rewards = (list(column[begin:end]) for column in walk)
        if len(states) == LENGTH:
            temperature = new_temperature(
                temperature, states, rewards, states[-1], default
            )
        mean = sum(rewards) / len(rewards)
        seen.append(Seen(redundancy(states), mean, temperature))
    return seen


def first_heat(seen: Sequence[Seen], default: float) -> int:
    """The number, from 0, of the step after which the temperature first rises; the last one if it never does."""
    hot = (t for t, each in enumerate(seen) if each.temperature > default)
    return next(hot, len(seen) - 1)


def plot_watched(walks: Mapping[str, Walk], default: float) -> Picture:
    """Redundancy and mean reward of two robots' queues, with the thresholds of the rule, and where it heats.

    walks: by the robots' names, as many steps of each; default: the temperature outside loops
    """
    seen = {name: watch(walk, default) for name, walk in walks.items()}
    (name, first), *_ = seen.items()
    at = first_heat(first, default)
    figure = Picture(figsize=(8.4, 5.0))
    figure.headline(
        when_it_heats(name, first, default),
        f"of the latest {LENGTH} steps; dotted: the rule's thresholds; ▲: the temperature rises",
    )
    above, below = figure.subplots(2, 1, sharex=True)
    above.set_yscale("log")
    above.set_yticks([1, 2, 5, LENGTH], ["1", "2", "5", str(LENGTH)])
    above.minorticks_off()
    below.set_yscale("symlog", linthresh=0.5)
    below.set_yticks([0, 1, 10], ["0", "1", "10"])
    below.set_ylim(-0.3, 13)
    columns = ("redundancy", "mean")
    for ax, column, threshold in zip((above, below), columns, (2, 0), strict=True):
        ax.axhline(threshold, color="black", linestyle=":")
        curves = {
            robot: [getattr(each, column) for each in of] for robot, of in seen.items()
        }
        hot = {
            robot: [each.temperature > default for each in of]
            for robot, of in seen.items()
        }
        _draw_curves(ax, curves, hot)
    above.set_title("redundancy ρ: a sign of a loop above 2")
    below.set_title("mean reward: a sign of a loop below 0")
    below.set_xlabel("step")
    now = first[at]
    figure.alt = (
        f"Redundancy and mean reward of the queues of two robots over {len(first)} steps. After step {at + 1} the "
        f"{name} robot has {now.redundancy:.1f} and {now.mean:.2f}, and T is {now.temperature:.2f}."
    )
    return figure


def _draw_curves(
    ax: Axes, curves: Mapping[str, Sequence[float]], hot: Mapping[str, Sequence[bool]]
) -> None:
    """The curves of robots by name, with a mark where the temperature rises."""
    ends = []
    for (name, values), (colour, dashes) in zip(curves.items(), LOOKS, strict=True):
        steps = np.arange(1, len(values) + 1)
        ax.plot(steps, values, color=colour, linestyle=dashes)
        at = np.flatnonzero(hot[name])
        ax.plot(steps[at], np.array(values)[at], "^", color=RED, markersize=7, zorder=4)
        ends.append(End(float(values[-1]), plain(name), colour))
    ax.margins(x=0.01)
    name_ends(ax, ends)


def when_it_heats(name: str, seen: Sequence[Seen], default: float) -> str:
    """After which step the temperature first rises, and why, as a sentence. name: of the robot"""
    t = first_heat(seen, default)
    now = seen[t]
    if now.temperature <= default:
        return f"In {len(seen)} steps the temperature of the {name} robot never rises"
    states = round(LENGTH / now.redundancy)
    several = "s" if states > 1 else ""
    return (
        f"Step {t + 1}, {name} robot: {states} state{several} in {LENGTH} steps, and {with_minus(now.mean, 2)} a step: "
        f"the temperature rises to {now.temperature:.4g}"
    )
