"""A sweep: many settings of a method, each tried by the same robots. What does tuning gain, and how much is luck?

    result = sweep("wander_1k", random_settings(64), robots=4, method="TOSL+SR")
    result.plot()
    anew = sweep("wander_1k", [result.winner], robots=30, seed=1)  # the winner's luck is gone

All settings share their random numbers (*common random numbers*), so two settings differ in their parameters alone.
`compare` gives every repetition numbers of its own, as an analysis of variance wants it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from rlrobot_edu.checks import check_count, check_index, check_name
from rlrobot_edu.environments import World
from rlrobot_edu.experiments.compare import check_jobs, length_of
from rlrobot_edu.experiments.repetitions import (
    SETTINGS,
    Seed,
    Settings,
    in_parallel,
    learner,
    repetition,
    tried,
)
from rlrobot_edu.experiments.tables import Table, Tabled
from rlrobot_edu.keywords import names_of
from rlrobot_edu.learning.progress import progress_bar
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.robot_cards import Engine

if TYPE_CHECKING:
    from rlrobot_edu.show.picture import Picture


class Range(NamedTuple):
    """What a parameter may be: from `low` to `high`; `log`: evenly in its logarithm."""

    low: float
    high: float
    log: bool = False

    def at(self, share: float) -> float:
        """The value at this share of the way, 0 to 1."""
        if self.log:
            return float(self.low * (self.high / self.low) ** share)
        return self.low + (self.high - self.low) * share


BOX: Mapping[str, Range] = {
    "alpha": Range(0.02, 1.0, log=True),
    "gamma": Range(0.5, 0.99),
    "lam": Range(0.0, 0.98),
    "temperature": Range(0.01, 10.0, log=True),
}


def random_settings(
    n: int, seed: int = 0, box: Mapping[str, Range] = BOX
) -> list[dict[str, float]]:
    """Settings that fill a box evenly: n points of a scrambled Sobol sequence; the first ones are so, too.

    n: best a power of two; seed: of the scramble; box: the range of each parameter, by name
    """
    n = check_count("the number of settings", n)
    sobol = qmc.Sobol(len(box), scramble=True, rng=np.random.default_rng(seed))
    rows = sobol.random_base2(int(n - 1).bit_length())[:n]
    settings = []
    for row in rows:
        shares = zip(box.items(), row, strict=True)
        settings.append({name: its.at(float(share)) for (name, its), share in shares})
    return settings


AT_ONCE = 8  # robots of a setting that run one after another in a process


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Tabled):
    """What a method earned at each of many settings.

    settings: the parameters of an agent at each setting, by name
    scores: array (settings, robots), final average rewards; a column is the same robot: the same random numbers
    """

    settings: Sequence[Settings]
    scores: NDArray[np.float64]

    @property
    def means(self) -> NDArray[np.float64]:
        """The mean over the robots, array (settings,)."""
        return np.asarray(self.scores.mean(axis=1))

    @property
    def best(self) -> int:
        """The number of the setting with the highest mean."""
        return int(self.means.argmax())

    @property
    def winner(self) -> Settings:
        """The parameters of the best setting. Its mean owes something to luck: try it anew with another seed."""
        return self.settings[self.best]

    def regret(self, i: int) -> float:
        """What setting i earns less than the best one, reward a step; the winner's luck included."""
        i = check_index("setting", i, len(self.settings))
        return float(self.means.max() - self.means[i])

    def table(self, n: int = 5) -> Table:
        """The n best settings: parameters, mean and spread over the robots."""
        names = [name for name in self.settings[0] if name != "method"]
        rows = []
        for i in np.argsort(-self.means)[:n]:
            parameters = [self.settings[i][name] for name in names]
            rows.append(
                [*parameters, float(self.means[i]), float(self.scores[i].std())]
            )
        n_settings, robots = self.scores.shape
        caption = f"The best of {n_settings} settings, {robots} robots each"
        return Table(caption, [*names, "mean", "SD"], rows)

    def plot(
        self, x: str = "temperature", y: str = "alpha", title: str | None = None
    ) -> "Picture":
        """A map: each setting is a dot at its values of two parameters, coloured by what it earned."""
        # Imported here, so that the numbers alone need no matplotlib.
        from rlrobot_edu.show.map_of_settings import plot_settings
        from rlrobot_edu.show.picture import Picture

        if title is None:
            half = np.median(self.means)
            title = f"The best setting earns {self.means.max():.2f} a step, half of them less than {half:.2f}"
        alt = f"{title}: a dot for each setting, {y} over {x}"
        picture = Picture((6.5, 4.2), alt)
        ax = picture.subplots()
        dots = plot_settings(ax, self.settings, self.means, x, y)
        picture.headline(title)
        picture.colorbar(dots, label="reward a step")
        return picture


def sweep(
    world: World | str | Path,
    settings: Sequence[Settings],
    robots: int = 8,
    *,
    steps: int | None = None,
    episodes: int | None = None,
    seed: int = 0,
    n_jobs: int = -1,
    realism: Realism | None = None,
    engine: Engine | None = None,
    progress: bool = True,
    **common: Any,
) -> Sweep:
    """Let the same robots learn at each setting. Of each run only the final average reward is kept.

    settings: parameters of `Agent`, by name; robots: how many at each; common: parameters for all settings
    seed: fixes everything. A robot's random numbers depend on it and on the robot's number alone, so they are the same
    at all settings, and in every other sweep with this seed
    steps and the rest are those of `compare`. Raises ValueError as `compare` does, and if there are no settings
    """
    for name in common:
        check_name(name, [*names_of(sweep), *SETTINGS], "setting", "sweep")
    all_settings = [{**common, **its} for its in settings]
    if not all_settings:
        raise ValueError("a sweep needs at least one setting")
    robots = check_count("robots", robots)
    seed = check_count("seed", seed, least=0)
    check_jobs(n_jobs)
    world, env, robot = tried(world, engine=engine, realism=realism)
    length = length_of(env, steps, episodes)
    seeds = np.random.SeedSequence(seed).spawn(robots)
    jobs = {}
    for i, its in enumerate(all_settings):
        learner(env, its)  # a wrong setting is refused before anything runs
        for first in range(0, robots, AT_ONCE):
            some = seeds[first : first + AT_ONCE]
            jobs[i, first] = partial(_finals, world, its, length, some, robot)
    scores = np.empty((len(all_settings), robots))
    threads = isinstance(world, SampleModel)
    with progress_bar(scores.size, progress, delay=0, unit="robot") as shown:
        for (i, first), finals in in_parallel(jobs, threads, n_jobs):
            scores[i, first : first + len(finals)] = finals
            shown.update(len(finals))
    return Sweep(all_settings, scores)


def _finals(
    world: World,
    settings: Settings,
    length: Settings,
    seeds: Sequence[Seed],
    robot: Settings,
) -> list[float]:
    """The final average reward of each robot."""
    finals = []
    for its_seed in seeds:
        history = repetition(world, settings, length, its_seed, **robot)
        finals.append(history.final_average_reward)
    return finals
