"""The learner: a method, its parameters, and what it has learned. It knows no robot and no picture."""

from __future__ import annotations

import math
import numbers
from pathlib import Path
from types import SimpleNamespace

import gymnasium
import numpy as np

from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.learning.memory import Memory, new_memory
from rlrobot_edu.learning.methods import ALGORITHMS, QBIASSR, SL, parse_method
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.step import begin_episode, learn_step, select
from rlrobot_edu.task.task import Task, load_task


def _check(name: str, value, domain: str, holds: bool) -> None:
    if not holds:
        raise ValueError(f"{name} must be {domain}, got {value!r}")


class Agent:
    """A tabular learning agent.

    world: a Task (or its name or path), a SampleModel, or any Gymnasium environment with discrete states and actions
    method: ``ALGORITHM+SELECTION``. Algorithms: Q (Q-learning), SARSA, SL (SARSA(λ)), TOSL (true online SARSA(λ)).
        Selections: SR (softmax regression), QBIASSR (Q-biased), EG (ε-greedy), EGLE (ε-greedy towards the least
        explored action), GREEDY, RANDOM
    alpha: learning rate in (0, 1]; gamma: discount rate in [0, 1); lam: decay of the traces in [0, 1]
    temperature: Boltzmann temperature > 0; epsilon: probability of exploring in [0, 1], for EG and EGLE
    traces: ``reduced`` (the paper's RETR) or ``full``; accumulating: SARSA(λ) adds to a trace instead of replacing it
    loop_evasion: raise the temperature in loops of low reward (LRLE)
    r_max: largest reward > 0, which normalises Q; taken from the task, or 1 for an environment without one
    seed: of the agent's own random numbers, an int or a ``numpy.random.SeedSequence``

    q: array (n_states, n_actions), the action values learned so far. Raises ValueError if a parameter is out of domain.
    """

    def __init__(
        self,
        world: Task | str | Path | gymnasium.Env | Size,
        method: str = "TOSL+QBIASSR",
        *,
        alpha: float = 0.1,
        gamma: float = 0.9,
        lam: float = 0.9,
        temperature: float = 1.0,
        epsilon: float = 0.1,
        traces: str = "reduced",
        accumulating: bool = False,
        loop_evasion: bool = True,
        r_max: float | None = None,
        seed: int | np.random.SeedSequence | None = None,
    ):
        algorithm, selection = parse_method(method)
        for name, value in (("alpha", alpha), ("gamma", gamma), ("lam", lam), ("temperature", temperature)):
            _check(name, value, "a number", isinstance(value, numbers.Real))
        size = Size.of(load_task(world) if isinstance(world, str | Path) else world)
        r_max = float(size.r_max if r_max is None else r_max)
        _check("alpha", alpha, "in (0, 1]", 0 < alpha <= 1)
        _check("gamma", gamma, "in [0, 1)", 0 <= gamma < 1)
        _check("lam", lam, "in [0, 1]", 0 <= lam <= 1)
        _check("temperature", temperature, "a finite number above 0", 0 < temperature < math.inf)
        _check("epsilon", epsilon, "in [0, 1]", 0 <= epsilon <= 1)
        _check("r_max", r_max, "a finite number above 0", 0 < r_max < math.inf)
        _check("traces", traces, "'reduced' or 'full'", traces in ("reduced", "full"))
        if accumulating and algorithm != SL:
            raise ValueError(f"accumulating traces are a variant of SARSA(lambda) only, not of {method}")
        self.method = method
        self.settings = {
            "alpha": alpha, "gamma": gamma, "lam": lam, "temperature": temperature, "epsilon": epsilon,
            "traces": traces, "accumulating": accumulating, "loop_evasion": loop_evasion, "r_max": r_max,
        }  # fmt: skip
        q_max = r_max / (1 - gamma)  # paper equation 11
        parameters = {
            "algorithm": algorithm, "selection": selection, "alpha": alpha, "gamma": gamma, "lam": lam,
            "temperature": temperature, "epsilon": epsilon, "q_scale": 100 / q_max,
            "accumulating": accumulating, "loop_evasion": loop_evasion,
        }  # fmt: skip
        self.seed = seed
        self.rng = np.random.default_rng(seed)
        self.memory: Memory = new_memory(size.shape, size.n_actions, parameters, traces == "full")
        self.pending: tuple[int, int] | None = None  # state and chosen action of an episode that still runs

    def __repr__(self) -> str:
        return f"<Agent {self.method}: {self.q.shape[0]} states, {self.q.shape[1]} actions, {self.visits.sum()} steps>"

    @property
    def shape(self) -> tuple[int, ...]:
        """Bins of each input variable."""
        return tuple(int(n) for n in self.memory.shape)

    @property
    def q(self) -> np.ndarray:
        """Action values, array (n_states, n_actions); the agent's own, not a copy."""
        return self.memory.q

    @property
    def visits(self) -> np.ndarray:
        """How often each pair was tried, array (n_states, n_actions) of int."""
        return self.memory.visits

    @property
    def policy(self) -> np.ndarray:
        """The best action in each state (the first one, where several are), array (n_states,) of int."""
        return self.q.argmax(axis=1)

    @property
    def bias(self) -> np.ndarray | None:
        """What QBIASSR last added to Q(s), array (n_actions,); None for other selections."""
        return self.memory.bias if self.memory.parameters.selection == QBIASSR else None

    @property
    def algorithm(self) -> str:
        """Name of the algorithm."""
        return ALGORITHMS[self.memory.parameters.algorithm]

    @property
    def keeps_traces(self) -> bool:
        """Whether the algorithm uses eligibility traces."""
        return self.memory.parameters.algorithm >= SL

    @property
    def e(self) -> np.ndarray:
        """Eligibility traces, array (n_states, n_actions)."""
        return self.memory.e

    @property
    def q_old(self) -> float:
        """TOSL: Q(s', a') as it was before the last update."""
        return float(self.memory.now.q_old)

    @property
    def parameters(self) -> SimpleNamespace:
        """The parameters."""
        return SimpleNamespace(**self.settings)

    def begin_episode(self, s: int) -> int:
        """Forget the traces and choose the first action, in state `s`."""
        begin_episode(self.memory)
        return int(select(self.memory, s, self.rng.random()))

    def learn_step(self, s: int, a: int, r: float, s_next: int, terminated: bool) -> tuple[int | None, float]:
        """Learn from one transition; returns the next action (None after a terminal state) and the TD error."""
        a_next, delta = learn_step(self.memory, s, a, r, s_next, terminated, self.rng.random())
        return (None if terminated else int(a_next)), float(delta)

    def save(self, path: str | Path) -> None:
        """Write all that the agent is to one ``.npz`` file, whole or not at all. `load` continues bit for bit."""
        about = {
            "method": self.method, "settings": self.settings, "shape": self.shape, "n_actions": self.q.shape[1],
            "pending": self.pending, "rng": self.rng.bit_generator.state,
        }  # fmt: skip
        save_arrays(path, "agent", about, {name: np.asarray(value) for name, value in self._changing().items()})

    @classmethod
    def load(cls, path: str | Path) -> Agent:
        """The agent that `save` wrote. Raises ValueError if the file is damaged or of another kind."""
        about, arrays = load_arrays(path, "agent")
        try:
            agent = cls(Size(tuple(about["shape"]), about["n_actions"]), about["method"], **about["settings"])
            agent.rng.bit_generator.state = about["rng"]
            agent.pending = about["pending"] and tuple(about["pending"])
            for name, value in agent._changing().items():
                np.asarray(value)[...] = arrays[name]
        except (ValueError, KeyError, TypeError) as error:
            raise ValueError(f"{path}: this agent was written by another version of the toolkit") from error
        return agent

    def _changing(self) -> dict[str, np.ndarray]:
        """The parts of the memory that learning changes, by name."""
        return {name: value for name, value in self.memory._asdict().items() if name != "parameters"}
