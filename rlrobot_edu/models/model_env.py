"""A sample model as a Gymnasium environment."""

from __future__ import annotations

import gymnasium
import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.jit import announce_compilation
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.sample_model import ARRAYS, UNSEEN, SampleModel
from rlrobot_edu.models.sampling import Tables, draw_outcome, draw_start, run


class SampleModelEnv(gymnasium.Env):
    """The world of a SampleModel: observations are the bins of each input, ``info["state"]`` the state's number.

    model: the SampleModel; seed: an int, a ``numpy.random.SeedSequence`` or None
    state: number of the present state, None before the first reset
    """

    metadata = {"render_modes": []}  # noqa: RUF012 (Gymnasium's own convention)

    def __init__(self, model: SampleModel, seed: int | np.random.SeedSequence | None = None):
        self.model = model
        self.r_max = model.r_max
        self.episode_steps = model.episode_steps
        self.render_mode = None
        self.observation_space = gymnasium.spaces.MultiDiscrete(model.shape)
        self.action_space = gymnasium.spaces.Discrete(model.n_actions)
        self.np_random = np.random.default_rng(seed)
        self.state: int | None = None
        self.episode_step = 0
        limits = np.array([UNSEEN.index(model.unseen), model.episode_steps or 0, model.n_actions])
        arrays = {name: getattr(model, name) for name in ARRAYS}
        self._tables = Tables(shape=np.array(model.shape, dtype=np.int64), limits=limits, **arrays)

    def reset(self, *, seed: int | None = None, options: dict | None = None) -> tuple[np.ndarray, dict]:
        """Start an episode in one of the recorded starts."""
        super().reset(seed=seed)
        self.state = int(draw_start(self._tables, self.np_random.random()))
        self.episode_step = 0
        return self._observation(), {"state": self.state}

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict]:
        """Answer with one of the outcomes that were seen after this state and action."""
        u, v = self.np_random.random(), self.np_random.random()
        s_next, r, terminated = draw_outcome(self._tables, self.state, int(action), u, v)
        self.state = int(s_next)
        self.episode_step += 1
        truncated = not terminated and self.episode_step == self.model.episode_steps
        return self._observation(), float(r), bool(terminated), truncated, {"state": self.state}

    def drive(self, agent: Agent, log: Transitions, episodes: int | None) -> int:
        """Run the whole learning loop compiled and fill `log`; returns the number of steps, see `sampling.run`."""
        announce_compilation(run)
        s, a = agent.pending or (0, -1)
        n, s, a, self.episode_step = run(
            self._tables, agent.memory, self.np_random, agent.rng, s, a, self.episode_step, log, episodes or 0
        )
        self.state = int(s)
        agent.pending = None if a < 0 else (int(s), int(a))
        return int(n)

    def _observation(self) -> np.ndarray:
        return np.array(np.unravel_index(self.state, self.model.shape), dtype=np.int64)
