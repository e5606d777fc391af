"""What the stage says of a hundred robots, from the numbers that studies/stage_numbers.py has written."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from typing import Any

from rlrobot_edu.widgets.page_file import read_text

Numbers = Mapping[str, Any]
IDEAL, HELD = "TOSL, ideal", "TOSL, held"  # the two robots of which the page speaks


@cache
def read_numbers() -> dict[str, Any]:
    """The file, see studies/stage_registered.json for what is measured."""
    numbers: dict[str, Any] = json.loads(read_text("stage/numbers.json"))
    return numbers


def shows(more: Numbers) -> int:
    """1 if a difference is above zero with its whole interval, −1 if below, 0 if it holds zero."""
    if more["mean"] - more["half"] > 0:
        return 1
    if more["mean"] + more["half"] < 0:
        return -1
    return 0


def amount(more: Numbers, decimals: int) -> str:
    """A difference without its sign, and half of its interval."""
    mean, half = abs(more["mean"]), more["half"]
    return f"{mean:.{decimals}f} ± {half:.{decimals}f}"


def compared(more: Numbers, words: tuple[str, str, str], decimals: int) -> str:
    """A difference in words. words: for more, for less, and for where none shows."""
    side = shows(more)
    if side > 0:
        return f"{amount(more, decimals)} {words[0]}"
    if side < 0:
        return f"{amount(more, decimals)} {words[1]}"
    sign = "+" if more["mean"] >= 0 else "−"
    return f"{words[2]} ({sign}{amount(more, decimals)})"


def honest(numbers: Numbers) -> str:
    """The line that stands on the page, as HTML."""
    ideal = numbers[IDEAL]
    first, last = numbers["seeds"]
    metres = compared(
        ideal["metres"]["more"],
        ("m further", "m less far", "no farther that would show"),
        0,
    )
    bumps = compared(
        ideal["bumps"]["more"], ("more", "fewer", "no difference shows"), 0
    )
    memories = verdict(ideal["advice"]["all"])
    return (
        f"<b>Typical, not lucky.</b> In {last - first + 1} such hours the one that asks drives {metres}. "
        f"Bumps<span id='bumps'></span>: {bumps}. <b>{memories}</b>"
    )


def verdict(advice: Numbers) -> str:
    """What the memories say, by whether asking raises the chance of a step that pays and lowers that of a bump."""
    drives, bumps = shows(advice["pays"]["more"]), shows(advice["bumps"]["more"])
    if drives > 0 and bumps >= 0:
        return "Its memories say “drive on”; they do not say “beware”."
    if drives > 0:
        return "Its memories say “drive on”, and “beware”."
    if bumps < 0:
        return "Its memories say “beware”; they do not say “drive on”."
    return "Its memories say nothing that shows."


def rule(numbers: Numbers) -> str:
    """How room, seed and moments are chosen, and what asking changes in states that are new, as plain text."""
    first, last = numbers["seeds"]
    ideal, held = numbers[IDEAL], numbers[HELD]
    everywhere = ideal["advice"]["all"]
    reward = compared(
        ideal["reward"]["more"], ("more", "less", "no more that would show"), 1
    )
    bumps = compared(
        held["bumps"]["more"], ("more bumps", "fewer bumps", "no difference shows"), 0
    )

    def risen(name: str, decimals: int) -> str:
        chance = everywhere[name]
        lot, asked = 100 * chance["lot"], 100 * chance["asked"]
        return f"from {lot:.{decimals}f} to {asked:.{decimals}f} %"

    favourite = (
        f"from {100 / numbers['actions']:.0f} to {100 * everywhere['chance']:.0f} %"
    )
    return (
        "Maze, nine commands and parameters are the paper’s (wander_1k, α 0.1, γ 0.9, λ 0.9, T 1); both learn by true "
        "online SARSA(λ) with softmax on the ideal base, one of them with QBIASSR’s bias. "
        f"Seed: of {first} to {last} the one whose difference in metres is nearest to the median of all "
        f"({numbers['shown']}). Moment: of all at which the right robot stood in a new state and then did what its "
        "memories favour, the one with the most advisers (a say of 0.1 or more); of several the last. It shows the "
        f"idea at its clearest, not on average: at all {everywhere['moments']:,} new states of the {last - first + 1} "
        f"robots, asking lifted the favourite’s chance {favourite}, that of a step that pays {risen('pays', 0)}, and "
        f"that of a bump {risen('bumps', 1)}. “When it was wrong”: where asking raised the chance of a bump most. "
        "Pressed there: where asking at least doubled the favourite’s chance, the robot did that, and its next ten "
        "steps earned least. Each "
        "similar state has 1⁄20 of a say for each action, 5 inputs of 4 bins; one that was never met says 0. The page "
        f"lives both hours with the library’s own kernels. Of all {last - first + 1} pairs, the one that asks earns "
        f"{reward} a step; on a base that walls hold fast: {bumps}. ± is half of a 95 % interval of the "
        "mean difference."
    )
