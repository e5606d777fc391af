"""What asking is worth in states that are new, as a table of docs/when_similarity_helps.md."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rlrobot_edu.widgets.stage.honest import IDEAL, shows

Numbers = Mapping[str, Any]
HEAD = [
    "similar states known",
    "new states",
    "chance of the favourite",
    "a step that pays: by lot → asked",
    "a bump: by lot → asked",
]
IN_WORDS = {"0": "none", "all": "**all**"}


def asked_table(numbers: Numbers) -> list[list[str]]:
    """A row for each number of similar states that are known, the last for all."""
    rows = []
    for known, its in numbers[IDEAL]["advice"].items():
        rows.append(
            [
                IN_WORDS.get(known, known),
                f"{its['moments']:,}",
                f"{100 * its['chance']:.0f} %",
                risen(its["pays"], 1),
                risen(its["bumps"], 2),
            ]
        )
    return rows


def risen(its: Numbers, decimals: int) -> str:
    """``18.3 → 26.7 % (+8.2 ± 0.5)``: chances, and the rise in points if it shows."""
    change = f"{100 * its['lot']:.1f} → {100 * its['asked']:.1f} %"
    if not shows(its["more"]):
        return change
    mean, half = 100 * its["more"]["mean"], 100 * its["more"]["half"]
    sign = "+" if mean > 0 else "−"
    return f"{change} ({sign}{abs(mean):.{decimals}f} ± {half:.{decimals}f})"
