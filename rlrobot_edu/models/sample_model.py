"""A sample model: a world that answers (s, a) with what was once recorded there, as often as it was recorded."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from rlrobot_edu.files import load_arrays, save_arrays

if TYPE_CHECKING:
    from rlrobot_edu.models.diagnosis import Diagnosis
    from rlrobot_edu.models.model_env import SampleModelEnv
    from rlrobot_edu.models.recording import Recording

UNSEEN = ("uniform", "stay", "siblings", "start")
ARRAYS = ("offsets", "s_next", "r", "terminated", "cumulative", "starts", "rewards")


@dataclass(frozen=True)
class SampleModel:
    """The outcomes seen after each pair (s, a), in compressed rows: memory grows with what was seen.

    shape: bins of each input variable; n_actions: number of actions; pair (s, a) has the number s * n_actions + a
    offsets: array (pairs + 1,); the outcomes of pair p are rows offsets[p] to offsets[p + 1] of the next four
    s_next, r, terminated: arrays (outcomes,), what happened
    cumulative: array (outcomes,), how often this outcome of the pair, or one before it, was seen
    starts: array (episodes,), the state each recorded episode began in
    rewards: array of every reward that the task can give, increasing
    unseen: what a pair does that was never tried: ``uniform`` (the paper's: any state and any reward, all alike),
        ``siblings`` (an outcome of the states that share all inputs but one; uniform where these have none), or
        ``stay`` / ``start`` (the lowest reward, in the same state / back at a start: no plan will lean on the unknown)
    episode_steps: steps after which an episode is cut off, or None
    """

    shape: tuple[int, ...]
    n_actions: int
    offsets: np.ndarray
    s_next: np.ndarray
    r: np.ndarray
    terminated: np.ndarray
    cumulative: np.ndarray
    starts: np.ndarray
    rewards: np.ndarray
    unseen: str = "uniform"
    episode_steps: int | None = None

    def __post_init__(self) -> None:
        if self.unseen not in UNSEEN:
            raise ValueError(f"unseen must be one of {', '.join(UNSEEN)}, got {self.unseen!r}")

    @classmethod
    def from_recording(cls, recording: Recording, unseen: str = "uniform") -> SampleModel:
        """Count the transitions of a recording. Time and memory are in proportion to its length.

        Raises ValueError if `recording` is none or `unseen` is unknown.
        """
        if not hasattr(recording, "s_next"):
            raise ValueError(f"a sample model is made from a Recording (see rl.read_recording), not from {recording!r}")
        n_states, n_actions = recording.n_states, recording.n_actions
        values, reward_code = np.unique(recording.r, return_inverse=True)
        # One integer for each outcome (s, a, s', r, terminated), sorted by pair first.
        sizes = (n_states, n_actions, n_states, len(values), 2)
        if math.prod(sizes) > np.iinfo(np.int64).max:
            raise ValueError(f"{n_states} states, {n_actions} actions and {len(values)} rewards are too many to count")
        columns = (recording.s, recording.a, recording.s_next, reward_code, recording.terminated.astype(np.int64))
        outcome, count = np.unique(np.ravel_multi_index(columns, sizes), return_counts=True)
        s, a, s_next, code, terminated = np.unravel_index(outcome, sizes)
        pair = s * n_actions + a
        offsets = np.zeros(n_states * n_actions + 1, dtype=np.int64)
        np.cumsum(np.bincount(pair, minlength=n_states * n_actions), out=offsets[1:])
        total = np.cumsum(count)
        before_pair = np.concatenate(([0], total))[offsets[pair]]
        begins = np.flatnonzero(np.diff(recording.episode, prepend=recording.episode[0] - 1))
        return cls(
            shape=tuple(recording.shape),
            n_actions=n_actions,
            offsets=offsets,
            s_next=s_next,
            r=values[code],
            terminated=terminated.astype(bool),
            cumulative=total - before_pair,
            starts=np.array(recording.s[begins], dtype=np.int64),
            rewards=np.unique(recording.rewards).astype(float),
            unseen=unseen,
            episode_steps=recording.episode_steps,
        )

    def __repr__(self) -> str:
        seen = np.count_nonzero(np.diff(self.offsets))
        return f"<SampleModel of {self.n_states} states, {self.n_actions} actions: {seen} pairs seen>"

    @property
    def n_states(self) -> int:
        """Number of states."""
        return math.prod(self.shape)

    @property
    def r_max(self) -> float:
        """Largest reward that the task can give."""
        return float(self.rewards[-1])

    @property
    def count(self) -> np.ndarray:
        """How often each outcome was seen, array (outcomes,) of int."""
        first_of_pair = np.zeros(len(self.cumulative), dtype=bool)
        first_of_pair[self.offsets[:-1][np.diff(self.offsets) > 0]] = True
        return np.where(first_of_pair, self.cumulative, np.diff(self.cumulative, prepend=0))

    @property
    def pair(self) -> np.ndarray:
        """The pair s * n_actions + a that each outcome belongs to, array (outcomes,) of int."""
        return np.repeat(np.arange(len(self.offsets) - 1), np.diff(self.offsets))

    @property
    def pair_count(self) -> np.ndarray:
        """How often each pair was tried, array (n_states, n_actions) of int."""
        count = np.bincount(self.pair, weights=self.count, minlength=len(self.offsets) - 1)
        return count.astype(np.int64).reshape(self.n_states, self.n_actions)

    def outcomes(self, s: int, a: int) -> list[tuple[int, float, bool, int]]:
        """What was seen after (s, a): a list of (s', r, terminated, count)."""
        rows = slice(*self.offsets[s * self.n_actions + a :][:2])
        columns = (self.s_next[rows], self.r[rows], self.terminated[rows], np.diff(self.cumulative[rows], prepend=0))
        return [(int(s), float(r), bool(t), int(n)) for s, r, t, n in zip(*columns, strict=True)]

    def environment(self, seed: int | np.random.SeedSequence | None = None) -> SampleModelEnv:
        """The model as a Gymnasium environment (``rl.make_env(model, seed)`` calls this)."""
        from rlrobot_edu.models.model_env import SampleModelEnv

        return SampleModelEnv(self, seed)

    def diagnose(self, few: int = 3) -> Diagnosis:
        """What the model does not know, and where it may promise too much."""
        from rlrobot_edu.models.diagnosis import diagnose

        return diagnose(self, few)

    def save(self, path: str | Path) -> None:
        """Write the model to one ``.npz`` file, whole or not at all."""
        about = {name: getattr(self, name) for name in ("shape", "n_actions", "unseen", "episode_steps")}
        save_arrays(path, "sample model", about, {name: getattr(self, name) for name in ARRAYS})

    @classmethod
    def load(cls, path: str | Path) -> SampleModel:
        """The model that `save` wrote. Raises ValueError if the file is damaged or of another kind."""
        about, arrays = load_arrays(path, "sample model")
        try:
            return cls(**{**about, "shape": tuple(about["shape"])}, **arrays)
        except (ValueError, KeyError, TypeError) as error:
            raise ValueError(f"{path}: this model was written by another version of the toolkit") from error
