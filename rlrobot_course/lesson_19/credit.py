"""Which rewards each value of an agent is made of, by the very kernels by which it learned them."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from rlrobot_course.lesson_19.linear import Linear, plain
from rlrobot_edu.checks import check_count, check_index
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.algorithm import NO_ACTION
from rlrobot_edu.learning.loop import Step
from rlrobot_edu.learning.loop import steps as walk
from rlrobot_edu.learning.size import Env
from rlrobot_edu.learning.traces import forget


class Credit:
    """What each Q(s, a) is made of: a share of each reward.

    Parameters
    ----------
    steps : list of Step
        The steps that were learned from.
    q : array (n_states, n_actions)
        The values after the last step.

    Notes
    -----
    Where all values were 0 at first, ``q[s, a]`` is the sum of ``shares(s, a)``, but for rounding.
    """

    def __init__(self, steps: list[Step], q: np.ndarray, made_of: np.ndarray) -> None:
        self.steps, self.q, self._made_of = steps, q, made_of
        self.rewards = np.array([step.r for step in steps])

    def weights(self, s: int, a: int) -> np.ndarray:
        """By how much Q(s, a) would have grown with each reward: the derivatives, array (n_steps,).

        Parameters
        ----------
        s, a : int
            State and action.

        Returns
        -------
        array (n_steps,)
            Entry 0 is step 1: how much Q(s, a) would be larger if this step's reward had been larger by one, and all
            steps had stayed as they were.

        Raises
        ------
        ValueError
            If there is no such state or action.
        """
        check_index("state", s, self.q.shape[0])
        check_index("action", a, self.q.shape[1])
        made: Linear | float = self._made_of[s, a]
        return made.weights if isinstance(made, Linear) else np.zeros(len(self.steps))

    def shares(self, s: int, a: int) -> np.ndarray:
        """What each step has paid for Q(s, a): its weight times its reward.

        Parameters
        ----------
        s, a : int
            State and action.

        Returns
        -------
        array (n_steps,)
            The share of each step, from step 1 on.
        """
        shares: np.ndarray = self.weights(s, a) * self.rewards
        return shares

    def why(self, s: int, a: int, rather_than: int) -> str:
        """Why is action a worth more, or less, than another one in state s? The three steps that made most of it.

        Parameters
        ----------
        s, a, rather_than : int
            State and two actions.

        Returns
        -------
        str
            A sentence.
        """
        parted = self.shares(s, a) - self.shares(s, rather_than)
        most = [
            int(t) for t in np.argsort(-np.abs(parted), kind="stable")[:3] if parted[t]
        ]
        reasons = [f"step {t + 1} ({self._step(t)}) {parted[t]:+.3g}" for t in most]
        apart = f"Q({s}, {a}) − Q({s}, {rather_than}) = {self.q[s, a] - self.q[s, rather_than]:+.3g}"
        return f"{apart}. Most of it: {'; '.join(reasons) or 'no reward yet'}."

    def _step(self, t: int) -> str:
        step = self.steps[t]
        return f"action {step.a} in state {step.s} paid {step.r:g}"


def credit(agent: Agent, env: Env, steps: int) -> Credit:
    """Let `agent` learn in `env`, and find out from which rewards each of its values comes.

    Parameters
    ----------
    agent : Agent
        The learner, with any algorithm whose update only adds values and multiplies them by constants.
    env : gymnasium.Env
        Its world; it is reset first.
    steps : int
        How many steps.

    Returns
    -------
    Credit
        What each value is made of.

    Raises
    ------
    ValueError
        For an agent that plans.

    Notes
    -----
    Updates are linear in the rewards once the steps, the traces and the probabilities are given. So the agent's own
    kernel runs a second time, on numbers that remember from which rewards they come. Q-learning's maximum stays at
    the action that had it. What a bias or a temperature did to the choices is part of the steps, not of the credit.
    """
    check_count("steps", steps, least=1)
    if agent.method.planner:
        raise ValueError(
            "an agent that plans learns from imagined steps, too; credit is for those that do not plan"
        )
    m = _memory_of(agent)
    update, forget_traces = plain(agent.method.algorithm.update), plain(forget)
    taken: list[Step] = []
    for step in walk(agent, env, steps):
        if not taken or taken[-1].terminated or taken[-1].truncated:
            forget_traces(m)
        unit = np.zeros(steps)
        unit[len(taken)] = 1.0
        m.probabilities = agent.memory.probabilities
        a_next = NO_ACTION if step.a_next is None else step.a_next
        update(
            m,
            step.s,
            step.a,
            Linear(step.r, unit),
            step.s_next,
            a_next,
            step.terminated,
        )
        taken.append(step)
    return Credit(taken, agent.q.copy(), m.q)


def _memory_of(agent: Agent) -> Any:
    """What an update needs of an agent's memory, copied; its values can become `Linear`."""
    memory = agent.memory
    now = SimpleNamespace(
        q_old=float(memory.now.q_old), register_size=int(memory.now.register_size)
    )
    return SimpleNamespace(
        q=memory.q.astype(object), e=memory.e.copy(), register=memory.register.copy(), shape=memory.shape,
        parameters=memory.parameters, now=now, probabilities=memory.probabilities,
    )  # fmt: skip
