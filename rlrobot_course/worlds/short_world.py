"""Any environment with the short interface of the course, for a loop that the learner has written."""

import time
from typing import cast

import numpy as np

from rlrobot_course.worlds.tapes import with_action
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.learning.size import Env, Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.seeds import generator


class ShortWorld:
    """An environment whose `step` returns four values and `reset` one; it keeps what happens in it.

    env: an environment with states and actions that can be counted; seed: of the random numbers `u`

    reset() -> state; step(action) -> state, reward, terminated, truncated
    ended: whether the last step ended an episode
    u: a random number in [0, 1) for the selection that is due now. An agent of the library with the same seed draws the
        same numbers at the same moments, so it can be compared with a learner's functions to the last digit.
    """

    def __init__(self, env: Env, seed: int | np.random.SeedSequence = 0) -> None:
        self.env, self.size = env, Size.of(env)
        self.n_states, self.n_actions, self.r_max = (
            self.size.n_states,
            self.size.n_actions,
            self.size.r_max,
        )
        self.u, self._random, self._state_number = (
            0.0,
            generator(seed),
            state_numbers(env),
        )
        self._steps: list[tuple[int, int, float, int, bool, bool]] = []
        self.ended = False
        self._s, self._begin = 0, time.perf_counter()

    def __repr__(self) -> str:
        return f"a world of {self.n_states} states and {self.n_actions} actions, {self.age} steps old"

    @property
    def age(self) -> int:
        """How many steps have been taken."""
        return len(self._steps)

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self._s, self.u = self._state_number(self.env.reset()[0]), self._random.random()
        return self._s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        observation, reward, terminated, truncated, _ = self.env.step(a)
        s_next, r, self.u = (
            self._state_number(observation),
            float(cast(float, reward)),
            self._random.random(),
        )
        self._steps.append(
            (self._s, int(a), r, s_next, bool(terminated), bool(truncated))
        )
        self._s, self.ended = s_next, bool(terminated or truncated)
        return s_next, r, bool(terminated), bool(truncated)

    def random(self) -> float:
        """The number `u`: a loop that wants a generator for its selections can have this world as one."""
        return self.u

    def table(self) -> np.ndarray:
        """A new table of zeros, array (n_states, n_actions)."""
        return np.zeros((self.n_states, self.n_actions))

    def history(self, q: np.ndarray, name: str = "yours") -> History:
        """All that has happened here, as `rlrobot_edu.learn` returns it; q: what has been learned."""
        columns = zip(*self._steps, strict=True) if self._steps else [()] * 6
        kinds = (np.int32, np.int32, float, np.int32, np.bool_, np.bool_)
        transitions = Transitions(
            *(np.array(c, dtype=kind) for c, kind in zip(columns, kinds, strict=True))
        )
        visits = np.zeros(q.shape, dtype=np.int64)
        np.add.at(visits, (transitions.s, transitions.a), 1)
        return History(
            name,
            transitions,
            Learned.of(q, visits),
            time.perf_counter() - self._begin,
            self.size,
        )
