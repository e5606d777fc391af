"""The figures of lesson 09: what holds a robot in a loop, and what the way out of it is worth."""

import re
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    Picture,
    chart,
    draw_arrow,
    name_rows,
    plain,
)
from rlrobot_course.play.challenge import Score
from rlrobot_edu.learning.history import History
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import describe
from rlrobot_edu.show.numerals import with_minus
from rlrobot_edu.show.top_down import plot_scene
from rlrobot_edu.widgets.kernels import probabilities

MINUS = re.compile(r"-(?=\d)")  # of a number
TEMPERATURES = np.logspace(
    -2, np.log10(50), 60
)  # from a cold robot to the highest that LRLE sets


def how_often_paid(history: History) -> str:
    """How much a robot earned in its steps up to now, and how seldom it was paid, as a sentence."""
    rewards = history.rewards
    most = rewards.max()
    share = np.mean(rewards == most)
    return (
        f"In its first {len(rewards)} steps the robot earns {with_minus(rewards.mean(), 2)} a step: "
        f"{most:g} in {100 * share:.0f} % of them"
    )


def probability_of_best(x: np.ndarray, temperatures: np.ndarray) -> np.ndarray:
    """With what probability softmax takes the best action; x: preferences, array (A,). Returns as many as T given."""
    return np.array(
        [probabilities(x, temperature).max() for temperature in temperatures]
    )


def plot_rut(scene: Scene, history: History) -> Picture:
    """The robot where it is caught, with its beams and what is near; history: of its learning, up to now"""
    last = history.rewards[-1]
    others = np.flatnonzero(history.rewards != last)
    since = int(others[-1]) + 1 if others.size else 0
    n_steps = len(history.rewards) - since
    picture = Picture((5.2, 5.8), describe(scene))
    picture.headline(
        f"For {n_steps} steps the robot has been here and earned {with_minus(last, 2)} a step",
        "seen from above, with its lasers; white: where it looks",
    )
    ax = picture.subplots()
    plot_scene(scene, ax)
    ax.set_title("")
    (body,) = (solid for solid in scene.solids if solid.name == "robot/body")
    x, y = body.pose[:2, 3]
    left, bottom = max(x - 1.2, scene.bounds[0] - 0.1), y - 1.2
    ax.set(xlim=(left, left + 2.4), ylim=(bottom, bottom + 2.4))
    return picture


def plot_pull(
    q_s: np.ndarray, bias: np.ndarray, labels: Sequence[str], q_max: float
) -> Picture:
    """What holds the robot in one state: Q and bias of its best two actions, and what T makes of it.

    q_s, bias: arrays (A,); labels: names of the actions; q_max: normalises, as in paper equations 10 and 11
    """
    x = (q_s + bias) * 100 / q_max
    best = (-x).argsort(kind="stable")[:2]
    held, other = (MINUS.sub("−", plain(labels[a])) for a in best)
    p = probability_of_best(x, TEMPERATURES)
    (warm,) = probability_of_best(x, np.ones(1))
    figure = Picture(figsize=(8.4, 4.0))
    figure.headline(
        what_holds(q_s, bias, int(best[0]), float(p[0]), float(warm)),
        f"left: Q(s, a), the bias on top of it, and their sum, for the best two of {len(x)} actions; "
        "right: how often the best one is taken",
    )
    pull, curve = figure.subplots(1, 2, width_ratios=(3, 2))
    for row, a in enumerate(best):
        _draw_pull(pull, row, float(q_s[a]), float(bias[a]), BLUE if row == 0 else GREY)
    ends = np.concatenate([[0], q_s[best], (q_s + bias)[best]])
    aside = 0.15 * np.ptp(ends)
    pull.set_xlim(ends.min() - aside, ends.max() + aside)
    pull.axvline(0, color=GREY, linewidth=1, zorder=0)
    pull.set_yticks((0, 1), [held, other])
    pull.set(ylim=(1.6, -0.7), xlabel="value (reward)")
    curve.semilogx(TEMPERATURES, p, color=BLUE)
    curve.plot([TEMPERATURES[0], 1], [p[0], warm], "o", color=BLUE)
    beside = {"textcoords": "offset points", "color": BLUE, "weight": "bold"}
    curve.annotate(f"{p[0]:.2f}", (TEMPERATURES[0], p[0]), (4, -14), **beside)
    curve.annotate(f"{warm:.2f}", (1, warm), (4, 5), **beside)
    curve.axhline(1 / len(x), color=GREY, linestyle=":")
    low = (TEMPERATURES[0], 1 / len(x))
    curve.annotate("pure chance", low, (0, 3), textcoords="offset points")
    curve.set_xticks([0.01, 0.1, 1, 10, 50], ["0.01", "0.1", "1", "10", "50"])
    curve.set(xlabel="temperature T", ylim=(0, 1.08))
    curve.set_title(f"P({held})")
    curve.grid(axis="y")
    told = [f"{labels[a]}: Q {q_s[a]:.2f}, bias {bias[a]:.2f}" for a in best]
    figure.alt = (
        f"Arrows from Q to the sum of Q and bias, of the best two of {len(x)} actions, {'; '.join(told)}. "
        f"A curve: the first is taken with probability {p[0]:.2f} at T = {TEMPERATURES[0]:g}, {warm:.2f} at T = 1 and "
        f"{p[-1]:.2f} at T = 50."
    )
    return figure


def what_holds(
    q_s: np.ndarray, bias: np.ndarray, best: int, cold: float, warm: float
) -> str:
    """What lifts the best action, and what the temperature makes of it, as a sentence. cold, warm: its probabilities"""
    total = with_minus(q_s[best] + bias[best], 2)
    q = with_minus(q_s[best], 2)
    if bias[best] > 0:
        text = f"The bias lifts the best action from {q} to {total}"
    else:
        text = f"The best action is worth {q}, with the bias {total}"
    return f"{text}; cold it is taken in {100 * cold:.0f} %, at T = 1 in {100 * warm:.0f} %"


def _draw_pull(ax: Axes, row: int, q: float, bias: float, colour: str) -> None:
    """Q as a dot, and from there an arrow as long as the bias, to the sum."""
    ax.plot(q, row, "o", color=BLACK, markersize=7)
    ax.text(q, row + 0.16, f"Q\n{with_minus(q, 2)}", ha="center", va="top")
    draw_arrow(ax, (q, row), (q + bias, row), colour, 4)
    look = {"color": colour, "weight": "bold"}
    sign = "+" if bias >= 0 else ""
    text = f"bias {sign}{with_minus(bias, 2)}"
    ax.text(q + bias / 2, row - 0.1, text, ha="center", va="bottom", **look)
    total = f"sum\n{with_minus(q + bias, 2)}"
    ax.text(q + bias, row + 0.16, total, ha="center", va="top", **look)


def plot_worth(pairs: Mapping[str, tuple[Score, Score]]) -> Picture:
    """What robots earn without loop evasion and with it, two means with 95 % intervals for each kind of robot.

    pairs: by the name of a kind, its scores without and with
    """
    figure, ax = chart(
        (7, 4.2),
        "reward a step",
        "",
        who_gains(pairs),
        grid="x",
        note="grey: without loop evasion, blue: with it; dot: mean, line: its 95 % interval",
    )
    for i, (colour, side) in enumerate(((GREY, -0.17), (BLUE, 0.17))):
        for row, both in enumerate(pairs.values()):
            mean, half = both[i]
            y = row + side
            ax.plot([mean - half, mean + half], [y, y], color=colour, linewidth=3)
            ax.plot(mean, y, "o", color=colour, markersize=8)
            text = f"{mean:.2f} {'without' if i == 0 else 'with'}"
            look = {"color": colour, "weight": "bold", "va": "center"}
            ax.text(mean + half + 0.08, y, text, **look)
    name_rows(ax, list(pairs))
    ax.set_xlim(left=0)
    ax.margins(x=0.15, y=0.12)
    told = "; ".join(
        f"{plain(name)}: {both[0]} without, {both[1]} with"
        for name, both in pairs.items()
    )
    figure.alt = f"Reward a step, means with 95 % intervals, without and with loop evasion. {told}."
    return figure


def who_gains(pairs: Mapping[str, tuple[Score, Score]]) -> str:
    """Which kinds of robots gain by loop evasion, by more than the interval of the difference, as a sentence."""
    gains, others = [], []
    for name, (without, evading) in pairs.items():
        # of the rounded means, so that a reader who subtracts finds the same
        gain = round(evading.mean, 2) - round(without.mean, 2)
        half = np.hypot(round(evading.half, 2), round(without.half, 2))
        # without spaces round the sign, so that a line does not end there
        kind = name.replace("\n", ", ").replace(" = ", "=")
        if gain > half:
            gains.append(f"{gain:.2f} for {kind}")
        else:
            others.append(kind)
    text = "Loop evasion adds nothing that shows"
    if gains:
        text = f"Loop evasion adds {' and '.join(gains)}"
        if others:
            text += "; nothing that shows"
    if others:
        text += f" for {' and '.join(others)}"
    return text
