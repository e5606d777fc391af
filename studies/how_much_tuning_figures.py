"""The four pictures of docs/studies/how_much_tuning.md; each title is a finding, made from the data."""

from __future__ import annotations

import numpy as np
from how_much_tuning import METHODS, OURS
from how_much_tuning_numbers import Price, plainly, price, signed
from how_much_tuning_tests import SR, Draws, Finding, Part
from how_much_tuning_worlds import settings_of

from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.map_of_settings import plot_settings
from rlrobot_edu.show.palette import BLUE, GREEN, GREY, RED
from rlrobot_edu.show.picture import Picture

LOOK = {  # colour, dashes and mark of each method
    OURS: (BLUE, "-", "o"), SR: (RED, "--", "s"),
    "Q+SR": (GREY, ":", "^"), "Q+QBIASSR": (GREEN, "-.", "D"),
}  # fmt: skip


def headed(picture: Picture, title: str, below: str) -> Picture:
    """The picture with its finding, and below in grey what is plotted."""
    picture.headline(title, below)
    picture.alt = f"{title}. {below}"
    return picture


def map_title(h6: Finding, sr: Part, ours: Part) -> str:
    """Whether the bias sets wandering and arms against each other."""
    numbers = f"rank correlation {signed(ours.estimate)} with QBIASSR, {signed(sr.estimate)} with SR"
    return {
        "holds": f"With the bias, settings that suit wandering suit arms less: {numbers}",
        "not shown": f"That the bias sets wandering against arms is not shown: {numbers}",
        "the opposite holds": f"With the bias, settings that suit wandering suit arms more: {numbers}",
    }[h6.verdict]


def plot_maps(draws: Draws, h6: Finding) -> Picture:
    """Score over T and α for each task, with the bias and without; the paper's setting as a cross."""
    study = draws.study
    tasks = study.plan["tasks"]
    paper = study.plan["paper's setting"]
    picture = Picture((13, 5.2))
    axes = picture.subplots(2, len(tasks), sharex=True, sharey=True)
    for row, method in zip(axes, (SR, OURS), strict=True):
        for ax, task in zip(row, tasks, strict=True):
            means = np.asarray(
                study.scored(task, study.swept(task, method).mean(axis=1))
            )
            look = {"vmin": 0, "vmax": 1, "s": 26, "linewidths": 0.2}
            dots = plot_settings(ax, settings_of(study.plan), means, **look)
            cross = [paper["temperature"]], [paper["alpha"]], "x"
            ax.plot(*cross, color="white", markersize=11, markeredgewidth=4)
            ax.plot(*cross, color=RED, markersize=10, markeredgewidth=2)
            ax.set(xlabel="", ylabel="")
            if method == SR:
                ax.set_title(task, fontsize=11)
        row[0].set_ylabel(f"{method}\nα")
    for ax in axes[1]:
        ax.set_xlabel("T")
    picture.colorbar(dots, ax=axes, label="score", shrink=0.8)
    title = map_title(h6, *(draws.rank_correlation(method) for method in (SR, OURS)))
    n, robots = study.plan["sizes"]["settings"], study.plan["sizes"]["robots"]
    below = (
        f"Each dot is one of {n} settings, mean of {robots} robots. 0: random actions, 1: the best winner of all"
        " methods. Red cross: the paper's setting."
    )
    return headed(picture, title, below)


def price_title(its: Price, paper: Part) -> str:
    """How many random tries are worth more than the paper's setting, by intervals that do not overlap."""
    tries = its.worth(paper.interval[1])
    if tries is None:
        return f"No number of random tries up to {its.tries[-1]} is shown to beat the paper's setting of {OURS}"
    if tries == 1:
        return f"One random setting of {OURS} scores more than the paper's, on average"
    words = {2: "two", 4: "four", 8: "eight"}
    return f"The best of {words.get(tries, tries)} random settings of {OURS} beats the paper's setting"


def plot_price(draws: Draws) -> Picture:
    """The best of k random settings, by method."""
    picture = Picture((9, 4.8))
    ax = picture.subplots()
    curves = {method: price(draws.study, method) for method in METHODS}
    for method, its in curves.items():
        colour, dashes, mark = LOOK[method]
        ax.fill_between(its.tries, its.low, its.high, color=colour, alpha=0.15, lw=0)
        ax.plot(its.tries, its.estimate, color=colour, linestyle=dashes, marker=mark, markersize=4)  # fmt: skip
    ends = [
        End(its.estimate[-1], method, LOOK[method][0]) for method, its in curves.items()
    ]
    of_paper = draws.over_tasks(OURS, "paper's")
    paper = of_paper.estimate
    ax.axhline(paper, color=BLUE, lw=1)
    ends.append(End(paper, "the paper's setting\nof TOSL+QBIASSR", BLUE))
    ax.set_xscale("log", base=2)
    ax.set_xticks(its.tries, [str(k) for k in its.tries])
    ax.set(xlabel="random settings tried")
    ax.grid(axis="y")
    below = (
        "Score of the best, mean of six tasks; half of the robots choose the best, the others judge it. Bands: 95 %"
        " intervals."
    )
    headed(picture, price_title(curves[OURS], of_paper), below)
    name_ends(ax, ends)
    return picture


def regret_title(h3: Finding, ours: Part, sr: Part) -> str:
    """Whether the bias makes the paper's setting lose less."""
    numbers = f"{ours.estimate:.2f} against {sr.estimate:.2f}"
    return {
        "holds": f"By the paper's setting the method with the bias loses less: {numbers}",
        "not shown": f"That the bias lets the paper's setting lose less is not shown: {numbers}",
        "the opposite holds": f"By the paper's setting the method with the bias loses more: {numbers}",
    }[h3.verdict]


def plot_regret(draws: Draws, h3: Finding) -> Picture:
    """What each method loses by a setting that was not tuned for the task."""
    picture = Picture((9, 4.4))
    ax = picture.subplots()
    kinds = {"paper's": ("the paper's setting", "o"), "others'": ("tuned on the five other tasks", "s"),
             "common": ("tuned on all six", "^")}  # fmt: skip
    for k, (kind, (label, mark)) in enumerate(kinds.items()):
        for i, method in enumerate(METHODS):
            its = draws.regret(method, kind)
            colour = BLUE if method == OURS else GREY
            y = i + 0.22 * (k - 1)
            ax.plot(its.interval, [y, y], color=colour, lw=1.5)
            ax.plot(its.estimate, y, mark, color=colour, markersize=7)
            if i == 0:
                ax.text(its.interval[1] + 0.006, y, label, color="#555555", va="center", fontsize=9)  # fmt: skip
    ax.set_yticks(range(len(METHODS)), METHODS)
    ax.invert_yaxis()
    ax.axvline(0, color=GREY, lw=0.8)
    ax.set_xlabel("score lost to the setting tuned for each task")
    ax.spines[["top", "right"]].set_visible(False)
    below = "Mean of six tasks, judged by new robots; 95 % intervals."
    title = regret_title(h3, *(draws.regret(method, "paper's") for method in (OURS, SR)))  # fmt: skip
    return headed(picture, title, below)


def friction_title(friction: Part, ideal: Part) -> str:
    """Whether traces alone gain something with friction and lag, and on an ideal robot; by their intervals."""
    numbers = f"{signed(friction.estimate)} and {signed(ideal.estimate)} a step"
    if friction.interval[0] > 0 > ideal.interval[1]:
        return (
            f"Traces pay with friction and lag, and cost on an ideal robot: {numbers}"
        )
    if friction.interval[0] > 0:
        return f"Traces pay with friction and lag, and are not shown to cost without: {numbers}"
    return f"That traces pay with friction and lag is not shown: {numbers}"


def plot_friction(draws: Draws) -> Picture:
    """What bias, traces and both gain over Q+SR, with friction and lag and without."""
    picture = Picture((9, 3.8))
    names = ("bias alone", "traces alone", "both")
    titles = {"friction": "friction and lag", "wander_1k": "ideal robot"}
    axes = picture.subplots(1, 2, sharex=True, sharey=True)
    for ax, (world, title) in zip(axes, titles.items(), strict=True):
        found = draws.effects(world)
        for y, name in enumerate(names):
            its = found[name]
            colour = BLUE if name == "both" else GREY
            ax.plot(its.interval, [y, y], color=colour, lw=2)
            ax.plot(its.estimate, y, "o", color=colour, markersize=8)
            ax.text(its.estimate, y - 0.16, signed(its.estimate), color=colour, ha="center")  # fmt: skip
        ax.axvline(0, color=GREY, lw=0.8)
        ax.set_title(f"{title}: Q+SR earns {plainly(found['Q+SR'])}", fontsize=10.5)
        ax.set_xlabel("gain over Q+SR, reward a step")
        ax.spines[["top", "right"]].set_visible(False)
    axes[0].set_yticks(range(len(names)), ["bias (Q+QBIASSR)", "traces (TOSL+SR)", "both (TOSL+QBIASSR)"])  # fmt: skip
    axes[0].set_ylim(2.5, -0.6)
    n, robots = (draws.sizes[f"friction {what}"] for what in ("settings", "robots"))
    others = draws.sizes["robots"]
    below = (
        f"wander_1k, mean of {n} random settings, {robots} robots each with friction and lag, {others} on the ideal"
        " robot; 95 % intervals."
    )
    traces = [draws.effects(world)["traces alone"] for world in titles]
    return headed(picture, friction_title(*traces), below)
