"""The page and the figure of the study of the bias; bias_study.py calls this module."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import numpy as np
from bias_text import PAGE
from bias_verdicts import CONTROLS, PAPERS, Against, Outcome

from rlrobot_edu.files import write_whole
from rlrobot_edu.show.palette import BLACK, BLUE, GREEN, GREY, PURPLE, VERMILION
from rlrobot_edu.show.picture import Picture

BIASED = {
    "QBIASSR": (BLACK, "o"), "VBIASSR": (BLUE, "s"), "OBIASSR": (VERMILION, "v"), "FBIASSR": (GREEN, "D"),
    "TBIASSR": (PURPLE, "^"),
}  # fmt: skip


def write_page(found: Sequence[Outcome], folder: Path) -> Path:
    """Write bias.md and its picture; the text that judges stands in bias_text.py and was written after looking."""
    picture = figure(found)
    write_whole(folder / "pictures" / "bias.png", picture.png())
    page = PAGE.format(
        on_models=counts([o for o in found if o.where == "model"]),
        on_robots=counts([o for o in found if o.where == "robot"]), figure=f"![{picture.alt}](pictures/bias.png)",
        late=means(found, lambda o: o.is_late), early=means(found, lambda o: not o.is_late),
        all_tests=tests(found), missing=missing(found),
    )  # fmt: skip
    write_whole(folder / "bias.md", page)
    return folder / "bias.md"


def table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A table in Markdown."""
    return "\n".join(f"| {' | '.join(map(str, row))} |" for row in (head, ["---"] * len(head), *rows))


def name_of(o: Outcome) -> str:
    """The task, where and how long, in words."""
    return f"{o.where} {o.task}, {o.length}"


def counts(found: Sequence[Outcome]) -> str:
    """How often each biased selection was significantly better and worse than each softmax regression, and than all."""
    rows = []
    for biased in BIASED if found else ():
        signs = np.array([[o.against[biased, control].sign for control in CONTROLS] for o in found])
        cells = [f"{(column > 0).sum()} / {(column < 0).sum()}" for column in signs.T]
        cells.append(f"{(signs > 0).all(axis=1).sum()} / {(signs < 0).all(axis=1).sum()}")
        papers = np.array([o.against[biased, PAPERS].sign for o in found if biased != PAPERS])
        cells.append(f"{(papers > 0).sum()} / {(papers < 0).sum()}" if len(papers) else "")
        rows.append([biased, *cells])
    return table(["better / worse than", *CONTROLS, "all three", PAPERS], rows)


def means(found: Sequence[Outcome], which: Callable[[Outcome], bool]) -> str:
    """Means by task; a biased one has ▲ where it is better than all three softmax regressions, ▼ where worse."""
    labels, rows = list(dict.fromkeys(label for o in found for label in o.means)), []
    for o in in_order(filter(which, found)):
        cells = []
        for label in labels:
            if (mean := o.means.get(label)) is None:
                cells.append("")
                continue
            signs = [o.against[label, control].sign for control in CONTROLS] if label in BIASED else [0]
            cells.append(f"{mean:.2f}" + (" ▲" if min(signs) > 0 else " ▼" if max(signs) < 0 else ""))
        rows.append([name_of(o), o.n_states, *cells])
    return table(["task", "states", *labels], rows)


def tests(found: Sequence[Outcome]) -> str:
    """Hedges' g of each biased selection against each softmax regression; bold where Dunnett's p is below 0.05."""
    rows = []
    for o in in_order(found):
        for control in (*CONTROLS, PAPERS):
            against = [o.against.get((biased, control)) for biased in BIASED]
            cells = [_cell(a) if a else "" for a in against]
            rows.append([name_of(o) if control == CONTROLS[0] else "", control, *cells])
    return table(["task", "against", *BIASED], rows)


def _cell(a: Against) -> str:
    """Hedges' g, bold and with p where it is significant."""
    return f"**{a.g.value:.2f}** (p {'< 1e-15' if a.p < 1e-15 else f'{a.p:.0e}'})" if a.sign else f"{a.g.value:.2f}"


def missing(found: Sequence[Outcome]) -> str:
    """Which tasks were not run where, as items of a list."""
    said = []
    for where, plural in (("robot", "robots"), ("model", "sample models")):
        left = sorted({o.task for o in found} - {o.task for o in found if o.where == where})
        said += [f"- On the {plural} these have not been run yet: {', '.join(left)}.\n"] if left else []
    return "".join(said)


def in_order(found: Iterable[Outcome]) -> list[Outcome]:
    """Models, then robots; small tasks first."""
    return sorted(found, key=lambda o: (o.where, o.n_states, o.task, o.is_late))


def figure(found: Sequence[Outcome]) -> Picture:
    """Hedges' g against SR (T = 1) of every biased selection with its 95 % interval, early and late."""
    halves = [
        sorted((o for o in found if o.is_late == late), key=lambda o: (o.where, o.n_states, o.task)) for late in (0, 1)
    ]
    picture = Picture((11, 1.5 + 0.55 * len(halves[0])))
    y = np.arange(len(halves[0]), dtype=float)
    for number, (ax, outcomes) in enumerate(zip(picture.subplots(1, 2, sharey=True), halves, strict=True)):
        for i, (biased, (colour, marker)) in enumerate(BIASED.items()):
            g = np.array([o.against[biased, CONTROLS[0]].g for o in outcomes])
            ax.errorbar(
                g[:, 0], y + 0.16 * (i - 2), xerr=np.abs(g[:, 1:] - g[:, :1]).T, fmt=marker, color=colour, markersize=5,
                linewidth=1, label=None if number else biased,
            )  # fmt: skip
        ax.plot(
            [_half(o) for o in outcomes], y, "|", color=GREY, markersize=24, markeredgewidth=2,
            label=None if number else "SR at T = 1/2",
        )  # fmt: skip
        ax.axvline(0, color=GREY, linewidth=1)
        ax.set(title=("early", "late")[number], xlabel="Hedges' g against SR (right: better)")
        ax.grid(axis="x", alpha=0.3)
    ax.set_yticks(y, [f"{o.where} {o.task}\n{early.length}; {o.length}" for early, o in zip(*halves, strict=True)])
    ax.invert_yaxis()
    picture.legend(loc="outside lower center", ncols=6)
    picture.alt = "Effect of each biased selection against SR, with 95 % intervals. " + " ".join(
        f"{name_of(o)}: " + ", ".join(f"{b} {o.against[b, CONTROLS[0]].g.value:.1f}" for b in BIASED) + "."
        for o in halves[1]
    )
    return picture


def _half(o: Outcome) -> float:
    """How far SR at T = 1/2 lies from SR at T = 1, in their SDs."""
    spread = np.sqrt((o.spreads["SR"] ** 2 + o.spreads["SR, half"] ** 2) / 2)
    return (o.means["SR, half"] - o.means["SR"]) / spread
