"""The outcome of a comparison: curves, tests and tables."""

from collections import UserDict
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from rlrobot_edu.environments import World
from rlrobot_edu.experiments import statistics
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.statistics import Anova, Tukey
from rlrobot_edu.experiments.store import Store
from rlrobot_edu.experiments.tables import Table, Tabled
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.models.value_iteration import best_average_reward

if TYPE_CHECKING:
    from rlrobot_edu.show.picture import Picture


class Comparison(Tabled, UserDict[str, Runs]):
    """The repetitions of several methods in one world, a mapping: ``result["TOSL+SR"][3]`` is a History.

    Parameters
    ----------
    world : Task, SampleModel, EnvSpec or function
        What they learned in, see `compare`.
    groups : mapping of str to Runs
        By label, the repetitions of each method.
    """

    def __init__(self, world: World, groups: Mapping[str, Runs]) -> None:
        super().__init__(groups)
        self.world = world
        self.groups = self.data

    @classmethod
    def load(
        cls, path: str | Path, world: World | str | Path | None = None
    ) -> "Comparison":
        """What has been finished in a store of `rlrobot_edu.compare`; nothing is run.

        Parameters
        ----------
        path : str or Path
            The store's folder.
        world : Task, str, Path, SampleModel, EnvSpec or function, optional
            What `compare` was given, if it is a task or an environment of your own.

        Returns
        -------
        Comparison
            The repetitions that are there; it prints how many. The same call of `compare` runs the others.

        Raises
        ------
        ValueError
            If the folder is no store, if nothing has been finished in it, if a file is damaged or belongs to
            something else, or if the store was made in another world.
        """
        store = Store.at(path)
        groups = {
            label: runs
            for label in store.facts["methods"]
            if (runs := Runs(store.histories(label)))
        }
        if not groups:
            raise ValueError(f"{path}: no repetition has been finished in this store")
        return cls(store.world(world), groups)

    def __repr__(self) -> str:
        counts = ", ".join(
            f"{len(runs)} × {label}" for label, runs in self.groups.items()
        )
        return f"<Comparison in {self.name}: {counts}>"

    @property
    def name(self) -> str:
        """The name of the task, environment or function, or ``model``."""
        return str(
            getattr(self.world, "name", getattr(self.world, "__name__", "model"))
        )

    @cached_property
    def final(self) -> dict[str, np.ndarray]:
        """Final average reward of each repetition, by label; in an episodic task, of the last episode."""
        # a sum of n rewards is rounded n times, up or down, which makes √n
        size = max(
            abs(h.rewards).max() * len(h) ** 0.5 for runs in self.values() for h in runs
        )
        final = statistics.without_rounding(
            [runs.final for runs in self.values()], size
        )
        return dict(zip(self, final, strict=True))

    @cached_property
    def optimum(self) -> float | None:
        """Best achievable average reward in a sample model; None for a robot, where it is unknown."""
        return (
            best_average_reward(self.world)
            if isinstance(self.world, SampleModel)
            else None
        )

    def anova(self) -> Anova:
        """One-way analysis of variance of the final average rewards.

        Returns
        -------
        Anova
            Sums of squares, F and p; it shows itself as a table.

        Raises
        ------
        ValueError
            For too few repetitions.
        """
        return Anova.of(list(self.final.values()))

    def tukey(self) -> Tukey:
        """Tukey's test of all pairs of methods.

        Returns
        -------
        Tukey
            The pairs, with the size of each difference; it shows itself as a table.

        Raises
        ------
        ValueError
            For too few repetitions.
        """
        return Tukey.of(self.final)

    def table(self) -> Table:
        """Final average reward of each method: mean and its 95 % interval, spread; and what a step cost.

        Returns
        -------
        Table
            One row a method.
        """
        rows: list[list[object]] = []
        for label, runs in self.items():
            final = self.final[label]
            several = len(final) > 1
            interval = (
                "[{:.2f}, {:.2f}]".format(*statistics.mean_band(final))
                if several
                else None
            )
            spread = (
                (statistics.squares(final) / (len(final) - 1)) ** 0.5
                if several
                else None
            )
            cost = np.median([h.seconds / len(h) for h in runs]) * 1e6
            mean = statistics.average(final)
            rows.append(
                [
                    label,
                    len(final),
                    mean,
                    interval,
                    spread,
                    final.min(),
                    final.max(),
                    cost,
                ]
            )
        columns = [
            "method",
            "repetitions",
            "mean",
            "95 % interval",
            "SD",
            "lowest",
            "highest",
            "µs a step",
        ]
        return Table(f"Final average reward in {self.name}", columns, rows)

    def plot(self, *, title: str | None = None) -> "Picture":
        """Mean learning curves with bands of their 95 % intervals; on a sample model, the best achievable as a line.

        Parameters
        ----------
        title : str, optional
            What the curves show.

        Returns
        -------
        Picture
            The figure; for axes of your own see `plot_learning`.
        """
        from rlrobot_edu.show.curves import (
            plot_curves,
            steps_of,
        )  # numbers alone need no matplotlib

        seconds = getattr(self.world, "step_time", None)
        x = steps_of(self.values()) + (f" ({seconds:g} s each)" if seconds else "")
        title = title or f"How the average reward develops in {self.name}"
        curves = [(label, runs.curves) for label, runs in self.items()]
        return cast("Picture", plot_curves(curves, x, title, None, self.optimum))
