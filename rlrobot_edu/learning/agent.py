"""The learner: a method, its parameters, and what it has learned. It knows no robot and no picture."""

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.learning.border import changing, check_pair, check_transition, restore
from rlrobot_edu.learning.memory import Memory, new_memory, set_parameters
from rlrobot_edu.learning.methods import parse_method
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.size import Env, Size, World, task_of
from rlrobot_edu.learning.step import begin_episode, learn_step, select
from rlrobot_edu.seeds import generator
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task


class Agent:
    """A tabular learning agent. Its defaults are the paper's (section 3); they are said in `Parameters`.

    Parameters
    ----------
    world : Task, str, Path, gymnasium.Env or World
        A Task (or its name or path), a SampleModel, or any Gymnasium environment with discrete states and actions.
    method : str
        ``ALGORITHM+SELECTION``. Algorithms: Q (Q-learning), SARSA, ESARSA (expected SARSA), SL (SARSA(λ)), TOSL (true
        online SARSA(λ)). Selections: SR (softmax regression), QBIASSR (Q-biased), EG (ε-greedy), EGLE (ε-greedy
        towards the least explored action), GREEDY, RANDOM.
    alpha, gamma, lam : float
        Learning rate in (0, 1], discount rate in [0, 1), decay of the eligibility traces in [0, 1].
    temperature, epsilon : float
        Boltzmann temperature above 0, for SR and QBIASSR; probability of exploring in [0, 1], for EG and EGLE.
    traces : str
        ``reduced`` (the paper's RETR) or ``full``.
    accumulating, loop_evasion : bool
        SARSA(λ) adds to a trace instead of replacing it; the temperature rises in loops of low reward (LRLE).
    r_max : float, optional
        Largest reward, above 0, which normalises Q; taken from the task, or 1 for an environment without one.
    seed : int or numpy.random.SeedSequence, optional
        Of the agent's own random numbers.

    Raises
    ------
    ValueError
        If the method is unknown, a parameter is out of its domain, or states or actions cannot be counted.
    """

    def __init__(
        self,
        world: Task | str | Path | Env | World,
        method: str = "TOSL+QBIASSR",
        *,
        alpha: float = Parameters.alpha,
        gamma: float = Parameters.gamma,
        lam: float = Parameters.lam,
        temperature: float = Parameters.temperature,
        epsilon: float = Parameters.epsilon,
        traces: str = Parameters.traces,
        accumulating: bool = Parameters.accumulating,
        loop_evasion: bool = Parameters.loop_evasion,
        r_max: float | None = None,
        seed: int | np.random.SeedSequence | None = None,
    ) -> None:
        self._algorithm, self._selection = parse_method(method)
        world = load_task(world) if isinstance(world, str | Path) else world
        self.task, size = task_of(world), Size.of(world)
        r_max = size.r_max if r_max is None else r_max
        given = (alpha, gamma, lam, temperature, epsilon, traces, accumulating, loop_evasion, r_max)
        self._parameters = Parameters(*given)
        if accumulating and self.algorithm != "SL":
            raise ValueError(f"accumulating traces are a variant of SARSA(lambda) only, not of {method}")
        self.method, self.seed = method, seed
        self.rng = generator(seed)
        self.memory: Memory = new_memory(size.shape, size.n_actions, method, self._parameters)
        self.pending: tuple[int, int] | None = None  # state and chosen action of an episode that still runs

    def __repr__(self) -> str:
        return f"<Agent {self.method}: {self.q.shape[0]} states, {self.q.shape[1]} actions, {self.visits.sum()} steps>"

    @property
    def algorithm(self) -> str:
        """Name of the algorithm, such as ``TOSL``."""
        return self._algorithm.name

    @property
    def selection(self) -> str:
        """Name of the selection, such as ``QBIASSR``."""
        return self._selection.name

    @property
    def keeps_traces(self) -> bool:
        """Whether the algorithm has eligibility traces."""
        return self._algorithm.new_trace is not None

    @property
    def parameters(self) -> Parameters:
        """What was set, the defaults included."""
        return self._parameters

    @property
    def shape(self) -> tuple[int, ...]:
        """Bins of each input variable."""
        return tuple(int(n) for n in self.memory.shape)

    @property
    def q(self) -> NDArray[np.float64]:
        """Action values, array (n_states, n_actions); the agent's own, not a copy."""
        return self.memory.q

    @property
    def e(self) -> NDArray[np.float64]:
        """Eligibility traces, array (n_states, n_actions); the agent's own, not a copy."""
        return self.memory.e

    @property
    def q_old(self) -> float:
        """Q(s', a') as it was before the last update: what TOSL remembers of the step before."""
        return float(self.memory.now.q_old)

    @property
    def visits(self) -> NDArray[np.int64]:
        """How often each pair was tried, array (n_states, n_actions) of int."""
        return self.memory.visits

    @property
    def policy(self) -> NDArray[np.intp]:
        """The best action in each state (the first one, where several are), array (n_states,) of int."""
        best: NDArray[np.intp] = self.q.argmax(axis=1)
        return best

    @property
    def probabilities(self) -> NDArray[np.float64]:
        """With what probability the last selection could have taken each action, array (n_actions,)."""
        return self.memory.probabilities

    @property
    def bias(self) -> NDArray[np.float64] | None:
        """What QBIASSR last added to Q(s), array (n_actions,); None for other selections."""
        return self.memory.bias if self._selection.is_biased else None

    def change(self, **parameters: Any) -> None:
        """Go on with other parameters, for example ``agent.change(loop_evasion=True)``.

        Parameters
        ----------
        **parameters
            Any of the agent's, but not gamma, lam and traces, which say how many traces it has room for.
        """
        fixed = {"gamma", "lam", "traces"}.intersection(parameters)
        if fixed:
            raise ValueError(f"{', '.join(sorted(fixed))} cannot be changed later; make a new agent")
        self._parameters = dataclasses.replace(self._parameters, **parameters)
        set_parameters(self.memory, self._parameters)

    def begin_episode(self, s: int) -> int:
        """Forget the traces and choose the first action.

        Parameters
        ----------
        s : int
            The state in which the episode begins.

        Returns
        -------
        int
            The action.
        """
        s, _ = check_pair(self.memory, s)
        begin_episode(self.memory)
        return int(select(self.memory, s, self.rng.random()))

    def learn_step(self, s: int, a: int, r: float, s_next: int, terminated: bool) -> tuple[int | None, float]:
        """Learn from one transition, and choose the next action.

        Parameters
        ----------
        s, a, r, s_next : int, int, float, int
            State, action, reward and next state.
        terminated : bool
            Whether the episode ended there for good.

        Returns
        -------
        tuple
            The next action, or None after a terminal state, and the TD error.
        """
        s, a, r, s_next = check_transition(self.memory, s, a, r, s_next)
        a_next, delta = learn_step(self.memory, s, a, r, s_next, bool(terminated), self.rng.random())
        return (None if terminated else int(a_next)), float(delta)

    def update(self, s: int, a: int, r: float, s_next: int, a_next: int, terminated: bool) -> float:
        """Learn from one transition whose next action is given, the algorithm's update alone.

        Parameters
        ----------
        s, a, r, s_next, a_next : int, int, float, int, int
            State, action, reward, next state and next action.
        terminated : bool
            Whether the episode ended there for good.

        Returns
        -------
        float
            The TD error.
        """
        s, a, r, s_next = check_transition(self.memory, s, a, r, s_next)
        _, a_next = check_pair(self.memory, s_next, 0 if terminated else a_next)  # after the end nothing is chosen
        return float(self._algorithm.update(self.memory, s, a, r, s_next, a_next, bool(terminated)))

    def save(self, path: str | Path) -> None:
        """Write all that the agent is to one ``.npz`` file, whole or not at all; `load` goes on bit for bit.

        Parameters
        ----------
        path : str or Path
            The file.
        """
        about = {
            "method": self.method, "settings": dataclasses.asdict(self.parameters), "shape": self.shape,
            "n_actions": self.q.shape[1], "pending": self.pending, "rng": self.rng.bit_generator.state,
        }  # fmt: skip
        save_arrays(path, "agent", about, changing(self.memory))

    @classmethod
    def load(cls, path: str | Path) -> "Agent":
        """The agent that `save` wrote.

        Parameters
        ----------
        path : str or Path
            The file.

        Raises
        ------
        ValueError
            If the file is damaged or of another kind.
        """

        def make(about: dict[str, Any], arrays: dict[str, np.ndarray]) -> Agent:
            agent = cls(Size(tuple(about["shape"]), about["n_actions"]), about["method"], **about["settings"])
            agent.rng.bit_generator.state = about["rng"]
            agent.pending = about["pending"] and check_pair(agent.memory, *about["pending"])
            restore(agent.memory, arrays)
            return agent

        return load_arrays(path, "agent", make)
