"""What the paper found: its tables, as printed, and the differences of means that follow from them."""

import math
from typing import NamedTuple

from rlrobot_edu.experiments.statistics import Anova

THREE = ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")


class PaperPair(NamedTuple):
    """A pair of methods in the paper. q, p: of its Tukey test, None where it gives none; `better` is the better one."""

    better: str
    worse: str
    q: float | None = None
    p: float | None = None

    @property
    def name(self) -> str:
        """Both, the better one first."""
        return f"{self.better} over {self.worse}"


def _pairs(
    *q_and_p: tuple[float, float], order: tuple[str, ...] = THREE
) -> tuple[PaperPair, ...]:
    # The tables print |Q|; the order of the means is the only one in which two of the Q add up to the third.
    couples = ((order[0], order[1]), (order[0], order[2]), (order[1], order[2]))
    return tuple(
        PaperPair(*couple, *numbers)
        for couple, numbers in zip(couples, q_and_p, strict=True)
    )


# by task: sums of squares and degrees of freedom, and F and p as printed
ANOVA = {
    "wander_simple": (Anova(125.41, 2, 476.37, 297), 39.09, 8.88e-16),
    "wander_1k": (Anova(27.47, 2, 6.58, 15), 31.29, 4.44e-6),
    "wander_4k": (Anova(14.96, 2, 3.50, 15), 32.05, 3.84e-6),
    "arm_1k": (Anova(136.21, 2, 456.23, 69), 10.30, 0.0001),
    "arm_4k": (Anova(278.65, 2, 414.97, 69), 23.17, 2.01e-8),
    "navigation_1k": (Anova(7.62, 2, 5.51, 6), 4.15, 0.070),
    "giraff_wander_1k": (Anova(31.73, 2, 55.26, 57), 16.36, 0.000002),
}
TUKEY = {
    "wander_simple": _pairs(
        (0.80, 0.820),
        (11.21, 0.001),
        (10.41, 0.001),
        order=("TOSL+SR", "TOSL+QBIASSR", "Q+SR"),
    ),
    "wander_1k": _pairs((6.17, 0.002), (11.17, 0.001), (5.00, 0.008)),
    "wander_4k": _pairs((7.92, 0.001), (10.97, 0.001), (3.05, 0.111)),
    "arm_1k": _pairs((1.68, 0.465), (6.20, 0.001), (4.52, 0.006)),
    "arm_4k": _pairs((2.60, 0.165), (9.33, 0.001), (6.73, 0.001)),
    "navigation_1k": _pairs((1.95, 0.410), (4.07, 0.063), (2.13, 0.354)),
    "giraff_wander_1k": _pairs(
        (4.3491, 0.0089151), (8.0827, 0.0010053), (3.7336, 0.0283548)
    ),
}
# CPU time a step [s] in the sample-modelled wander-1K: method, traces, time
COST = (
    ("Q+SR", "reduced", 0.19e-3),
    ("SARSA+SR", "reduced", 0.20e-3),
    ("SL+SR", "reduced", 0.31e-3),
    ("TOSL+SR", "reduced", 0.31e-3),
    ("TOSL+QBIASSR", "reduced", 0.45e-3),
    ("TOSL+SR", "full", 5.32e-3),
)
# Share of the pairs (s, a) in the authors' own recording of wander-1K that was seen only once (18,000 rows, 1691 pairs)
SEEN_ONCE_IN_VREP = 0.283


def repetitions(task: str) -> int:
    """How often the paper repeated each method: its degrees of freedom within groups are 3 n − 3."""
    return ANOVA[task][0].df_within // len(THREE) + 1


def difference(task: str, pair: PaperPair) -> float:
    """Mean final average reward of the better method less that of the worse one in the paper.

    Tukey's Q is this difference over its standard error √(MSW / n). The paper prints Q and not the means.
    """
    anova = ANOVA[task][0]
    return pair.q * math.sqrt(anova.ms_within / repetitions(task))
