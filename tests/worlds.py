"""Small worlds for the tests: random Markov decision processes and hand-made recordings."""

from __future__ import annotations

import gymnasium
import numpy as np

from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.variables import InputVariable, OutputVariable


class RandomWorld(gymnasium.Env):
    """A random MDP with `shape` states: every (s, a) leads to one of a few states, some of them terminal."""

    def __init__(self, shape=(3, 2, 2), n_actions=3, seed=0, p_end=0.0, r_max=1.0):
        rng = np.random.default_rng(seed)
        self.shape, self.n_states, self.r_max = shape, int(np.prod(shape)), r_max
        self.observation_space = gymnasium.spaces.MultiDiscrete(shape)
        self.action_space = gymnasium.spaces.Discrete(n_actions)
        self.successors = rng.integers(
            self.n_states, size=(self.n_states, n_actions, 3)
        )
        self.rewards = rng.normal(size=(self.n_states, n_actions, 3))
        self.p_end = p_end
        self.np_random = np.random.default_rng(seed + 1)
        self.state = None

    def _seen(self):
        return np.array(np.unravel_index(self.state, self.shape)), {}

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.state = 0
        return self._seen()

    def step(self, a):
        k = self.np_random.integers(3)
        r, self.state = (
            self.rewards[self.state, a, k],
            int(self.successors[self.state, a, k]),
        )
        return (
            self._seen()[0],
            float(r),
            bool(self.np_random.random() < self.p_end),
            False,
            {},
        )


def small_source(shape=(2, 3), n_actions=2, rewards=(-1.0, 0.0, 5.0)):
    """What a recording must know, for states of this shape."""
    states = StateSpace(
        [InputVariable(f"input_{i}", values=range(n)) for i, n in enumerate(shape)]
    )
    actions = ActionSpace([OutputVariable("action", values=range(n_actions))])
    return Source("small", states, actions, rewards)


def recording_of(rows, **source):
    """A Recording of rows (s, a, r, s', terminated); a new episode begins where the states do not join up."""
    s, a, r, s_next, terminated = (
        np.array(column) for column in zip(*rows, strict=True)
    )
    terminated = terminated == 1
    truncated = np.append(s[1:] != s_next[:-1], False) & ~terminated
    return Recording(
        Transitions(s, a, r, s_next, terminated, truncated), small_source(**source)
    )


def same_histories(one, two):
    """Whether two comparisons hold the same numbers to the last bit."""
    assert list(one) == list(two)
    for label in one:
        assert len(one[label]) == len(two[label])
        for x, y in zip(one[label], two[label], strict=True):
            assert all(
                np.array_equal(getattr(x, n), getattr(y, n))
                for n in ("rewards", "q", "visits", "terminated")
            )
    return True
