"""Learning curves: the average reward over the steps, of one process or of many repetitions."""

from collections.abc import Iterable, Mapping, Sequence
from typing import overload

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.experiments.runs import Runs, padded
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.history import History
from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.numerals import with_minus
from rlrobot_edu.show.palette import BLACK, CURVES, GREY, Dashes
from rlrobot_edu.show.picture import Picture, axes_or_new, plain

POINTS = 400  # of a curve; a picture shows no more
# The part of the steps in which an average still leaps. The picture may cut it off, so that the rest can be compared.
BEGINNING = 0.02
DOTS = 40  # repetitions; more are too many to be seen one by one

LONGEST_NAME = 24  # characters beside the end of a curve; longer ones need a legend
# Whom the lessons are about: the first of them that is in a picture is its hero, else the best
HEROES = ("yours", "TOSL+QBIASSR", "Q+QBIASSR", "SARSA(λ)")

# Its name, and its repetitions as an array (repetitions, steps), NaN after the end of each
Curve = tuple[str, np.ndarray]
Group = History | Sequence[History]
Names = Sequence[str] | None
Title = str | None

NO_STEPS = (
    "each curve needs a History of at least 1 step, or a list of them; see rl.learn"
)


@overload
def plot_learning(
    *histories: Group, labels: Names = ..., ax: None = ..., title: Title = ...
) -> Picture: ...
@overload
def plot_learning(
    *histories: Group, labels: Names = ..., ax: Axes, title: Title = ...
) -> Axes: ...
@suggests_keywords
def plot_learning(
    *histories: Group, labels: Names = None, ax: Axes | None = None, title: Title = None
) -> Picture | Axes:
    """Plot learning curves: the average reward over the steps.

    Parameters
    ----------
    *histories : History or sequence of History
        A History gives one curve. Several are averaged, up to the step that all of them have; a band shows the 95 %
        interval of the mean. What `repeat` returns, and each value of what `compare` returns, gives its own `curves`:
        in an episodic task those of the last episode.
    labels : sequence of str, optional
        One name for each curve; by default the names of the methods.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; by default those of a new figure.
    title : str, optional
        What the curves show; by default which of them ends ahead.

    Returns
    -------
    Picture or matplotlib.axes.Axes
        The new figure, or `ax` if it was given.

    Raises
    ------
    ValueError
        If a list is empty, a History has no steps, the labels are too few or too many, or `ax` is something else.
    """
    groups = [_group(given) for given in histories]
    if not groups:
        raise ValueError(NO_STEPS)
    if labels is None:
        labels = [group[0].method for group in groups]
    if isinstance(labels, str) or not isinstance(labels, Iterable):
        raise ValueError(f"labels must be a list of names, got {labels!r:.200}")
    labels = [str(label) for label in labels]
    if len(labels) != len(groups):
        raise ValueError(
            f"plot_learning got {len(labels)} labels for {len(groups)} curves"
        )
    curves = [
        (label, _repetitions(group))
        for label, group in zip(labels, groups, strict=True)
    ]
    return plot_curves(curves, steps_of(groups), title, ax)


def _group(given: Group) -> Sequence[History]:
    """The histories behind one curve. Raises ValueError unless each of them has a step."""
    if isinstance(given, Mapping):
        raise ValueError(
            "a comparison draws itself: result.plot(); or give plot_learning the runs of its methods"
        )
    group: Sequence[History] = []
    if isinstance(given, History):
        group = [given]
    elif isinstance(given, Runs):
        group = given
    elif isinstance(given, Iterable):
        group = list(given)
    have_steps = all(isinstance(one, History) and len(one) for one in group)
    if not group or not have_steps:
        raise ValueError(NO_STEPS)
    return group


def _repetitions(group: Sequence[History]) -> np.ndarray:
    """The curves of a group, array (repetitions, steps), NaN after the end of each."""
    if isinstance(group, Runs):
        return group.curves
    return padded([history.average_reward for history in group])


def steps_of(groups: Iterable[Sequence[History]]) -> str:
    """What the x axis counts, in words."""
    for group in groups:
        if isinstance(group, Runs) and group[0].size.episode_steps is not None:
            return "step of the last episode"
    return "step"


def plot_curves(
    curves: list[Curve],
    x: str,
    title: Title,
    ax: Axes | None,
    optimum: float | None = None,
    place: str = "",
) -> Picture | Axes:
    """Plot curves over `x`, and as a line the best average reward that can be achieved, if it is known.

    title: by default what was found; place: the world in which they learned
    """
    curves = [(name, _whole(repetitions)) for name, repetitions in curves]
    ax, shown = axes_or_new(ax, _in_words(curves, optimum))
    title = title or finding(curves)
    if isinstance(shown, Picture):
        shown.headline(title, _note(curves, place))
        ax.set(xlabel=x)
    else:
        ax.set(xlabel=x, ylabel="average reward per step", title=plain(title))
    kept: list[float] = []  # the values that must stay in the picture
    ends: list[End] = []
    means = [float(repetitions[:, -1].mean()) for _, repetitions in curves]
    looks = _looks([name for name, _ in curves], means)
    for curve, (colour, dashes) in zip(curves, looks, strict=True):
        kept += _draw(ax, curve, colour, dashes)
        name, repetitions = curve
        mean = repetitions[:, -1].mean()
        ends.append(End(float(mean), f"{name}\n{with_minus(mean, 2)}", colour))
        if isinstance(shown, Picture) and 1 < len(repetitions) <= DOTS:
            _dot(ax, repetitions, colour)
            kept += repetitions[:, -1].tolist()
    if optimum is not None:
        label = f"best achievable: {optimum:.2f}"
        ax.axhline(optimum, color=BLACK, linewidth=1, label=label)
        ends.append(End(optimum, f"best achievable\n{optimum:.2f}", BLACK))
        kept.append(optimum)
    if np.ptp(ax.dataLim.intervaly) > 1.5 * np.ptp(kept):
        ax.dataLim.intervaly = min(kept), max(kept)
    ax.grid(axis="y")
    ax.margins(x=0)
    longest = max(len(name) for name, _ in curves)
    if isinstance(shown, Picture) and longest <= LONGEST_NAME:
        name_ends(ax, ends)
    elif isinstance(shown, Picture):
        shown.legend(loc="outside lower center")
    else:
        ax.legend()
    return shown


def finding(curves: list[Curve]) -> str:
    """What the ends of some curves say: which is ahead, or that they are too close to tell."""
    ends = {name: repetitions[:, -1] for name, repetitions in curves}
    means = {name: values.mean() for name, values in ends.items()}
    best, *others = sorted(means, key=means.__getitem__, reverse=True)
    said = best
    if best[:1].isascii():  # an ε stays as it is
        said = best[:1].upper() + best[1:]
    mean = with_minus(means[best], 2)
    if not others:
        return f"{said} earns {mean} a step"
    if min(map(len, ends.values())) < 2:
        return f"{said} earns most in this run: {mean} a step"
    lowest, _ = mean_band(ends[best][:, None])
    highest = max(float(mean_band(ends[name][:, None])[1][0]) for name in others)
    if lowest[0] > highest:
        second = with_minus(means[others[0]], 2)
        return f"{said} earns most: {mean} a step, {second} the next"
    least = with_minus(means[others[-1]], 2)
    return f"Too close to tell which is best: {least} to {mean} a step"


def _looks(names: Sequence[str], means: Sequence[float]) -> list[tuple[str, Dashes]]:
    """Colour and dashes of each curve: the hero is blue, and grey is the only one with which it is compared.

    names: those of the curves; several may be the same
    means: at the end of each curve; the curve with the highest is the hero if none of the `HEROES` is there
    """
    known = [name for name in HEROES if name in names]
    hero = names.index(known[0]) if known else int(np.argmax(means))
    if len(names) == 2:
        return [CURVES[0] if i == hero else (GREY, "--") for i in range(2)]
    others = [i for i in range(len(names)) if i != hero]
    places = [hero, *others]
    return [CURVES[places.index(i) % len(CURVES)] for i in range(len(names))]


def _note(curves: list[Curve], place: str) -> str:
    """What is plotted, in grey below the headline."""
    numbers = sorted({len(repetitions) for _, repetitions in curves})
    note = "average reward a step so far"
    if place:
        note = f"{place}: {note}"
    if numbers == [1]:
        return note
    how_many = " or ".join(map(str, numbers))
    note += f"; line: mean of {how_many} repetitions, band: its 95 % interval"
    if numbers[-1] <= DOTS:
        note += ", dots: the repetitions"
    return note


def _whole(repetitions: np.ndarray) -> np.ndarray:
    """The steps that all repetitions have, array (repetitions, fewer steps)."""
    is_missing = np.isnan(repetitions).any(axis=0)
    return repetitions[:, ~is_missing]


def _in_words(curves: list[Curve], optimum: float | None) -> str:
    """The picture's sentence for readers who cannot see it."""
    ends = []
    for name, repetitions in curves:
        ends.append(f"{name} ends at {repetitions[:, -1].mean():.2f}")
    if optimum is not None:
        ends.append(f"the best achievable is {optimum:.2f}")
    _, first = curves[0]
    n_steps = first.shape[1]
    return f"Learning curves, average reward over {n_steps} steps. {'; '.join(ends)}."


def _draw(ax: Axes, curve: Curve, colour: str, dashes: Dashes) -> list[float]:
    """Draw a curve, with a band if it has repetitions. Returns its values after the BEGINNING."""
    name, repetitions = curve
    n, length = repetitions.shape
    steps = np.unique(np.linspace(1, length, min(POINTS, length)).astype(int))
    repetitions = repetitions[:, steps - 1]
    mean = repetitions.mean(axis=0)
    low, high = mean, mean
    if n > 1:
        low, high = mean_band(repetitions)
        ax.fill_between(steps, low, high, color=colour, alpha=0.2, linewidth=0)
        all_alike = not np.ptp(repetitions, axis=0).any()
        alike = ", all alike" if all_alike else ""
        name = f"{name} ({n} repetitions{alike})"
    label = plain(name)
    ax.plot(steps, mean, color=colour, linestyle=dashes, linewidth=2.2, label=label)
    is_later = steps > BEGINNING * length
    return [*low[is_later].tolist(), *high[is_later].tolist()]


def _dot(ax: Axes, repetitions: np.ndarray, colour: str) -> None:
    """A dot for each repetition, at its end."""
    n, length = repetitions.shape
    (dots,) = ax.plot(np.full(n, length), repetitions[:, -1], "o", color=colour)
    dots.set(markersize=4, alpha=0.6, clip_on=False, zorder=3, in_layout=False)
