"""A sample model as a Gymnasium environment."""

from collections.abc import Iterator
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.compiled_loop import NEVER, make_run, run_slices
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.sample_model import UNSEEN, SampleModel
from rlrobot_edu.models.sampling import Tables, begin, draw_outcome, draw_start, outcome
from rlrobot_edu.seeds import ENVIRONMENT, generator
from rlrobot_edu.task.messages import existing

Info = dict[str, Any]


class SampleModelEnv(gymnasium.Env[Any, Any]):
    """A SampleModel to act in.

    An observation is the bins of all inputs, an array (n_inputs,) of int in a `MultiDiscrete` space; an
    action is a number in a `Discrete` space. After (s, a) comes one of the outcomes (s', r) that were
    recorded there, each as often as it was seen, or what the model's `unseen` says. ``info["state"]`` is the
    number of the state. An episode begins in one of the recorded starts. It ends where a recorded one
    terminated, or is cut off after `episode_steps` or `time_limit` of the model.

    Parameters
    ----------
    model : SampleModel
        What is acted in.
    seed : int or numpy.random.SeedSequence, optional
        Makes the environment repeatable.

    Attributes
    ----------
    state : int or None
        Number of the present state, None before the first reset.
    """

    def __init__(self, model: SampleModel, seed: int | np.random.SeedSequence | None = None):
        self.model = model
        self.r_max = model.r_max
        self.episode_steps = model.episode_steps
        self._max_episode_steps = model.time_limit  # Gymnasium's word for it
        self.observation_space: gymnasium.Space[Any] = gymnasium.spaces.MultiDiscrete(list(model.shape))
        self.action_space = gymnasium.spaces.Discrete(model.n_actions)
        self.np_random = generator(seed, ENVIRONMENT)
        self.state: int | None = None
        self.episode_step = 0
        limit = min(model.episode_steps or NEVER, model.time_limit or NEVER)
        numbers = {"shape": np.array(model.shape, dtype=np.int64), "unseen": UNSEEN.index(model.unseen)}
        parts = {**vars(model), **numbers, "episode_steps": limit, "time_limit": limit}
        self._tables: Any = Tables(**{name: part for name, part in parts.items() if name != "task"})

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[NDArray[np.int64], Info]:
        """Start an episode in one of the recorded starts."""
        if seed is not None:
            self.np_random = generator(seed, ENVIRONMENT)
        self.episode_step = 0
        return self.arrive(draw_start(self._tables, self.np_random.random()))

    def step(self, action: int) -> tuple[NDArray[np.int64], float, bool, bool, Info]:
        """Answer with one of the outcomes that were seen after this state and action.

        Raises ValueError for an action that there is not, gymnasium's ResetNeeded before the first reset.
        """
        if self.state is None:
            raise gymnasium.error.ResetNeeded("call reset() before the first step()")
        s = existing("state", self.state, self.model.n_states)
        a = existing("action", action, self.model.n_actions)
        s_next, r, terminated = draw_outcome(self._tables, s, a, *self.np_random.random(2))
        self.episode_step += 1
        truncated = not terminated and self.episode_step >= self._tables.episode_steps
        observation, info = self.arrive(s_next)
        return observation, float(r), bool(terminated), truncated, info

    def learn_compiled(self, agent: Agent, log: Transitions, episodes: int | None) -> Iterator[int]:
        """Run the loop of learning compiled, in slices: each yields its number of steps, see `make_run`."""
        return run_slices(self, make_run(agent.method, begin, outcome), self._tables, agent, log, episodes)

    def arrive(self, state: int) -> tuple[NDArray[np.int64], Info]:
        """Be in `state`; returns what is seen there."""
        self.state = int(state)
        return np.array(np.unravel_index(self.state, self.model.shape), dtype=np.int64), {"state": self.state}
