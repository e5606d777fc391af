"""What came of an experiment: the final average reward of each repetition, as averages.csv has it, and tests of it."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy import special, stats

from paper.experiments import Experiment, Length
from paper.paper import PaperPair
from paper.verdicts import ValueVerdict, Verdict, of_value, verdict
from rlrobot_course.play.report import read_averages
from rlrobot_edu.experiments.statistics import Anova, Pair, Tukey

SHUTTLES = (
    2.0,
    4.5,
)  # (5 − 1) / 2 and (10 − 1) / 2: what to and fro before the object pays an arm a step
NEAR = 0.25  # a final average so close to one of them counts as of a shuttle

Finals = Mapping[str, np.ndarray]


class Judged(NamedTuple):
    """A pair of the paper, what its better method gains here, our test of the two, and the verdict by Tukey's p."""

    pair: PaperPair
    gain: float
    ours: Pair
    verdict: Verdict

    @property
    def p(self) -> float:
        """Of Tukey's test."""
        return self.ours.p


@dataclass(frozen=True)
class Outcome:
    """The outcome of an experiment. final: by length and label, the final average reward of each repetition."""

    experiment: Experiment
    final: Mapping[Length, Finals]

    @cached_property
    def pairs(self) -> dict[Length, tuple[Pair, ...]]:
        """The pairs of Tukey's test, by length."""
        return {length: Tukey.of(groups).pairs for length, groups in self.final.items()}

    @property
    def longest(self) -> Length:
        """The length that was run."""
        return self.experiment.lengths[-1]

    def means(self, length: Length | None = None) -> dict[str, float]:
        """Mean final average reward by label."""
        return {
            label: float(x.mean())
            for label, x in self.final[length or self.longest].items()
        }

    def tested(self, first: str, second: str, length: Length | None = None) -> Pair:
        """Our tests of these two methods, whichever of them is named first in it."""
        for pair in self.pairs[length or self.longest]:
            if {pair.first, pair.second} == {first, second}:
                return pair
        raise ValueError(f"{self.experiment.key} has no pair of {first} and {second}")

    def pair(
        self, first: str, second: str, length: Length | None = None
    ) -> tuple[float, float]:
        """Mean of the first less that of the second method, and p of Tukey's test."""
        pair = self.tested(first, second, length)
        return (pair.difference if pair.first == first else -pair.difference), pair.p

    def judged(self, length: Length | None = None) -> list[Judged]:
        """Each pair that the paper speaks of, beside ours."""
        found = []
        for its in self.experiment.pairs:
            gain, p = self.pair(its.better, its.worse, length)
            ours = self.tested(its.better, its.worse, length)
            found.append(Judged(its, gain, ours, verdict(gain, p, its.p)))
        return found

    def value(self) -> ValueVerdict:
        """The verdict on the value that the paper chose, at the longest length."""
        return of_value(
            self.final[self.longest], self.pairs[self.longest], self.experiment.best
        )


def read_outcomes(path: Path, experiments: Iterable[Experiment]) -> dict[str, Outcome]:
    """The outcomes in the file averages.csv of those of these experiments that are in it, by key."""
    found = read_averages(path)
    return {
        e.key: Outcome(e, {length: found[e.key, str(length)] for length in e.lengths})
        for e in experiments if (e.key, str(e.lengths[-1])) in found
    }  # fmt: skip


def interval(groups: Finals) -> float:
    """Half the width of Tukey's simultaneous 95 % intervals of the differences; the groups have one size."""
    anova = Anova.of(list(groups.values()))
    return half_width(anova, len(next(iter(groups.values()))))


def half_width(anova: Anova, n: int) -> float:
    """The same from an analysis of variance with `n` repetitions a group."""
    critical = critical_range(anova.df_between + 1, anova.df_within)
    return critical * float(np.sqrt(anova.ms_within / n))


@cache
def critical_range(means: int, df: int) -> float:
    """Tukey's critical value at 5 %; SciPy integrates for it, which takes half a second."""
    return float(stats.studentized_range.ppf(0.95, means, df))


def detectable(groups: Finals, power: float = 0.8) -> float:
    """The smallest difference of two means that Tukey's test finds with this probability, if all spread alike.

    The groups have one size.
    """
    anova = Anova.of(list(groups.values()))
    n, methods = len(next(iter(groups.values()))), anova.df_between + 1
    t_needed = critical_range(methods, anova.df_within) / math.sqrt(2)
    shift = float(special.nctdtrinc(anova.df_within, 1 - power, t_needed))
    return shift * math.sqrt(2 * anova.ms_within / n)


def significant_with(
    groups: Finals, n: int, draws: int = 2000
) -> dict[frozenset, float]:
    """How often Tukey's test finds each pair of methods significant (p < 0.05) in only `n` of our repetitions.

    Draws the `n` repetitions of each method anew each time, without replacement.
    """
    rng, labels = np.random.default_rng(0), list(groups)
    drawn = {
        label: rng.permuted(np.tile(groups[label], (draws, 1)), axis=1)[:, :n]
        for label in labels
    }
    within = np.mean([drawn[label].var(axis=1, ddof=1) for label in labels], axis=0)
    critical = critical_range(len(labels), len(labels) * (n - 1))
    shares = {}
    for i, first in enumerate(labels):
        for second in labels[i + 1 :]:
            difference = np.abs(drawn[first].mean(axis=1) - drawn[second].mean(axis=1))
            shares[frozenset((first, second))] = float(
                np.mean(difference > critical * np.sqrt(within / n))
            )
    return shares


def shuttles(final: np.ndarray) -> float:
    """Share of the final averages that lie at one of the two shuttles."""
    return float(
        np.mean(np.abs(final[:, None] - np.array(SHUTTLES)).min(axis=1) < NEAR)
    )
