"""A sample model as a Gymnasium environment."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete
from numpy.typing import NDArray

from rlrobot_edu.checks import check_index
from rlrobot_edu.jit.building import for_python
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.kernel_world import NEVER, KernelWorld
from rlrobot_edu.models.sample_model import UNSEEN, SampleModel
from rlrobot_edu.models.sampling import Tables, begin, draw_outcome, draw_start, outcome
from rlrobot_edu.seeds import ENVIRONMENT, generator

Info = dict[str, Any]


@suggests_keywords
class SampleModelEnv(gymnasium.Env[Any, Any]):
    """The world that a SampleModel remembers, as a Gymnasium environment.

    Parameters
    ----------
    model : SampleModel
        The model.
    seed : int or numpy.random.SeedSequence, optional
        Makes the environment repeatable.

    Attributes
    ----------
    state : int or None
        Number of the present state, None before the first `reset`.

    Notes
    -----
    - Observation: array (n_inputs,) of int64, the bin of each input
    - Action: number of an action, 0 to n_actions − 1
    - Info: ``state``, the number of the state
    - Next state and reward: one of the outcomes (s', r) that were seen after (s, a), each as often as it was seen; a
      pair that was never tried follows the model's `unseen`
    - Episode start: one of the recorded starts
    - Episode end: terminated where a recorded episode did; truncated after the model's `episode_steps` or `time_limit`
    """

    def __init__(
        self, model: SampleModel, seed: int | np.random.SeedSequence | None = None
    ):
        self.model = model
        self.r_max = model.r_max
        self.episode_steps = model.episode_steps
        # As in Gymnasium's TimeLimit: what records this environment takes its time limit from there
        self._max_episode_steps = model.time_limit
        bins = list(model.shape)
        self.observation_space: gymnasium.Space[Any] = MultiDiscrete(bins)
        self.action_space = Discrete(model.n_actions)
        self.np_random = generator(seed, ENVIRONMENT)
        self.state: int | None = None
        self.episode_step = 0
        # What comes first: the end of the task's episode or the time limit of the recording
        limit = min(model.episode_steps or NEVER, model.time_limit or NEVER)
        self._tables: Any = Tables(
            shape=np.array(model.shape, dtype=np.int64),
            n_actions=model.n_actions,
            offsets=model.offsets,
            s_next=model.s_next,
            r=model.r,
            terminated=model.terminated,
            cumulative=model.cumulative,
            starts=model.starts,
            rewards=model.rewards,
            unseen=UNSEEN.index(model.unseen),
            episode_steps=limit,
        )

    def reset(
        self, *, seed: int | None = None, options: Any = None
    ) -> tuple[NDArray[np.int64], Info]:
        """Start an episode in one of the recorded starts.

        Parameters
        ----------
        seed : int, optional
            Makes what follows repeatable; None continues the random numbers.
        options : dict, optional
            Not used; Gymnasium hands it over.

        Returns
        -------
        tuple
            The observation and the info.
        """
        if seed is not None:
            self.np_random = generator(seed, ENVIRONMENT)
        self.episode_step = 0
        start = for_python(draw_start)(self._tables, self.np_random.random())
        return self.arrive(start)

    def step(self, action: int) -> tuple[NDArray[np.int64], float, bool, bool, Info]:
        """Answer with one of the outcomes that were seen after this state and action.

        Parameters
        ----------
        action : int
            Number of the action, 0 to n_actions − 1.

        Returns
        -------
        tuple
            Observation, reward, terminated, truncated and info.

        Raises
        ------
        ValueError
            If there is no such action.
        gymnasium.error.ResetNeeded
            Before the first `reset`.
        """
        if self.state is None:
            raise gymnasium.error.ResetNeeded("call reset() before the first step()")
        s = check_index("state", self.state, self.model.n_states)
        a = check_index("action", action, self.model.n_actions)
        s_next, r, terminated = for_python(draw_outcome)(
            self._tables, s, a, *self.np_random.random(2)
        )
        self.episode_step += 1
        truncated = not terminated and self.episode_step >= self._tables.episode_steps
        observation, info = self.arrive(s_next)
        return observation, float(r), bool(terminated), truncated, info

    def kernel_world(self, steps: int) -> KernelWorld | None:
        """The model as a world of kernels, see `KernelEnv`; `learn` asks for it.

        Parameters
        ----------
        steps : int
            How many steps are to come.

        Returns
        -------
        KernelWorld or None
            None for a subclass, whose own `step` and `reset` are called in every step.
        """
        if type(self) is not SampleModelEnv:
            return None
        return KernelWorld(begin, outcome, self._tables)

    def arrive(self, s: int) -> tuple[NDArray[np.int64], Info]:
        """Take over the state that a compiled loop has reached.

        Parameters
        ----------
        s : int
            Number of the state.

        Returns
        -------
        tuple
            The observation and the info there.
        """
        self.state = int(s)
        bins = np.unravel_index(self.state, self.model.shape)
        return np.array(bins, dtype=np.int64), {"state": self.state}
