"""What a model of some rows does not know, on one page: where the robot was, what was tried, what is held back."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from rlrobot_course.figures.plots import (
    BLUE,
    GREY,
    ROLE,
    Picture,
    centred,
    name_rows,
)
from rlrobot_edu import Recording, SampleModel, make_env
from rlrobot_edu.models.diagnosis import Diagnosis
from rlrobot_edu.models.held_back import HeldBack
from rlrobot_edu.show.describe import robot_of
from rlrobot_edu.show.top_down import footprint


def not_known_finding(diagnosis: Diagnosis, held: HeldBack) -> str:
    """What is missing in the rows, and what the held-back ones say."""
    never = diagnosis.n_pairs - diagnosis.pairs_seen
    seen = f"{never} of {diagnosis.n_pairs} pairs were never tried"
    if held.guessed_from_two - held.guessed > held.gained_by_chance:
        return f"{seen}; the step before tells more than the state"
    loops = len(diagnosis.loops)
    if loops:
        word = "suspect loop rests" if loops == 1 else "suspect loops rest"
        return f"{seen}; {loops} {word} on a few rows"
    return f"{seen}; nothing else is shown to be wrong"


def plot_not_known(rows: Recording) -> Picture:
    """A map of the robot's way, and shares that say how far a model of these rows can be believed."""
    diagnosis = SampleModel.from_recording(rows).diagnose()
    held = SampleModel.hold_back(rows)
    figure = Picture(figsize=(8.6, 3.9))
    note = f"left: where it was in {len(rows)} steps; right: shares in %, in numbers beside the bars"
    figure.headline(not_known_finding(diagnosis, held), note)
    left, right = figure.subplots(1, 2, width_ratios=(2, 3))
    told = _draw_map(left, rows)

    new = held.rows - held.new_rows
    shares = {
        "pairs tried": (diagnosis.pairs_seen, diagnosis.n_pairs),
        "of these once": (diagnosis.pairs_seen_once, diagnosis.pairs_seen),
        "last fifth: known pairs": (new, held.rows),
    }
    texts = {name: f"{part} of {whole}" for name, (part, whole) in shares.items()}
    widths = {name: 100 * part / whole for name, (part, whole) in shares.items()}
    guesses = {
        "next guessed": held.guessed,
        "… from two steps": held.guessed_from_two,
    }
    for name, guess in guesses.items():
        widths[name] = 100 * np.nan_to_num(guess)
        texts[name] = "unknown" if np.isnan(guess) else f"{guess:.0%}"
    for row, (name, width) in enumerate(widths.items()):
        colour = GREY if name == "of these once" else BLUE
        right.barh(row, width, 0.6, color=colour)
        right.text(width + 2, row, texts[name], va="center")
    name_rows(right, [*widths, "suspect loops"])
    last = len(widths)
    right.text(0, last, f" {_loops(diagnosis)}", va="center")
    right.set(xlim=(0, 130), xticks=[])
    right.set_ylim(last + 0.5, -0.5)
    right.spines["bottom"].set_visible(False)
    right.tick_params(length=0)
    said = [f"{name}: {text}" for name, text in texts.items()]
    figure.alt = (
        f"{told} {'; '.join(said)}; suspect loops: {_loops(diagnosis)}. {held.verdict}"
    )
    return figure


def _loops(diagnosis: Diagnosis) -> str:
    if not diagnosis.loops:
        return "none found, which is no proof"
    first = diagnosis.loops[0]
    paid = f"{first.reward:.3g}".replace("-", "−")
    rows = "1 row" if first.samples == 1 else f"{first.samples} rows"
    return f"{len(diagnosis.loops)}; the first pays {paid} for ever, from {rows}"


def places(rows: Recording) -> list[np.ndarray]:
    """The positions in each episode, arrays (n + 1, 2) [m], found by driving it again in the task's simulator.

    None if the simulator comes to other states: then the rows are not from there.
    """
    assert rows.task is not None  # rows of a task, see `my_rows`
    begins = np.flatnonzero(rows.step == 0)[1:]
    ways = []
    with make_env(rows.task, seed=0) as env:
        for episode in np.split(np.arange(len(rows)), begins):
            _, seen = env.reset()
            way = [seen["readings"]]
            for row in episode:
                *_, seen = env.step(int(rows.a[row]))
                if seen["state"] != rows.s_next[row]:
                    return []
                way.append(seen["readings"])
            if "x" not in way[0] or "y" not in way[0]:
                return []
            ways.append(np.array([(place["x"], place["y"]) for place in way]))
    return ways


def _draw_map(ax: Axes, rows: Recording) -> str:
    """Walls and way from above; returns in words what is seen."""
    ways = places(rows)
    ax.set_axis_off()
    if not ways:
        centred(ax, 0.5, 0.5, "no map: these rows do not\ntell where the robot was")
        return "No map, for the rows do not tell where the robot was."
    assert rows.task is not None
    with make_env(rows.task, seed=0) as env:
        env.reset()
        solids = robot_of(env).scene().solids
    for solid in solids:
        if solid.role == "wall":
            ax.add_patch(Polygon(footprint(solid), color=ROLE["wall"]))
    for way in ways:
        ax.plot(*way.T, color=BLUE, linewidth=1, alpha=0.6)
    ax.plot(*ways[0][0], "o", color=BLUE, markersize=8)
    ax.annotate("start", ways[0][0], (6, 6), textcoords="offset points", weight="bold")
    ax.set_aspect("equal")
    ax.margins(0.02)
    there = np.concatenate(ways)
    width, height = np.ptp(there, axis=0)
    return f"A map: the robot was in a part of {width:.1f} by {height:.1f} metres."
