"""What the report needs of an experiment once its repetitions are gone."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy import stats

from paper.experiments import Experiment, Length
from paper.worlds import lucky_pairs
from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.statistics import Anova, Pair, Tukey
from rlrobot_edu.models.diagnosis import Diagnosis
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.task.reward_parts import gripper_to_object
from rlrobot_edu.task.task import Task

SHUTTLES = (2.0, 4.5)  # (5 − 1) / 2 and (10 − 1) / 2: what to and fro before the object pays an arm a step
NEAR = 0.25  # a final average so close to one of them counts as of a shuttle

Finals = Mapping[str, np.ndarray]


@dataclass(frozen=True)
class Stuck:
    """The last episode of an arm that shuttles: distance to the object [m] before and after each step, and rewards."""

    label: str
    final: float
    distances: np.ndarray
    rewards: np.ndarray


@dataclass(frozen=True)
class Outcome:
    """The outcome of an experiment.

    final: by length and label, the final average reward of each repetition; pairs: of Tukey's test, by length
    section: its part of the report; seconds: of computing, on all cores together
    optimum, diagnosis: of its model; lucky: by label, the share of all steps in each of the
        model's lucky loops, array (loops,)
    stuck: an arm that shuttles, if there is one
    """

    experiment: Experiment
    final: Mapping[Length, Finals]
    pairs: Mapping[Length, tuple[Pair, ...]]
    seconds: float
    section: str = ""
    optimum: float | None = None
    diagnosis: Diagnosis | None = None
    lucky: Mapping[str, np.ndarray] | None = None
    stuck: Stuck | None = None

    @classmethod
    def of(cls, experiment: Experiment, result: Comparison, section: str = "") -> "Outcome":
        """What is kept of a finished comparison."""
        final = {length: shortened(result, length).final for length in experiment.lengths}
        model = result.world if isinstance(result.world, SampleModel) else None
        return cls(
            experiment, final, {length: Tukey.of(groups).pairs for length, groups in final.items()},
            sum(float(runs.seconds.sum()) for runs in result.groups.values()), section,
            optimum=result.optimum, diagnosis=model and model.diagnose(),
            lucky=model and {label: _shares(runs, lucky_pairs(model)) for label, runs in result.groups.items()},
            stuck=_stuck(result) if experiment.task.startswith("arm") and model is None else None,
        )  # fmt: skip

    @property
    def longest(self) -> Length:
        """The length that was run."""
        return self.experiment.lengths[-1]

    def means(self, length: Length | None = None) -> dict[str, float]:
        """Mean final average reward by label."""
        return {label: float(x.mean()) for label, x in self.final[length or self.longest].items()}

    def pair(self, first: str, second: str, length: Length | None = None) -> tuple[float, float]:
        """Mean of the first less that of the second method, and p of Tukey's test."""
        pair = next(p for p in self.pairs[length or self.longest] if {p.first, p.second} == {first, second})
        return (pair.difference if pair.first == first else -pair.difference), pair.p


def shortened(result: Comparison, length: Length) -> Comparison:
    """The comparison of the same agents, stopped sooner."""
    groups = {label: Runs(length.beginning(history) for history in runs) for label, runs in result.groups.items()}
    return Comparison(result.world, groups)


def interval(groups: Finals) -> float:
    """Half the width of Tukey's simultaneous 95 % intervals of the differences; the groups have one size."""
    anova = Anova.of(list(groups.values()))
    return half_width(anova, len(next(iter(groups.values()))))


def half_width(anova: Anova, n: int) -> float:
    """The same from an analysis of variance with `n` repetitions a group."""
    critical = stats.studentized_range.ppf(0.95, anova.df_between + 1, anova.df_within)
    return float(critical) * float(np.sqrt(anova.ms_within / n))


def significant_with(groups: Finals, n: int, draws: int = 2000) -> dict[frozenset, float]:
    """How often Tukey's test finds each pair of methods significant (p < 0.05) in only `n` of our repetitions.

    Draws the `n` repetitions of each method anew each time, without replacement.
    """
    rng, labels = np.random.default_rng(0), list(groups)
    drawn = {label: rng.permuted(np.tile(groups[label], (draws, 1)), axis=1)[:, :n] for label in labels}
    within = np.mean([drawn[label].var(axis=1, ddof=1) for label in labels], axis=0)
    critical = stats.studentized_range.ppf(0.95, len(labels), len(labels) * (n - 1))
    shares = {}
    for i, first in enumerate(labels):
        for second in labels[i + 1 :]:
            difference = np.abs(drawn[first].mean(axis=1) - drawn[second].mean(axis=1))
            shares[frozenset((first, second))] = float(np.mean(difference > critical * np.sqrt(within / n)))
    return shares


def shuttles(final: np.ndarray) -> float:
    """Share of the final averages that lie at one of the two shuttles."""
    return float(np.mean(np.abs(final[:, None] - np.array(SHUTTLES)).min(axis=1) < NEAR))


def _shares(runs: Runs, pairs: np.ndarray) -> np.ndarray:
    """Share of all steps that were taken in each of these pairs."""
    visits = np.zeros(runs[0].size.n_states * runs[0].size.n_actions)
    for history in runs:
        visits[history.learned.pair] += history.learned.visits
    return visits[pairs] / max(1, sum(map(len, runs)))


def _stuck(result: Comparison) -> Stuck | None:
    """The first agent that ended at a shuttle: its last episode, done once more by the same actions."""
    for level in SHUTTLES:
        for label, runs in result.groups.items():
            for history in runs:
                if history.a is not None and abs(history.final_average_reward - level) < NEAR:
                    return _replayed(result.world, label, history)
    return None


def _replayed(task: Task, label: str, history) -> Stuck | None:
    last = slice(len(history) - task.episode_steps, None)
    env = make_env(task)
    readings = [env.reset()[1]["readings"]]
    rewards = []
    for a in history.a[last]:
        _, r, _, _, info = env.step(int(a))
        readings.append(info["readings"])
        rewards.append(r)
    env.close()
    if not np.array_equal(rewards, history.rewards[last]):  # another arm than the one that learned
        return None
    distances = np.array([gripper_to_object(reading) for reading in readings])
    return Stuck(label, history.final_average_reward, distances, np.array(rewards))
