"""The outcome of a comparison: curves, tests and tables."""

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from rlrobot_edu.checks import check_name
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


class Comparison(Tabled, Mapping[str, Runs]):
    """The repetitions of several methods in one world.

    A mapping that cannot be changed: ``result["TOSL+SR"][3]`` is a History. `only` gives
    a comparison of some of the methods.

    Parameters
    ----------
    world : Task, SampleModel, EnvSpec or function
        Where the methods learned, see `compare`.
    runs : mapping of str to Runs
        The repetitions of each method, by its label.
    """

    def __init__(self, world: World, runs: Mapping[str, Runs]) -> None:
        self.world = world
        self._runs = dict(runs)

    def __getitem__(self, label: str) -> Runs:
        return self._runs[label]

    def __iter__(self) -> Iterator[str]:
        return iter(self._runs)

    def __len__(self) -> int:
        return len(self._runs)

    def __repr__(self) -> str:
        counts = ", ".join(f"{len(runs)} × {label}" for label, runs in self.items())
        return f"<Comparison in {self.name}: {counts}>"

    @classmethod
    def load(
        cls, path: str | Path, world: World | str | Path | None = None
    ) -> "Comparison":
        """Read the finished repetitions from a store of `compare`; nothing is run.

        Parameters
        ----------
        path : str or Path
            The store's folder.
        world : Task, str, Path, SampleModel, EnvSpec or function, optional
            What `compare` was given, if it is a task or an environment of your own.

        Returns
        -------
        Comparison
            The finished repetitions. The same call of `compare` runs the others.

        Raises
        ------
        ValueError
            If the folder is no store, if nothing has been finished in it, if a file is
            damaged, or if the store was made in another world.
        """
        store = Store.at(path)
        runs = {label: Runs(store.histories(label)) for label in store.facts["methods"]}
        finished = {label: its_runs for label, its_runs in runs.items() if its_runs}
        if not finished:
            raise ValueError(f"{path}: no repetition has been finished in this store")
        return cls(store.world(world), finished)

    def only(self, *labels: str) -> "Comparison":
        """A comparison of some of the methods: tests and curves of these alone.

        Parameters
        ----------
        *labels : str
            The methods, in the order in which they are shown.

        Returns
        -------
        Comparison
            The same repetitions of these methods.

        Raises
        ------
        ValueError
            If there is no label, or one that this comparison lacks.
        """
        if not labels:
            raise ValueError("only() needs at least one method")
        for label in labels:
            check_name(label, self._runs, "method", "this comparison")
        return Comparison(self.world, {label: self[label] for label in labels})

    @property
    def name(self) -> str:
        """The name of the task, environment or function, or ``model``."""
        named = getattr(self.world, "__name__", "model")
        return str(getattr(self.world, "name", named))

    @property
    def final(self) -> dict[str, np.ndarray]:
        """Final average reward of each repetition, by label.

        In an episodic task, that of the last episode. Numbers that differ by rounding
        alone are made equal.
        """
        # A sum of n rewards is rounded n times, up or down, which makes √n.
        scale = max(
            np.abs(history.rewards).max() * math.sqrt(len(history))
            for runs in self.values()
            for history in runs
        )
        finals = [runs.final for runs in self.values()]
        equalled = statistics.without_rounding(finals, scale)
        return dict(zip(self, equalled, strict=True))

    @property
    def optimum(self) -> float | None:
        """Best achievable average reward in a sample model; None for a robot, where it is unknown.

        Raises
        ------
        ValueError
            If the best way through the model cannot be computed, see `value_iteration`.
        """
        if isinstance(self.world, SampleModel):
            return best_average_reward(self.world)
        return None

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
        rows = [self._row(label, final) for label, final in self.final.items()]
        return Table(f"Final average reward in {self.name}", columns, rows)

    def _row(self, label: str, final: np.ndarray) -> list[object]:
        """The cells of one method."""
        interval = None
        deviation = None
        if len(final) > 1:
            low, high = statistics.mean_band(final)
            interval = f"[{low:.2f}, {high:.2f}]"
            deviation = math.sqrt(statistics.squares(final) / (len(final) - 1))
        seconds = np.median([history.seconds / len(history) for history in self[label]])
        return [
            label,
            len(final),
            statistics.average(final),
            interval,
            deviation,
            final.min(),
            final.max(),
            1e6 * seconds,
        ]

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
        # Imported here: numbers alone need no matplotlib.
        from rlrobot_edu.show.curves import plot_curves, steps_of

        if title is None:
            title = f"How the average reward develops in {self.name}"
        x = steps_of(self.values())
        seconds = getattr(self.world, "step_time", None)
        if seconds:
            x += f" ({seconds:g} s each)"
        curves = [(label, runs.curves) for label, runs in self.items()]
        return cast("Picture", plot_curves(curves, x, title, None, self.optimum))
