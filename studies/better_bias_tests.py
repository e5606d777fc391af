"""The registered tests of better_bias.py: differences, their intervals, and p corrected by Holm in each family."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from better_bias import MAZES, REGISTERED, RULES, at_best
from holm import holm_corrected
from scipy import stats

Found = Mapping[
    str, Mapping[str, Sequence[float]]
]  # final average rewards by world and label
LEVEL = 0.05
OURS = "VBIASSR"


class Difference(NamedTuple):
    """One method less another in a world.

    first, second: their labels; mean, low, high: of the difference, and its uncorrected 95 % interval
    p: two-sided; corrected: by Holm over its family, NaN where nothing is tested
    """

    world: str
    first: str
    second: str
    mean: float
    low: float
    high: float
    p: float
    corrected: float = float("nan")

    @property
    def sign(self) -> int:
        """1 or -1 where the corrected p allows to say who earns more, else 0."""
        return int(np.sign(self.mean)) if self.corrected < LEVEL else 0


def difference(found: Found, world: str, first: str, second: str) -> Difference:
    """By Welch's t; over the ten mazes a one-sample t of the differences of their means."""
    if world == "ten mazes":
        gains = [
            np.mean(found[maze][first]) - np.mean(found[maze][second]) for maze in MAZES
        ]
        test = stats.ttest_1samp(gains, 0.0)
        mean = float(np.mean(gains))
    else:
        one, other = found[world][first], found[world][second]
        test = stats.ttest_ind(one, other, equal_var=False)
        mean = float(np.mean(one) - np.mean(other))
    low, high = test.confidence_interval(1 - LEVEL)
    return Difference(
        world, first, second, mean, float(low), float(high), float(test.pvalue)
    )


def holm(family: Sequence[Difference]) -> list[Difference]:
    """The same with p corrected for all of these tests."""
    p_values = holm_corrected([its.p for its in family])
    return [its._replace(corrected=p) for its, p in zip(family, p_values, strict=True)]


def family(found: Found, name: str) -> list[Difference]:
    """The tests of a registered family, corrected."""
    its = REGISTERED["families"][name]
    rows = []
    for world in its["worlds"]:
        rows += [difference(found, world, OURS, other) for other in its["at T = 1"]]
        best = [
            (at_best(found[world], OURS), at_best(found[world], other))
            for other in its["at best T"]
        ]
        rows += [difference(found, world, *labels) for labels in best]
    return holm(rows)


def pays_no_circle(found: Found, world: str) -> Difference:
    """The blind agent less SR: its interval must be below 0 for the world to count."""
    return difference(found, world, "blind", "SR")


def relatives(found: Found) -> list[Difference]:
    """Each relative less VBIASSR in each world, one family."""
    its = REGISTERED["relatives"]
    return holm(
        [
            difference(found, world, name, OURS)
            for world in its["worlds"]
            for name in its["names"]
        ]
    )


def lowest(
    found: Found, world: str, first: str, second: str, confidence: float
) -> float:
    """The lower end of the one-sided interval of a difference (Welch)."""
    test = stats.ttest_ind(found[world][first], found[world][second], equal_var=False)
    return float(test.confidence_interval(2 * confidence - 1).low)


def never_hurts(found: Found, name: str) -> list[str]:
    """Where the registered rule fails for a relative, in words; empty if it never hurts."""
    its = REGISTERED["relatives"]
    confidence, least = 1 - LEVEL / len(its["names"]), -its["margin"]
    asked = [(world, "SR") for world in its["worlds"]] + [
        (world, OURS) for world in its["gain"]
    ]
    ends = {
        (world, other): lowest(found, world, name, other, confidence)
        for world, other in asked
    }
    return [
        f"{world} beside {other} ({end:.2f})"
        for (world, other), end in ends.items()
        if end <= least
    ]


class Rule(NamedTuple):
    """TOSL+QBIASSR less another, with loop evasion everywhere and, as in the program, in QBIASSR alone."""

    ours: Difference
    its: Difference

    @property
    def decides(self) -> bool:
        """Whether the verdict hangs on the rule: only one is significant, or both with other signs."""
        return self.ours.sign != self.its.sign


def rules(found: Found) -> list[Rule]:
    """Both rules in each registered world, beside SR and Q+SR; one family."""
    pairs = [("SR", "SR, no loop evasion"), ("Q+SR", "Q+SR, no loop evasion")]
    assert {label for pair in pairs for label in pair} - {"SR"} == set(RULES)
    worlds = REGISTERED["reproduction"]["rule"]
    rows = holm(
        [
            difference(found, world, "QBIASSR", label)
            for world in worlds
            for pair in pairs
            for label in pair
        ]
    )
    return [Rule(*pair) for pair in zip(rows[::2], rows[1::2], strict=True)]


def wheels(found: Found) -> list[Difference]:
    """VBIASSR less QBIASSR, SR and blind by either mapping of the wheels; no test is registered."""
    worlds: Any = REGISTERED["reproduction"]["wheels"]
    return [
        difference(found, world, OURS, other)
        for world in worlds
        for other in ("QBIASSR", "SR", "blind")
    ]
