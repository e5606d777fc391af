"""A world made of the rows of a recording, parts of recordings, and how much less the robot pays than a model."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.worlds.tapes import with_action
from rlrobot_edu import Agent, Recording, SampleModel, learn, make_env
from rlrobot_edu.learning.transitions import Transitions

Row = tuple[int, int, float, int]  # s, a, r, s'
Sample = Callable[[Sequence[Row], int, int, float], tuple[int, float] | None]


def rows_of(recording: Recording) -> list[Row]:
    """The recording as a list of rows (s, a, r, s')."""
    columns = (recording.s, recording.a, recording.r, recording.s_next)
    return list(zip(*(column.tolist() for column in columns), strict=True))


class RowWorld:
    """A world that answers with rows of a recording, in the course's short words.

    recording: the rows; sample: the learner's function that draws one of them; seed: of what is random
    reset() -> state; step(action) -> state, reward, terminated, truncated. It starts where the recording does, and its
    episodes do not end. A pair that was never tried keeps the state and pays the task's lowest reward.
    """

    def __init__(self, recording: Recording, sample: Sample, seed: int = 0) -> None:
        self.rows, self.sample, self.s = rows_of(recording), sample, int(recording.s[0])
        self.shape, self.n_actions = (
            recording.source.states.shape,
            recording.source.actions.n,
        )
        self.r_max, self.r_min = (
            max(recording.source.rewards),
            min(recording.source.rewards),
        )
        self._start, self._rng = self.s, np.random.default_rng(seed)

    def reset(self) -> int:
        """Start anew; returns the first state."""
        self.s = self._start
        return self.s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        outcome = self.sample(self.rows, self.s, a, self._rng.random())
        self.s, r = (self.s, self.r_min) if outcome is None else outcome
        return self.s, r, False, False


def part(recording: Recording, chosen: slice | np.ndarray) -> Recording:
    """Some rows of a recording, as a recording; chosen: a slice, or an array (n,) of bool."""
    columns = (column[chosen] for column in recording.transitions)
    return Recording(Transitions(*columns), recording.source, recording.task)


def without_loops(recording: Recording) -> Recording:
    """The recording without the rows of the pairs that `diagnose()` suspects."""
    n_actions = recording.source.actions.n
    loops = SampleModel.from_recording(recording).diagnose().loops
    pairs = [s * n_actions + a for loop in loops for s, a in loop.pairs]
    return part(recording, ~np.isin(recording.s * n_actions + recording.a, pairs))


class Gap(NamedTuple):
    """What the same agents earn a step in a model and on the robot, arrays (n,)."""

    model: np.ndarray
    robot: np.ndarray

    @property
    def mean(self) -> float:
        """How much more the model pays, on average."""
        return float((self.model - self.robot).mean())

    @property
    def half(self) -> float:
        """Half of the 95 % interval of that mean."""
        return mean_and_half(self.model - self.robot)[1]


def measure_gap(
    models: Sequence[SampleModel], task: str, *, lesson: int, exam: int
) -> Gap:
    """Let one agent learn in each model, and see what it earns there and on the robot, when it learns no more.

    models: of `task`; lesson: steps in which it learns; exam: steps in which it is measured, on the robot (in the
    model, where they cost nothing, fifty times as many)
    """
    earned = []
    for seed, model in enumerate(models):
        agent = Agent(model, seed=seed)
        learn(agent, make_env(model, seed=seed), steps=lesson, progress=False)
        still = agent.frozen()
        with make_env(task, seed=seed) as robot:
            exams = ((make_env(model, seed=1000 + seed), 50 * exam), (robot, exam))
            earned.append(
                [
                    learn(still, env, n, progress=False).rewards.mean()
                    for env, n in exams
                ]
            )
    return Gap(*np.array(earned).T)
