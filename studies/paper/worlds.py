"""Worlds that show a cause: a sample model that differs from the paper's in one thing."""

import dataclasses

import gymnasium
import numpy as np

from rlrobot_edu.models.model_env import SampleModelEnv
from rlrobot_edu.models.sample_model import SampleModel


def lucky_pairs(model: SampleModel) -> np.ndarray:
    """Numbers of the pairs (s, a) in which `diagnose()` sees a well-rewarded loop that rests on few samples."""
    pairs = [
        s * model.n_actions + a
        for loop in model.diagnose().loops
        for s, a in loop.pairs
    ]
    return np.array(sorted(pairs), dtype=np.intp)


def without_lucky_loops(model: SampleModel, unseen: str = "uniform") -> SampleModel:
    """The model as if these pairs had never been tried; then they do what every unknown pair does, `unseen`."""
    keep = ~np.isin(model.pair, lucky_pairs(model))
    outcomes = np.bincount(model.pair[keep], minlength=len(model.offsets) - 1)
    columns = {
        name: getattr(model, name)[keep]
        for name in ("s_next", "r", "terminated", "cumulative")
    }
    return dataclasses.replace(
        model, offsets=np.append(0, np.cumsum(outcomes)), unseen=unseen, **columns
    )


class PreviousAction(gymnasium.Wrapper):
    """A sample model as the paper's Q-learning met it: s' is drawn with the action *before* the one just selected.

    env: the sample model's environment. The reward is then looked up as the paper's models keep it, in a table
    R(s, a, s') with the new action: one of the rewards that were seen there; any of the task's where none was.
    The first step of an episode has no action before it and draws with its own.
    """

    def __init__(self, env: SampleModelEnv) -> None:
        super().__init__(env)
        model, self._rewards, self._last = env.model, {}, None
        for pair, s_next, r, n in zip(
            model.pair, model.s_next, model.r, model.count, strict=True
        ):
            self._rewards.setdefault(
                (*divmod(int(pair), model.n_actions), int(s_next)), []
            ).extend([float(r)] * int(n))
        self._any = [float(r) for r in model.rewards]

    def reset(self, **options):
        """Begin an episode."""
        self._last = None
        return self.env.reset(**options)

    def step(self, action):
        """Go on with the last action, and be rewarded as if it had been this one."""
        s, last = self.env.state, action if self._last is None else self._last
        self._last = action
        observation, _, terminated, truncated, info = self.env.step(last)
        rewards = self._rewards.get((s, action, self.env.state), self._any)
        r = rewards[int(self.env.np_random.random() * len(rewards))]
        return observation, r, terminated, truncated, info
