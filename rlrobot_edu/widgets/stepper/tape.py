"""What happened while an agent learned, recorded so that it can be shown forwards and backwards."""

from __future__ import annotations

import sys
from collections import deque
from typing import Any, NamedTuple, Protocol

import gymnasium
import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import Step, steps
from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.widgets.stepper.symbols import NEXT, VISITED, Symbols, in_symbols

PATH = 60  # steps in the trail that is drawn behind a robot


class EnvironmentView(Protocol):
    """A view of an environment: `look` keeps what can be seen now; `look_data` and `draw` show it later.

    heading: what it shows, in words
    """

    heading: str

    def look(self, s: int) -> Any:
        """The view while the environment is in state `s`."""

    def constant_data(self) -> dict[str, Any]:
        """What worlds.js needs once; ``kind`` is which of its pictures it is."""

    def look_data(self, look: Any) -> Any:
        """What worlds.js needs of a look; None if the number of the state is enough."""

    def draw(self, ax: Axes, tape: Tape) -> None:
        """Draw the look at the position of `tape`, the path to it, and the values of the places there."""


class Change(NamedTuple):
    """Entries of a table that a step changed: arrays (n,) of their flat positions, old and new values."""

    where: np.ndarray
    old: np.ndarray
    new: np.ndarray

    @classmethod
    def between(cls, before: np.ndarray, after: np.ndarray) -> Change:
        """What differs between two tables of the same shape."""
        where = np.flatnonzero(before != after)
        return cls(where, before.flat[where], after.flat[where])


class Frame(NamedTuple):
    """One step and all that is needed to show it.

    step: the transition, see `Step`; episode, number: of the step within its episode, both from 1
    start, look: what could be seen as the episode began (None if that was earlier), and after the step
    q_sa, q_next: Q(s, a) and the value of what follows, as the update sees them; q_sa_new: Q(s, a) after it
    best: the best action in s′ as the update sees it
    p_next: π(·|s′) as the update sees it
    e_sa: the trace of (s, a) before the visit; q_old: TOSL's memory of the step before
    traces: those by which the update learns, before they fade: flat positions (n,) and values (n,)
    q_change, e_change: all that the step changed
    """

    step: Step
    episode: int
    number: int
    start: Any
    look: Any
    q_sa: float
    q_next: float
    q_sa_new: float
    best: int
    p_next: np.ndarray
    e_sa: float
    q_old: float
    traces: tuple[np.ndarray, np.ndarray]
    q_change: Change
    e_change: Change


class _Watched(gymnasium.Wrapper):
    """The environment itself; it keeps the view at its last reset."""

    def __init__(self, env: gymnasium.Env, view: EnvironmentView) -> None:
        super().__init__(env)
        self._view = view
        self.start: Any = None

    def reset(self, **options: Any) -> tuple[Any, dict[str, Any]]:
        observation, info = self.env.reset(**options)
        self.start = self._view.look(state_numbers(self.env)(observation))
        return observation, info


class Tape:
    """The last `length` steps of a learning process, and the tables Q and e at the position shown.

    t: number of steps up to the position shown; end: number of steps taken. The agent stands at the end.
    q, e, visits: arrays (n_states, n_actions), as they were at position t, to the last bit; e has faded already
    Raises ValueError if agent and environment do not fit.
    """

    def __init__(
        self, agent: Agent, env: gymnasium.Env, view: EnvironmentView, length: int
    ) -> None:
        self.agent = agent
        self.view = view
        self.keep = length
        self._env = _Watched(env, view)
        self._walk = steps(agent, self._env, sys.maxsize)
        self._frames: deque[Frame] = deque(maxlen=length)
        self.q = agent.q.copy()
        self.e = agent.e.copy()
        self.visits = agent.visits.copy()
        self.t = 0
        self.end = 0
        self._stands = self._standing()
        self._take()
        self.first_look = self._at(1).start

    @property
    def _dropped(self) -> int:
        """How many steps are no longer kept."""
        return self.end - len(self._frames)

    @property
    def first(self) -> int:
        """The earliest position that can still be shown."""
        return self._dropped + 1 if self._dropped else 0

    @property
    def frame(self) -> Frame | None:
        """The step that led to the position shown; None before the first one."""
        return self._at(self.t) if self.t else None

    def forward(self) -> None:
        """Show the next step; at the end of the tape the agent takes a new one."""
        if self.t == self.end:
            self._take()
        self.t += 1
        frame = self._at(self.t)
        self.q.flat[frame.q_change.where] = frame.q_change.new
        self.e.flat[frame.e_change.where] = frame.e_change.new
        self.visits[frame.step.s, frame.step.a] += 1

    def back(self) -> None:
        """Show the position one step earlier. The agent does not forget what it has learned."""
        frame = self._at(self.t)
        self.q.flat[frame.q_change.where] = frame.q_change.old
        self.e.flat[frame.e_change.where] = frame.e_change.old
        self.visits[frame.step.s, frame.step.a] -= 1
        self.t -= 1

    def go(self, t: int) -> None:
        """Show position `t`, forwards or back. Raises ValueError if it is no longer kept."""
        if t < self.first:
            raise ValueError(
                f"there is no step {t} to show: the earliest that is kept is {self.first} (keep= sets how many)"
            )
        while self.t < t:
            self.forward()
        while self.t > t:
            self.back()

    def looks(self) -> list[Any]:
        """What could be seen in the latest steps of this episode, up to the position shown."""
        if self.t == 0:
            return [self._at(1).start]
        latest_first = []
        for t in range(self.t, max(self.t - PATH, self._dropped), -1):
            frame = self._at(t)
            latest_first.append(frame.look)
            if frame.number == 1:
                latest_first.append(frame.start)
                break
        return latest_first[::-1]

    def recent(self, limit: int) -> tuple[list[int], list[int]]:
        """The states that were visited and the actions that were taken most recently, the latest first."""
        if self.t == 0:
            return [self._at(1).step.s], []
        states: dict[int, None] = {}  # an ordered set, as is
        actions: dict[int, None] = {}
        for t in range(self.t, self._dropped, -1):
            step = self._at(t).step
            states |= {step.s_next: None, step.s: None}
            actions[step.a] = None
            if len(states) >= limit:
                break
        return list(states)[:limit], list(actions)[:limit]

    def since(self, t: int) -> list[Frame]:
        """The frames of the steps after position `t`, as far as they are kept."""
        return [self._at(t) for t in range(max(t, self._dropped) + 1, self.end + 1)]

    def _at(self, t: int) -> Frame:
        return self._frames[t - 1 - self._dropped]

    def _standing(self) -> tuple[int, int | None]:
        """A mark by which the tape notices that agent or environment has moved on without it."""
        return int(self.agent.visits.sum()), getattr(self._env.unwrapped, "state", None)

    def _take(self) -> None:
        """Let the agent take one step and record it. The position shown must be the end."""
        if self._standing() != self._stands:
            raise RuntimeError(
                "the agent or its world has been used elsewhere since the last step; make a new rl.Stepper(agent, env)"
            )
        agent = self.agent
        begins = agent.pending is None
        q_old = float(agent.memory.now.q_old)
        last = self._at(self.end) if self.end else None
        before = np.zeros(0, dtype=np.intp) if begins else self._remembered()
        step = next(self._walk, None)
        if step is None:
            raise RuntimeError(
                "the world stopped with an error before; make a new rl.Stepper(agent, env)"
            )
        s, a = step.s, step.a
        frame = Frame(
            step,
            episode=(last.episode if last else 0) + begins,
            number=1 if begins else last.number + 1,
            start=self._env.start if begins else None,
            look=self.view.look(step.s_next),
            q_sa=float(self.q[s, a]),
            q_next=self._value_of_next(step),
            q_sa_new=float(agent.q[s, a]),
            best=int(self.q[step.s_next].argmax()),
            p_next=agent.probabilities.copy(),
            e_sa=0.0 if begins else float(self.e[s, a]),
            q_old=0.0 if begins else q_old,
            traces=self._traces(before, s, a, begins),
            q_change=Change.between(self.q, agent.q),
            e_change=Change.between(self.e, agent.e),
        )
        self._frames.append(frame)
        self.end += 1
        self._stands = self._standing()

    def _remembered(self) -> np.ndarray:
        """Flat positions of the pairs whose traces are still there once the agent has visited its next pair."""
        where = np.flatnonzero(self.e)
        pending = self.agent.pending
        memory = self.agent.memory
        register = memory.register[: memory.now.register_size]
        is_full = len(register) == len(memory.register)
        if pending is None or not is_full or pending[0] in register:
            return where
        states = where // self.e.shape[1]
        return where[states != register[-1]]  # a new state replaces the oldest one

    def _traces(
        self, before: np.ndarray, s: int, a: int, begins: bool
    ) -> tuple[np.ndarray, np.ndarray]:
        """The traces of the pairs `before`, and of (s, a) as its visit leaves it."""
        trace = self._symbols().trace
        if not trace:
            return before[:0], np.zeros(0)
        pair = s * self.e.shape[1] + a
        others = before[before != pair]
        e_sa = 0.0 if begins else float(self.e[s, a])
        new = VISITED[trace](e_sa, self.agent.parameters.alpha)
        return np.append(others, pair), np.append(self.e.flat[others], new)

    def _value_of_next(self, step: Step) -> float:
        """The value of s′ in the update: 0 once terminated, else what the algorithm defines."""
        if step.terminated:
            return 0.0
        value = NEXT[self._symbols().next]
        return value(self.q[step.s_next], step.a_next, self.agent.probabilities)

    def _symbols(self) -> Symbols:
        agent = self.agent
        return in_symbols(agent.method.algorithm.name, agent.parameters)
