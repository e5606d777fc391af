"""What the study of the bias found in one task: means, Dunnett's tests against each softmax regression, sizes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from paper.experiments import Length
from scipy import stats

import rlrobot_edu as rl
from rlrobot_edu.experiments.statistics import Interval, hedges_g

CONTROLS = ("SR", "SR, colder", "SR, half")
PAPERS = "QBIASSR"  # the bias that the others are compared with, too
LEVEL = 0.05
BLIND_LABEL, COARSE_LABEL = "blind", "coarse"  # who sees little stands beside the others and is not tested


class Against(NamedTuple):
    """One biased selection against SR, or the paper's bias: difference of means, p by Dunnett's test, Hedges' g."""

    difference: float
    p: float
    g: Interval

    @property
    def sign(self) -> int:
        """1 if it is significantly better, -1 if worse, 0 if neither is shown."""
        return int(np.sign(self.difference)) if self.p < LEVEL else 0


class Outcome(NamedTuple):
    """One task, on the robot or on a sample model, after one length.

    means, spreads: final average reward by label, and its SD
    against: by biased selection and control
    """

    task: str
    where: str
    n_states: int
    is_late: bool
    length: str
    repetitions: int
    means: dict[str, float]
    spreads: dict[str, float]
    against: dict[tuple[str, str], Against]

    def __str__(self) -> str:
        cells = [f"{label} {mean:.2f}" for label, mean in self.means.items()]
        for (biased, control), a in self.against.items():
            if a.sign:
                cells.append(f"{biased} {'>' if a.sign > 0 else '<'} {control} (g {a.g.value:.2f}, p {a.p:.2g})")
        return f"{self.where} {self.task} {self.length}: " + "; ".join(cells)


def outcomes_of(task: rl.Task, where: str, result: rl.Comparison, lengths: tuple[Length, ...]) -> Iterator[Outcome]:
    """The outcome after each length. Repetitions have random numbers of their own, so all samples are independent."""
    for length in lengths:
        finals = {
            label: np.array([length.beginning(history).final_average_reward for history in runs])
            for label, runs in result.groups.items()
        }
        against = {}
        for control in (*CONTROLS, PAPERS):
            biased = [label for label in finals if label not in (*CONTROLS, control, BLIND_LABEL, COARSE_LABEL)]
            p = _dunnett([finals[label] for label in biased], finals[control])
            for i, label in enumerate(biased):
                difference = float(finals[label].mean() - finals[control].mean())
                against[label, control] = Against(difference, p[i], hedges_g(finals[label], finals[control]))
        yield Outcome(
            task.name, where, task.states.n, length is lengths[-1], str(length), len(finals["SR"]),
            {label: float(x.mean()) for label, x in finals.items()},
            {label: float(x.std(ddof=1)) for label, x in finals.items()}, against,
        )  # fmt: skip


def _dunnett(samples: list[np.ndarray], control: np.ndarray) -> list[float]:
    """p-values of all samples against the control, one chance of error for all together (scipy, seeded)."""
    if np.ptp(np.concatenate([*samples, control])) == 0:
        return [1.0] * len(samples)
    return [float(p) for p in stats.dunnett(*samples, control=control, rng=np.random.default_rng(0)).pvalue]
