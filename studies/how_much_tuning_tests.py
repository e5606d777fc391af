"""The registered tests of how_much_tuning.py: seven hypotheses, bootstrap intervals, and p corrected by Holm."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from holm import holm_corrected
from how_much_tuning import METHODS, OURS, Study
from how_much_tuning_worlds import MAZES
from scipy.stats import rankdata

SR = "TOSL+SR"  # the paper's method without its bias
LEVEL = 0.05
MARGIN = 0.1  # of H2, in score


class Part(NamedTuple):
    """A number with its bootstrap draws, array (draws,); expected to lie above `null`."""

    name: str
    estimate: float
    draws: np.ndarray
    null: float = 0.0

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % percentile interval."""
        low, high = np.percentile(self.draws, [2.5, 97.5])
        return float(low), float(high)

    def p(self, two_sided: bool) -> float:
        """Twice the share of draws at the null's wrong side; `two_sided`: at the side with fewer draws."""
        wrong = int((self.draws <= self.null).sum())
        if two_sided:
            wrong = min(wrong, int((self.draws >= self.null).sum()))
        return min(1.0, 2 * (1 + wrong) / (1 + len(self.draws)))


class Finding(NamedTuple):
    """A hypothesis: its parts, which must all hold; p, and p corrected by Holm over the seven."""

    name: str
    parts: Sequence[Part]
    p: float
    corrected: float = float("nan")

    @property
    def verdict(self) -> str:
        """Whether it holds."""
        if not self.corrected < LEVEL:
            return "not shown"
        if all(part.estimate > part.null for part in self.parts):
            return "holds"
        return "the opposite holds"


def holm(findings: Sequence[Finding]) -> list[Finding]:
    """The same with p corrected for all of these tests."""
    p_values = holm_corrected([its.p for its in findings])
    return [
        its._replace(corrected=p) for its, p in zip(findings, p_values, strict=True)
    ]


class Draws:
    """The bootstrap: which robots and settings each draw takes; the same for all methods.

    Everything is drawn from the registered seed, in the order of the worlds.
    """

    def __init__(self, study: Study) -> None:
        self.study = study
        self.sizes = study.plan["sizes"]
        self.n = self.sizes["draws"]
        seed = np.random.SeedSequence(study.plan["seeds"]["bootstrap"])
        judged, swept, friction, held_out = map(np.random.default_rng, seed.spawn(4))
        self._judges = {
            world: judged.integers(0, robots, (self.n, robots))
            for world, robots in self.sizes["judging robots"].items()
        }
        settings, robots = self.sizes["settings"], self.sizes["robots"]
        self.settings = swept.integers(0, settings, (self.n, settings))
        self.robots = {
            world: swept.integers(0, robots, (self.n, robots)) for world in study.worlds
        }
        few = self.sizes["friction settings"]
        self._few_settings = friction.integers(0, few, (self.n, few))
        robots = {
            "friction": self.sizes["friction robots"],
            "wander_1k": self.sizes["robots"],
        }
        self._few_robots = {
            world: friction.integers(0, n, (self.n, n)) for world, n in robots.items()
        }
        self._held_out = held_out

    def judged(self, world: str, method: str, kind: str) -> Part:
        """The mean score of the judging robots at one of a method's settings."""
        setting = self.study.kinds(world, method)[kind]
        x = np.asarray(
            self.study.scored(world, self.study.judged(world, method, setting))
        )
        return Part(world, float(x.mean()), x[self._judges[world]].mean(axis=1))

    def over_tasks(self, method: str, kind: str) -> Part:
        """The mean of the six tasks."""
        parts = [self.judged(world, method, kind) for world in self.study.plan["tasks"]]
        return mean_of(method, parts)

    def regret(self, method: str, kind: str) -> Part:
        """What a kind of setting loses to the winner of each task, mean of the six."""
        return less(
            method, self.over_tasks(method, "winner"), self.over_tasks(method, kind)
        )

    @cached_property
    def few_interactions(self) -> dict[str, Part]:
        """Bias × traces with friction and without, at the same settings, reward a step."""
        return {world: self.effects(world)["interaction"] for world in self._few_robots}

    def effects(self, world: str) -> dict[str, Part]:
        """The means of the four methods over the few settings, and the gains of bias, traces, both, in reward a step.

        world: friction, or wander_1k, the same task without it
        """
        few = self.sizes["friction settings"]
        rows, columns = self._few_settings, self._few_robots[world]
        found = {}
        for method in METHODS:
            x = self.study.swept(world, method)[:few]
            by_setting = x[:, columns].mean(axis=2)  # settings × draws
            drawn = np.take_along_axis(by_setting.T, rows, axis=1).mean(axis=1)
            found[method] = Part(method, float(x.mean()), drawn)
        neither, traces, bias, both = (found[method] for method in METHODS)
        found["bias alone"] = less("bias alone", bias, neither)
        found["traces alone"] = less("traces alone", traces, neither)
        found["both"] = less("both", both, neither)
        alone = plus("alone", found["bias alone"], found["traces alone"])
        found["interaction"] = less("interaction", found["both"], alone)
        return found

    def rank_correlation(self, method: str) -> Part:
        """Of the settings' mean scores in wandering and with arms (Spearman)."""
        its = self.study.plan
        estimates = []
        drawn = []
        for worlds in (its["wandering"], its["arms"]):
            means, draws = zip(
                *(self._by_setting(world, method) for world in worlds), strict=True
            )
            estimates.append(np.mean(means, axis=0))
            drawn.append(np.mean(draws, axis=0))
        estimate = spearman(*(x[None] for x in estimates))[0]
        return Part(method, float(estimate), spearman(*drawn))

    def _by_setting(self, world: str, method: str) -> tuple[np.ndarray, np.ndarray]:
        """The score of each setting, array (settings,); and of the drawn ones, array (draws, settings)."""
        x = np.asarray(self.study.scored(world, self.study.swept(world, method)))
        by_setting = x[:, self.robots[world]].mean(axis=2).T
        return x.mean(axis=1), np.take_along_axis(by_setting, self.settings, axis=1)

    @cached_property
    def held_out(self) -> list[Part]:
        """Common less the paper's setting in each hold-out, in reward a step."""
        rng = self._held_out
        common = self.study.common(OURS)
        pairs = {
            world: [self.study.held_out(world, which) for which in (common, "paper")]
            for world in [*MAZES, *list(self.sizes["hold-out robots"])[1:]]
        }
        gains = {world: pair[0] - pair[1] for world, pair in pairs.items()}
        of_mazes = np.array([gains.pop(maze) for maze in MAZES])
        which = rng.integers(0, len(MAZES), (self.n, len(MAZES), 1))
        robots = rng.integers(
            0, of_mazes.shape[1], (self.n, len(MAZES), of_mazes.shape[1])
        )
        drawn = of_mazes[which, robots].mean(axis=(1, 2))
        found = [Part("ten random mazes", float(of_mazes.mean()), drawn)]
        for world, x in gains.items():
            robots = rng.integers(0, len(x), (self.n, len(x)))
            found.append(Part(world, float(x.mean()), x[robots].mean(axis=1)))
        return found


def spearman(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The rank correlation of each row, array (rows,)."""
    x, y = (rankdata(values, axis=1) for values in (x, y))
    x, y = (values - values.mean(axis=1, keepdims=True) for values in (x, y))
    return (x * y).sum(axis=1) / np.sqrt((x**2).sum(axis=1) * (y**2).sum(axis=1))


def less(name: str, one: Part, other: Part, null: float = 0.0) -> Part:
    """One number less another, draw by draw."""
    return Part(name, one.estimate - other.estimate, one.draws - other.draws, null)


def plus(name: str, one: Part, other: Part) -> Part:
    """The sum of two numbers, draw by draw."""
    return Part(name, one.estimate + other.estimate, one.draws + other.draws)


def mean_of(name: str, parts: Sequence[Part]) -> Part:
    """The mean of several numbers, draw by draw."""
    estimate = float(np.mean([part.estimate for part in parts]))
    return Part(name, estimate, np.mean([part.draws for part in parts], axis=0))


def findings(draws: Draws) -> list[Finding]:
    """The seven hypotheses, corrected."""

    def tuned(world: str, null: float = 0.0) -> Part:
        ours, its = (draws.judged(world, method, "winner") for method in (OURS, SR))
        return less(world, ours, its, null)

    def promise(kind: str) -> Part:
        return less(kind, draws.regret(SR, kind), draws.regret(OURS, kind))

    interaction = draws.few_interactions
    parts = {
        "H1": [tuned("new ground")],
        "H2": [tuned(world, -MARGIN) for world in draws.study.plan["elsewhere"]],
        "H3": [promise("paper's")],
        "H4": [promise("others'")],
        "H5": [
            interaction["friction"]._replace(name="with friction and lag"),
            less("more than without", interaction["friction"], interaction["wander_1k"]),
        ],
        "H6": [
            less(
                "SR less QBIASSR",
                draws.rank_correlation(SR),
                draws.rank_correlation(OURS),
            )
        ],
        "H7": draws.held_out,
    }  # fmt: skip
    found = []
    for name, its in parts.items():
        p = max(part.p(two_sided=len(its) == 1) for part in its)
        found.append(Finding(name, its, p))
    return holm(found)
