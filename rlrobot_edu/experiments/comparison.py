"""The outcome of a comparison: curves, tests and tables."""

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from rlrobot_edu.checks import check_name, did_you_mean
from rlrobot_edu.environments import World
from rlrobot_edu.experiments.rounding import average, squares, without_rounding
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.statistics import Anova, Tukey, mean_band
from rlrobot_edu.experiments.store import Store
from rlrobot_edu.experiments.tables import Table, Tabled
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.models.value_iteration import best_average_reward

if TYPE_CHECKING:
    from rlrobot_edu.show.picture import Picture


@suggests_keywords
class Comparison(Tabled, Mapping[str, Runs]):
    """The repetitions of several methods in one world.

    A read-only mapping from labels to repetitions: ``result["TOSL+SR"][3]`` is a
    `History`. `only` gives a comparison of some of the methods.

    Parameters
    ----------
    world : Task, SampleModel, EnvSpec or function
        Where the methods learned, see `compare`.
    runs : mapping of str to Runs
        The repetitions of each method, by its label.

    Raises
    ------
    ValueError
        If `runs` is something else.
    """

    def __init__(self, world: World, runs: Mapping[str, Runs]) -> None:
        is_by_label = isinstance(runs, Mapping)
        if not is_by_label or not all(isinstance(its, Runs) for its in runs.values()):
            raise ValueError(
                "a Comparison is made of Runs by label; rl.compare returns one"
            )
        self.world = world
        self._runs = dict(runs)

    def __getitem__(self, label: str) -> Runs:
        if label not in self._runs:
            nearest = did_you_mean(label, self._runs)
            raise KeyError(
                f"this comparison has no method {label!r:.200}{nearest} It has: {', '.join(self._runs)}"
            )
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
        """Read the finished repetitions from a store of `compare`; run nothing.

        Parameters
        ----------
        path : str or Path
            The store's folder.
        world : Task, str, Path, SampleModel, EnvSpec or function, optional
            Needed only if `compare` was given a task or an environment of your own.

        Returns
        -------
        Comparison
            The finished repetitions. The same call of `compare` runs the others.

        Raises
        ------
        ValueError
            If the folder is not a store, if no repetition in it is finished, if a file
            is damaged, or if the store was made in another world.
        """
        store = Store.at(path)
        runs = {label: Runs(store.histories(label)) for label in store.facts["methods"]}
        finished = {label: its_runs for label, its_runs in runs.items() if its_runs}
        if not finished:
            raise ValueError(f"{path}: no repetition has been finished in this store")
        return cls(store.world(world), finished)

    def only(self, *labels: str) -> "Comparison":
        """A comparison of these methods alone, for further tests and curves.

        Parameters
        ----------
        *labels : str
            The methods to keep, in the order in which to show them.

        Returns
        -------
        Comparison
            The same repetitions of these methods, and no others.

        Raises
        ------
        ValueError
            If no label is given, or if one is unknown.
        """
        if not labels:
            raise ValueError("only() needs at least one method")
        for label in labels:
            check_name(label, self._runs, "method", "this comparison")
        return Comparison(self.world, {label: self[label] for label in labels})

    @property
    def name(self) -> str:
        """The name of the task, environment or function, or ``model``."""
        for attribute in ("name", "__name__"):
            if hasattr(self.world, attribute):
                return str(getattr(self.world, attribute))
        return "model"

    @property
    def final(self) -> dict[str, np.ndarray]:
        """Final average reward of each repetition, by label.

        In an episodic task it is that of the last episode. Numbers that differ by
        rounding alone are made equal.
        """
        # The rounding errors of a sum of n rewards add up like a random walk: as √n.
        scale = max(
            np.abs(history.rewards).max() * math.sqrt(len(history))
            for runs in self.values()
            for history in runs
        )
        finals = [runs.final for runs in self.values()]
        equalled = without_rounding(finals, scale)
        return dict(zip(self, equalled, strict=True))

    @property
    def optimum(self) -> float | None:
        """The best achievable average reward in a sample model.

        None for a robot, where it is unknown.

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
            If there are fewer than two methods with two repetitions each.
        """
        return Anova.of(list(self.final.values()))

    def tukey(self) -> Tukey:
        """Tukey's test of all pairs of methods, and beside it that of Games and Howell.

        Tukey's test takes all methods to spread alike, the other one does not.

        Returns
        -------
        Tukey
            The pairs, with the size of each difference; it shows itself as a table, in
            which ≠ marks a pair on which the two tests disagree.

        Raises
        ------
        ValueError
            If there are fewer than two methods with two repetitions each.
        """
        return Tukey.of(self.final)

    def table(self) -> Table:
        """Final average reward of each method: mean, 95 % interval and spread, and the time of a step.

        Returns
        -------
        Table
            One row for each method.
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
        """The cells of one method in the table."""
        interval = None
        deviation = None
        if len(final) > 1:
            low, high = mean_band(final)
            interval = f"[{low:.2f}, {high:.2f}]"
            deviation = math.sqrt(squares(final) / (len(final) - 1))
        seconds = np.median([history.seconds / len(history) for history in self[label]])
        return [
            label,
            len(final),
            average(final),
            interval,
            deviation,
            final.min(),
            final.max(),
            1e6 * seconds,
        ]

    def plot(self, *, title: str | None = None) -> "Picture":
        """Mean learning curves, each with a band: the 95 % interval of the mean.

        In a sample model, a line shows the best achievable average reward.

        Parameters
        ----------
        title : str, optional
            What the curves show; by default which method ends ahead, if any does.

        Returns
        -------
        Picture
            The figure. To draw on axes of your own, see `plot_learning`.
        """
        # Imported here, so that the numbers alone need no matplotlib.
        from rlrobot_edu.show.curves import plot_curves, steps_of

        x_label = steps_of(self.values())
        step_time = getattr(self.world, "step_time", None)
        if step_time:
            x_label += f" ({step_time:g} s each)"
        curves = [(label, runs.curves) for label, runs in self.items()]
        picture = plot_curves(
            curves, x_label, title, None, self.optimum, place=self.name
        )
        return cast("Picture", picture)
