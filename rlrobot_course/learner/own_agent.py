"""Agents of the library in which a function of the learner's takes the place of the library's, in plain Python.

A method of one's own, `rl.Method`, is compiled; what a learner writes in a lesson need not be such that it can be. Here
the library's agent goes through its step, and then the learner's numbers take the place of its own. So a stepper shows
them with the equations of the method.
"""

from collections.abc import Callable
from copy import deepcopy
from typing import Any

import numpy as np

import rlrobot_edu as rl

Table = np.ndarray
Update = Callable[..., float]
Choice = Callable[[Table, int], tuple[np.ndarray, np.ndarray]]
Draw = Callable[[np.ndarray, float], int]


class OwnUpdate(rl.Agent):
    """True online SARSA(λ) whose Q, traces and Q_old are what the learner's update makes of them.

    update: (q, e, q_old, s, a, r, s', a', terminated, α, γ, λ) -> new q_old, as in lesson 08
    task, settings: of the `Agent`
    """

    def __init__(self, update: Update, task: Any, **settings: Any) -> None:
        self._update = update
        super().__init__(task, "TOSL+SR", traces="full", **settings)

    def learn_step(
        self, s: int, a: int, r: float, s_next: int, terminated: bool
    ) -> tuple[int | None, float]:
        """As the agent's."""
        memory = self.memory
        q, e, q_old = memory.q.copy(), memory.e.copy(), float(memory.now.q_old)
        a_next, delta = super().learn_step(s, a, r, s_next, terminated)
        memory.q[:] = q
        memory.e[:] = e
        set_by = self.parameters
        step = (s, a, r, s_next, a_next or 0, terminated)
        memory.now.q_old = self._update(
            memory.q, memory.e, q_old, *step, set_by.alpha, set_by.gamma, set_by.lam
        )
        return a_next, delta


class OwnChoice(rl.Agent):
    """Q-learning with QBIASSR whose bias, probabilities and actions are those of the learner's functions.

    choice: (q, s) -> bias and probabilities of the actions, two arrays; draw: as in lesson 04
    task, settings: of the `Agent`
    """

    def __init__(self, choice: Choice, draw: Draw, task: Any, **settings: Any) -> None:
        self._choice = choice
        self._draw = draw
        super().__init__(task, "Q+QBIASSR", **settings)

    def begin_episode(self, s: int) -> int:
        """As the agent's."""
        u = self._next_random_number()
        super().begin_episode(s)
        return self._chosen(s, u)

    def learn_step(
        self, s: int, a: int, r: float, s_next: int, terminated: bool
    ) -> tuple[int | None, float]:
        """As the agent's."""
        u = self._next_random_number()
        a_next, delta = super().learn_step(s, a, r, s_next, terminated)
        if a_next is not None:
            a_next = self._chosen(s_next, u)
        return a_next, delta

    def _next_random_number(self) -> float:
        """The number by which the library will choose."""
        return float(deepcopy(self.rng).random())

    def _chosen(self, s: int, u: float) -> int:
        bias, probabilities = self._choice(self.q, s)
        self.memory.bias[:] = bias
        self.memory.probabilities[:] = probabilities
        return int(self._draw(probabilities, u))
