"""A world made of the rows of a recording: the learner's own model."""

from collections.abc import Callable, Sequence

import numpy as np

from rlrobot_course.tapes import with_action
from rlrobot_edu.models.recording import Recording

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
        self.shape, self.n_actions = recording.source.states.shape, recording.source.actions.n
        self.r_max, self.r_min = max(recording.source.rewards), min(recording.source.rewards)
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
