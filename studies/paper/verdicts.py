"""In what our result agrees with the paper's: one word for each pair of methods, and for each value it chose."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from rlrobot_edu.experiments.statistics import LEVEL, Pair

AGREES, DIRECTION, UNDECIDED = "agrees", "agrees in direction", "undecided"
OPPOSITE, REVERSED = "opposite, not significant", "significantly the opposite"


class Verdict(NamedTuple):
    """Its name is one of the five above; detail: what must be added to it."""

    name: str
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.name} ({self.detail})" if self.detail else self.name

    @property
    def is_opposite(self) -> bool:
        """Whether the other method is better here, by chance or not."""
        return self.name in (OPPOSITE, REVERSED)


def verdict(gain: float, p: float, paper_p: float | None) -> Verdict:
    """What agrees, where `gain` is our mean of the paper's better method less that of its worse one.

    p, paper_p: of the pair in our Tukey test and in the paper's; None where it gives none
    """
    ours, papers = bool(p < LEVEL), paper_p is None or paper_p < LEVEL
    untested = "the paper gives no test" if paper_p is None else ""
    if not ours and not papers:
        return Verdict(UNDECIDED)
    if gain > 0:
        if ours and papers:
            return Verdict(AGREES, untested)
        only = "only ours is significant" if ours else "only the paper's is significant"
        return Verdict(
            DIRECTION,
            "ours is not significant; the paper gives no test" if untested else only,
        )
    return Verdict(
        REVERSED if ours else OPPOSITE,
        untested if papers else "the paper's is not significant",
    )


EVERYWHERE, SOMEWHERE, TENDENCY, NOT = "✔", "(✔)", "~", "✘"


def mark(verdicts: Iterable[Verdict]) -> str:
    """What became of a pair that the paper finds significant, by the verdicts in all set-ups of its task."""
    verdicts = list(verdicts)
    agree = [verdict.name == AGREES for verdict in verdicts]
    if any(agree):
        return EVERYWHERE if all(agree) else SOMEWHERE
    return NOT if any(verdict.is_opposite for verdict in verdicts) else TENDENCY


BEST, AS_GOOD, BEATEN = (
    "the best here",
    "not the best here, but not significantly worse",
    "significantly worse here",
)


class ValueVerdict(NamedTuple):
    """Whether a value that the paper chose is the best here.

    name: BEST, AS_GOOD or BEATEN, by Tukey's p; best: which is; loss: by how much it is better; pair: the two, tested
    """

    name: str
    best: str
    loss: float = 0.0
    pair: Pair | None = None


def of_value(
    final: Mapping[str, np.ndarray], pairs: Iterable[Pair], chosen: str
) -> ValueVerdict:
    """The verdict on the chosen value; final: final average rewards by label, arrays (n,)."""
    best = max(final, key=lambda label: float(np.mean(final[label])))
    if best == chosen:
        return ValueVerdict(BEST, best)
    pair = next(p for p in pairs if {p.first, p.second} == {best, chosen})
    return ValueVerdict(
        BEATEN if pair.p < LEVEL else AS_GOOD, best, abs(pair.difference), pair
    )
