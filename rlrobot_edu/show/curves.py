"""Learning curves: the average reward over the steps, of one process or of many repetitions."""

from collections.abc import Iterable, Mapping, Sequence
from typing import overload

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.experiments.runs import Runs, padded
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.learning.history import History
from rlrobot_edu.show.palette import BLACK, CURVES
from rlrobot_edu.show.picture import Picture, axes_or_new, plain

POINTS = 400  # of a curve; a picture shows no more
START = 0.02  # part of the steps in which an average leaps, and which may leave the picture for the sake of the others

Curve = tuple[
    str, np.ndarray
]  # its name, and array (repetitions, steps), with NaN after an end
Group = History | Sequence[History]
Names = Sequence[str] | None
Title = str | None


@overload
def plot_learning(
    *histories: Group, labels: Names = ..., ax: None = ..., title: Title = ...
) -> Picture: ...
@overload
def plot_learning(
    *histories: Group, labels: Names = ..., ax: Axes, title: Title = ...
) -> Axes: ...
def plot_learning(
    *histories: Group, labels: Names = None, ax: Axes | None = None, title: Title = None
) -> Picture | Axes:
    """Learning curves, average reward over steps.

    Parameters
    ----------
    *histories : History or sequence of History
        A History gives one curve; several are averaged, with the 95 % interval of the mean as a band, up to the
        step that all of them have. What `repeat` or `compare` returns gives its own `curves`: in an episodic task those
        of the last episode.
    labels : sequence of str, optional
        One name a curve; by default the methods' names.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; None makes a figure of its own.
    title : str, optional
        What the curves show.

    Returns
    -------
    Picture or matplotlib.axes.Axes
        The figure, or `ax` where one was given.

    Raises
    ------
    ValueError
        For an empty list, a History without steps, too few or too many labels, or an `ax` that is something else.
    """
    if any(isinstance(h, Mapping) for h in histories):
        raise ValueError(
            "a comparison draws itself: result.plot(); or give plot_learning the runs of its methods"
        )
    groups = [
        [h] if isinstance(h, History) else h if isinstance(h, Runs) else list(h)
        for h in histories
    ]
    drawn = [h for group in groups for h in group]
    if (
        not groups
        or not all(groups)
        or not all(isinstance(h, History) and len(h) for h in drawn)
    ):
        raise ValueError(
            "each curve needs a History of at least 1 step, or a list of them; see rl.learn"
        )
    if labels is not None and len(labels) != len(groups):
        raise ValueError(
            f"plot_learning got {len(labels)} labels for {len(groups)} curves"
        )
    names = labels if labels is not None else [group[0].method for group in groups]
    every = [
        g.curves if isinstance(g, Runs) else padded([h.average_reward for h in g])
        for g in groups
    ]
    title = title or "How the average reward develops"
    return plot_curves([*zip(names, every, strict=True)], steps_of(groups), title, ax)


def steps_of(groups: Iterable[Sequence[History]]) -> str:
    """What the curves of these groups are drawn over, in words."""
    in_episode = any(
        isinstance(group, Runs) and group[0].size.episode_steps is not None
        for group in groups
    )
    return "step of the last episode" if in_episode else "step"


def plot_curves(
    curves: list[Curve],
    x: str,
    title: str,
    ax: Axes | None,
    optimum: float | None = None,
) -> Picture | Axes:
    """The same for curves at hand, over `x`; the best achievable, if it is known, as a line."""
    curves = [
        (name, repetitions[:, ~np.isnan(repetitions).any(axis=0)])
        for name, repetitions in curves
    ]
    ends = [
        f"{name} ends at {repetitions[:, -1].mean():.2f}"
        for name, repetitions in curves
    ]
    ends += [] if optimum is None else [f"the best achievable is {optimum:.2f}"]
    alt = f"Learning curves, average reward over {curves[0][1].shape[1]} steps. {'; '.join(ends)}."
    ax, shown = axes_or_new(ax, alt)
    later = [] if optimum is None else [optimum]
    for i, (name, repetitions) in enumerate(curves):
        (n, length), (colour, dashes) = repetitions.shape, CURVES[i % len(CURVES)]
        steps = np.unique(np.linspace(1, length, min(POINTS, length)).astype(int))
        repetitions = repetitions[:, steps - 1]
        mean = repetitions.mean(axis=0)
        band = mean_band(repetitions) if n > 1 else (mean, mean)
        later += np.array(band)[:, steps > START * length].ravel().tolist()
        if n > 1:
            ax.fill_between(steps, *band, color=colour, alpha=0.2, linewidth=0)
            name += f" ({n} repetitions{', all alike' * (not np.ptp(repetitions, axis=0).any())})"
        ax.plot(
            steps,
            mean,
            color=colour,
            linestyle=dashes,
            linewidth=1.8,
            label=plain(name),
        )
    if optimum is not None:
        ax.axhline(
            optimum, color=BLACK, linewidth=1, label=f"best achievable: {optimum:.2f}"
        )
    if np.ptp(ax.dataLim.intervaly) > 1.5 * np.ptp(later):
        ax.dataLim.intervaly = min(later), max(later)
    ax.set(xlabel=x, ylabel="average reward per step", title=plain(title))
    ax.grid(alpha=0.3)
    ax.margins(x=0)
    note = (
        "means, and bands of their 95 % intervals"
        if any(len(each) > 1 for _, each in curves)
        else None
    )
    if shown is ax:
        ax.legend(title=note)
    else:  # below the axes, where it hides no curve
        columns = 2 if max(len(name) for name, _ in curves) <= 20 else 1
        shown.legend(title=note, loc="outside lower center", ncols=columns)
    return shown
