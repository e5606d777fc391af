"""The tables, figures and verdicts of docs/studies/a_better_bias.md; better_bias.py calls this module."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import cycle
from pathlib import Path

import numpy as np
from better_bias import REGISTERED
from better_bias_tests import (
    OURS,
    Difference,
    Found,
    difference,
    family,
    never_hurts,
    pays_no_circle,
    relatives,
    rules,
    wheels,
)
from better_bias_text import PAGE
from matplotlib.axes import Axes
from scipy import stats

from rlrobot_course.figures.plots import name_rows
from rlrobot_edu.files import write_whole
from rlrobot_edu.show.palette import BLUE, GREY, LIGHT, RED
from rlrobot_edu.show.picture import Picture

DOCS = Path(__file__).parent.parent / "docs"
METHODS = ("SR", "QBIASSR", OURS, "LINEAR", "COUNT", "coarse", "blind")
WITHOUT_RIVALS = ("SR", "QBIASSR", OURS, "blind")
FAMILIES = REGISTERED["families"]
NO_CIRCLE, OTHERS, CHANGED = FAMILIES


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in Markdown."""
    return "\n".join(
        f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *rows)
    )


def told(values: Sequence[float]) -> str:
    """Mean and half of its 95 % interval (Student's t)."""
    return f"{np.mean(values):.2f} ± {stats.t.ppf(0.975, len(values) - 1) * stats.sem(values):.2f}"


def means(found: Found, worlds: Sequence[str], labels: Sequence[str]) -> str:
    """A line for each world, at T = 1."""
    rows = [
        [world, *(told(found[world][label]) for label in labels)] for world in worlds
    ]
    return table(["world", *labels], rows)


def tests(rows: Sequence[Difference], columns: Sequence[str]) -> str:
    """A line for each world, a column for each comparison, as `rows` go: bold where the corrected p shows it."""
    cells = [f"**{in_words(its)}**" if its.sign else in_words(its) for its in rows]
    starts = range(0, len(rows), len(columns))
    return table(
        ["world", *columns],
        [[rows[i].world, *cells[i : i + len(columns)]] for i in starts],
    )


def columns(name: str) -> list[str]:
    """The comparisons of a family, in order."""
    its = FAMILIES[name]
    return [
        *(f"{other}, T = 1" for other in its["at T = 1"]),
        *(f"{other}, best T" for other in its["at best T"]),
    ]


def checks(found: Found) -> str:
    """Where the blind agent earns less than SR, so that a world counts, and where not."""
    worlds = [*FAMILIES[NO_CIRCLE]["worlds"], *FAMILIES[CHANGED]["worlds"]]
    ends = {world: pays_no_circle(found, world) for world in worlds}
    not_shown = [
        f"*{world}* ({in_words(its)})" for world, its in ends.items() if its.high >= 0
    ]
    passed = f"It does in {len(worlds) - len(not_shown)} of {len(worlds)} worlds"
    return (
        f"{passed}; that is not shown in {', '.join(not_shown)}."
        if not_shown
        else f"{passed}."
    )


def rule_says(found: Found) -> str:
    """What the registered rule says of each relative, and of VBIASSR and QBIASSR for comparison."""
    lines = []
    for name in REGISTERED["relatives"]["names"]:
        fails = never_hurts(found, name)
        lines.append(
            f"- {name}: "
            + (
                f"fails in {'; '.join(fails)}."
                if fails
                else "**never hurts**, by the rule."
            )
        )
    return "\n".join(lines).replace("(-", "(−")


def rules_table(found: Found) -> str:
    """TOSL+QBIASSR less SR and less Q+SR by both rules of loop evasion."""
    rows = []
    for pair in rules(found):
        cells = [f"**{in_words(its)}**" if its.sign else in_words(its) for its in pair]
        other = pair.ours.second if pair.ours.second == "Q+SR" else "TOSL+SR"
        rows.append([pair.ours.world, other, *cells, "yes" if pair.decides else "no"])
    head = [
        "world",
        "TOSL+QBIASSR less",
        "ours: loop evasion in all",
        "the program's: in QBIASSR alone",
        "decides",
    ]
    return table(head, rows)


def forest(found: Found) -> Picture:
    """VBIASSR less each other method, in the worlds of the first two families, with 95 % intervals."""
    families = {name: family(found, name) for name in (NO_CIRCLE, OTHERS)}
    title = forest_title([its for rows in families.values() for its in rows])
    picture = Picture((8.4, 9.6))
    picture.headline(
        title,
        f"Reward a step that {OURS} earns more than each other method, 95 % intervals. Blue: significantly more, "
        "red: less, hollow: not significant (corrected).",
    )
    for ax, (name, rows) in zip(picture.subplots(1, 2), families.items(), strict=True):
        _draw_forest(ax, rows, columns(name))
        ax.set_title(name)
    picture.alt = f"{title}. {OURS} less other methods, with 95 % intervals: the numbers of the two tables of tests."
    return picture


def forest_title(rows: Sequence[Difference]) -> str:
    """In how many comparisons VBIASSR earns significantly more, and in how many less."""
    signs = [its.sign for its in rows]
    return (
        f"{OURS} earns significantly more in {signs.count(1)} of {len(signs)} comparisons, and less in"
        f" {signs.count(-1)}"
    )


def _draw_forest(ax: Axes, rows: Sequence[Difference], others: Sequence[str]) -> None:
    """A line for each comparison, below the name of its world."""
    colours = {1: BLUE, -1: RED, 0: LIGHT["faint"]}
    names: list[str] = []
    for i, its in enumerate(rows):
        if i % len(others) == 0:
            names.append(its.world)
            ax.axhline(len(names) - 1.6, color=LIGHT["line"], linewidth=0.8)
        y = len(names)
        names.append(others[i % len(others)])
        colour = colours[its.sign]
        ax.plot([its.low, its.high], [y, y], color=colour, linewidth=1.6)
        fill = colour if its.sign else "white"
        ax.plot(its.mean, y, "o", color=colour, markersize=6, markerfacecolor=fill)
    ax.axvline(0, color=GREY, linewidth=1)
    name_rows(ax, names)
    for label in ax.get_yticklabels()[:: len(others) + 1]:
        label.set(weight="bold", color=LIGHT["ink"])
    ax.grid(axis="x")


def numbers(found: Found) -> dict[str, str]:
    """Every tested difference with its interval, for the prose, by names such as ``wander_1k__QBIASSR__T_1``."""
    rows = {f"{row.world}, {name}": row for key in FAMILIES
            for row, name in zip(family(found, key), cycle(columns(key)), strict=False)}  # fmt: skip
    rows |= {f"{row.world}, {row.first} less {OURS}": row for row in relatives(found)}
    rows |= {f"{row.world}, {OURS} less {row.second}": row for row in wheels(found)}
    return {
        re.sub(r"\W", "_", name.replace(" ", "")): in_words(row)
        for name, row in rows.items()
    }


def in_words(its: Difference) -> str:
    """A difference and its interval."""
    return f"{its.mean:+.2f} [{its.low:+.2f}, {its.high:+.2f}]".replace("-", "−")


def page(found: Found) -> str:
    """The page in Markdown."""
    parts = {}
    for key, name in (("a", NO_CIRCLE), ("b", OTHERS), ("c", CHANGED)):
        parts[f"tests_{key}"] = tests(family(found, name), columns(name))
    return PAGE.format(
        **parts,
        **numbers(found),
        seed=REGISTERED["seed"],
        checks=checks(found),
        means=means(found, FAMILIES[NO_CIRCLE]["worlds"], METHODS),
        forest=f"![{forest(found).alt}](../pictures/better_bias.png)",
        relatives=tests(relatives(found), REGISTERED["relatives"]["names"]),
        rule_says=rule_says(found),
        rules=rules_table(found),
        wheels=means(found, REGISTERED["reproduction"]["wheels"], WITHOUT_RIVALS),
        wheels_tests=tests(wheels(found), ["QBIASSR", "SR", "blind"]),
        giraff_blind=in_words(difference(found, "giraff_wander_1k", OURS, "blind")),
    )


def write_page(found: Found) -> Path:
    """Write the page and its figures; the text that judges stands in better_bias_text.py, written after looking."""
    write_whole(DOCS / "pictures" / "better_bias.png", forest(found).still().data)
    write_whole(DOCS / "studies" / "a_better_bias.md", page(found))
    return DOCS / "studies" / "a_better_bias.md"
