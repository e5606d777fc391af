"""The learner: a method, its parameters, and what it has learned. It knows nothing about robots or pictures."""

import dataclasses
from collections.abc import Callable
from copy import copy, deepcopy
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import (
    check_name,
    check_pair,
    check_parts,
    check_transition,
    first_difference,
)
from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.jit.building import for_python
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.algorithm import Planner
from rlrobot_edu.learning.memory import Memory, new_memory, set_parameters
from rlrobot_edu.learning.methods import Method, made_of, parse_method
from rlrobot_edu.learning.own_code import Before, guarded
from rlrobot_edu.learning.parameters import Parameters, Traces
from rlrobot_edu.learning.planning.experience import (
    Experience,
    new_experience,
    with_room,
)
from rlrobot_edu.learning.resolve import sized_world
from rlrobot_edu.learning.resume import ResumePoint
from rlrobot_edu.learning.size import Env, Size, can_end, task_of
from rlrobot_edu.learning.step import StepKernels, begin_episode, no_update
from rlrobot_edu.seeds import generator
from rlrobot_edu.task.task import Task

T = TypeVar("T")
FIXED = {"world", "method", "planner", "seed", "gamma", "lam", "traces"}
LARGEST_KEPT = 1e300  # of action values in a file: beyond, sums soon are infinite


@suggests_keywords
class Agent:
    """A tabular learning agent. Its defaults are the paper's (section 3); see `Parameters`.

    Parameters
    ----------
    world : Task, str, Path, SampleModel, gymnasium.Env, EnvSpec or function
        Anything that `make_env` takes, or the environment itself; its states and actions must be discrete.
    method : str or Method
        ``ALGORITHM+SELECTION``, or one with parts of your own. Algorithms: Q (Q-learning), SARSA, ESARSA (expected
        SARSA), SL (SARSA(λ)), TOSL (true online). Selections: SR (softmax regression), QBIASSR (Q-biased),
        EG (ε-greedy), EGLE (ε-greedy towards the least explored), GREEDY, RANDOM.
    alpha, gamma, lam : float
        Learning rate in (0, 1], discount rate in [0, 1], decay of the eligibility traces in [0, 1]. A discount rate
        of 1 is for episodes that end for good, and not for SR and the biased ones: Qmax = Rmax / (1 - gamma) divides Q.
    temperature, epsilon : float
        Boltzmann temperature above 0, for SR and the biased ones; probability of exploring in [0, 1], for EG and EGLE.
    traces : str
        ``reduced`` (the paper's RETR) or ``full``.
    accumulating, loop_evasion : bool
        SARSA(λ) adds to a trace instead of replacing it; the temperature rises in loops of low reward (LRLE).
    r_max : float, optional
        Largest reward, above 0, which normalises Q; taken from the task, or 1 for an environment without one. SR and
        the biased ones need it where no reward is above 0.
    planner : str or Planner, optional
        ``dyna`` (Dyna-Q), or one of your own: it learns between two steps from earlier observations.
    planning_steps : int
        Steps that a planner imagines after each real one, 0 to 1,000,000.
    seed : int or numpy.random.SeedSequence, optional
        Of the agent's own random numbers.

    Attributes
    ----------
    method : Method
        How it learns, selects and plans; ``agent.method.name`` is its name.
    parameters : Parameters
        Its parameters as they are now, see `change`.
    task : Task, optional
        The task for which it was made; None for a world without one.

    Raises
    ------
    ValueError
        If the method is unknown, a parameter is out of its domain, or states or actions cannot be counted.
    FileNotFoundError
        If there is no such task file.
    gymnasium.error.Error
        If Gymnasium has no environment of this id.
    """

    def __init__(
        self,
        world: Task | str | Path | Env | Any,
        method: str | Method = "TOSL+QBIASSR",
        *,
        alpha: float = Parameters.alpha,
        gamma: float = Parameters.gamma,
        lam: float = Parameters.lam,
        temperature: float = Parameters.temperature,
        epsilon: float = Parameters.epsilon,
        traces: Traces = Parameters.traces,
        accumulating: bool = Parameters.accumulating,
        loop_evasion: bool = Parameters.loop_evasion,
        r_max: float | None = None,
        planner: str | Planner | None = None,
        planning_steps: int = Parameters.planning_steps,
        seed: int | np.random.SeedSequence | None = None,
    ) -> None:
        world = sized_world(world)
        self.method = parse_method(method, planner)
        self.task = task_of(world)
        size = Size.of(world)
        if r_max is None:
            r_max = size.r_max
            # Where all rewards are negative, only a softmax needs a scale.
            if r_max <= 0 and not self.method.selection.is_softmax:
                r_max = Parameters.r_max
        parameters = Parameters(
            alpha=alpha,
            gamma=gamma,
            lam=lam,
            temperature=temperature,
            epsilon=epsilon,
            traces=traces,
            accumulating=accumulating,
            loop_evasion=loop_evasion,
            r_max=r_max,
            planning_steps=planning_steps,
        )
        self.parameters = self._checked(parameters)
        if gamma == 1 and not can_end(world):
            raise ValueError(
                "gamma must be below 1 where no episode ends for good: values would be endless"
            )
        self.seed = seed
        self.rng = generator(seed)
        self.memory: Memory = new_memory(size.shape, size.n_actions, self.parameters)
        # What a planner knows
        self.experience: Experience | None = None
        if self.method.planner:
            self.experience = new_experience(
                size.n_states, size.n_actions, self.method.planner
            )
        # State and chosen action of an episode that is still running
        self.pending: tuple[int, int] | None = None
        # Where it can go on; None within a step
        self.resume_point: ResumePoint | None = None
        self._before = Before()

    def __repr__(self) -> str:
        n_states, n_actions = self.q.shape
        name = self.method.name
        if self.method.planner:
            name += f", {self.method.planner.name}"
        n_steps = self.visits.sum()
        return (
            f"<Agent {name}: {n_states} states, {n_actions} actions, {n_steps} steps>"
        )

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
    def visits(self) -> NDArray[np.int64]:
        """How often each pair was tried, array (n_states, n_actions) of int."""
        return self.memory.visits

    @property
    def policy(self) -> NDArray[np.intp]:
        """The best action in each state, the first of several, array (n_states,) of int."""
        return np.asarray(self.q.argmax(axis=1))

    @property
    def probabilities(self) -> NDArray[np.float64]:
        """The probability of each action at the last selection, array (n_actions,)."""
        return self.memory.probabilities

    @property
    def bias(self) -> NDArray[np.float64] | None:
        """What a biased selection last added to Q(s), array (n_actions,); None for other selections."""
        return self.memory.bias if self.method.selection.is_biased else None

    @property
    def largest_q(self) -> float:
        """The largest magnitude of an action value; NaN if one is no number."""
        return float(np.abs(self.q).max())

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

        Raises
        ------
        ValueError
            If the agent has no such state.
        """
        s, _ = check_pair(self.memory.q.shape, s)

        def first(kernels: StepKernels) -> int:
            for_python(begin_episode)(self.memory)
            return int(kernels.select(self.memory, s, self.rng.random()))

        return self._guarded(first)

    def learn_step(
        self, s: int, a: int, r: float, s_next: int, terminated: bool
    ) -> tuple[int | None, float]:
        """Learn from one transition, and choose the next action.

        Parameters
        ----------
        s, a, r, s_next, terminated : int, int, float, int, bool
            State, action, reward, next state, and whether the episode ended there for good.

        Returns
        -------
        tuple
            The next action, or None after a terminal state, and the TD error.

        Raises
        ------
        ValueError
            If there is no such state or action, if the reward is not from −1e100 to 1e100, or if the planner has met
            all the outcomes that it can keep.
        Exception
            Whatever a part of your own raises.
        """
        s, a, r, s_next = check_transition(self.memory.q.shape, s, a, r, s_next)
        x = self._make_room()

        def one_step(kernels: StepKernels) -> Any:
            real = (s, a, r, s_next, bool(terminated), self.rng.random())
            if kernels.planned_step is None:
                return kernels.learn_step(self.memory, *real)
            return kernels.planned_step(self.memory, x, *real, self.rng)

        a_next, delta = self._guarded(one_step)
        if terminated:
            return None, float(delta)
        return int(a_next), float(delta)

    def update(
        self, s: int, a: int, r: float, s_next: int, a_next: int, terminated: bool
    ) -> float:
        """Learn from one transition whose next action is given, the algorithm's update and a planner's part alone.

        Parameters
        ----------
        s, a, r, s_next, a_next, terminated : int, int, float, int, int, bool
            State, action, reward, next state, next action, and whether the episode ended there for good.

        Returns
        -------
        float
            The TD error.

        Raises
        ------
        ValueError
            As `learn_step`.
        """
        s, a, r, s_next = check_transition(self.memory.q.shape, s, a, r, s_next)
        if terminated:
            a_next = 0  # after the end nothing is chosen
        _, a_next = check_pair(self.memory.q.shape, s_next, a_next)
        real = (s, a, r, s_next, a_next, bool(terminated))
        x = self._make_room()

        def one_update(kernels: StepKernels) -> float:
            delta = float(kernels.update(self.memory, *real))
            if kernels.plan is not None:
                kernels.plan(self.memory, x, *real, self.rng)
            return delta

        return self._guarded(one_update)

    def _make_room(self) -> Experience | None:
        """What a planner knows, with room for one outcome more; None without a planner."""
        if self.experience is not None:
            self.experience = with_room(self.experience, 1)
        return self.experience

    def _guarded(self, one_step: Callable[[StepKernels], T]) -> T:
        return guarded(
            self.method,
            self.memory,
            self.experience,
            self.rng,
            self._before,
            one_step,
        )

    def frozen(self) -> "Agent":
        """A copy that acts as this agent does and learns no more: its Q stays.

        It still counts visits; its TD errors are NaN. It draws the random numbers that the agent would draw next (an
        agent with a planner draws others, to imagine steps). It shares nothing with the agent, and cannot be saved.

        Returns
        -------
        Agent
            The copy.
        """
        without_planner = copy(self)
        # these may be large
        without_planner.experience = None
        without_planner._before = Before()
        still = deepcopy(without_planner)
        algorithm = self.method.algorithm._replace(update=no_update)
        still.method = Method(algorithm, self.method.selection)
        return still

    def change(self, **parameters: Any) -> None:
        """Go on with other parameters, for example ``agent.change(loop_evasion=True)``.

        Parameters
        ----------
        **parameters
            Any of `Parameters` except gamma, lam and traces, which set the size of the agent's memory.

        Raises
        ------
        ValueError
            For another parameter, or a value out of its domain.
        """
        fixed = FIXED.intersection(parameters)
        if fixed:
            raise ValueError(
                f"{', '.join(sorted(fixed))} cannot be changed later; make a new agent"
            )
        for name in parameters:
            check_name(name, Parameters.__annotations__, "parameter", "an agent")
        changed = dataclasses.replace(self.parameters, **parameters)
        self.parameters = self._checked(changed)
        set_parameters(self.memory, self.parameters)
        if "temperature" in parameters or "loop_evasion" in parameters:
            # If a loop goes on, loop evasion raises it again.
            self.memory.now.temperature = self.parameters.temperature

    def _checked(self, parameters: Parameters) -> Parameters:
        if parameters.accumulating and self.method.algorithm.name != "SL":
            raise ValueError(
                f"accumulating traces are a variant of SARSA(lambda), not of {self.method.name}"
            )
        if parameters.gamma == 1 and self.method.selection.is_softmax:
            raise ValueError(
                "gamma must be below 1 for a softmax, which divides Q by Rmax / (1 - gamma)"
            )
        return parameters

    def save(self, path: str | Path) -> None:
        """Write what the agent has learned to one ``.npz`` file, whole or not at all.

        The file holds action values, visits, parameters and the state of the random numbers, so a loaded agent learns
        from its next episode on what this one would learn. What a planner has met is not in the file: there, an agent
        with a planner begins anew.

        Parameters
        ----------
        path : str or Path
            The file.

        Raises
        ------
        ValueError
            If an action value is not finite or exceeds 1e300, if the agent is a frozen copy, or if the file's name ends
            like that of another kind of file.
        OSError
            If the file cannot be written.
        """
        if self.method.algorithm.update is no_update:
            raise ValueError(
                f"{path}: a frozen copy is not saved; save the agent itself"
            )
        if not self._is_sound():
            raise ValueError(
                f"{path}: an action value is not finite or exceeds 1e300 (learning has diverged); nothing was saved"
            )
        about = {
            "method": {"the method": self.method.name} | made_of(self.method),
            "settings": dataclasses.asdict(self.parameters),
            "shape": self.shape,
            "n_actions": self.q.shape[1],
            "rng": self.rng.bit_generator.state,
        }
        save_arrays(path, "agent", about, {"q": self.q, "visits": self.visits})

    @classmethod
    def load(cls, path: str | Path, method: str | Method | None = None) -> "Agent":
        """The agent that `save` wrote.

        Parameters
        ----------
        path : str or Path
            The file.
        method : str or Method, optional
            The agent's method, if it has parts that are not the toolkit's. The file does not hold their code, only a
            short name of it, to compare.

        Returns
        -------
        Agent
            The same agent, before its next episode; its `task` is None.

        Raises
        ------
        ValueError
            If the file is damaged or of another kind, or if the method is not the one that the agent had.
        FileNotFoundError
            If there is none.
        """
        given_method = None if method is None else parse_method(method)

        def make(about: dict[str, Any], arrays: dict[str, np.ndarray]) -> "Agent | str":
            its_method = given_method
            if its_method is None:
                method_name, planner, *own_parts = about["method"].values()
                if own_parts:
                    return "this agent has a method of its own; give it as method=rl.Method(…)"
                its_method = parse_method(method_name, planner)
            given = {"the method": its_method.name} | made_of(its_method)
            differ = first_difference(about["method"], given, "file")
            if differ:
                return f"this agent's method is not the one that was given: {differ} in this call"
            size = Size(about["shape"], about["n_actions"])
            agent = cls(size, its_method, **about["settings"])
            agent.rng.bit_generator.state = about["rng"]
            for name, table in (("q", agent.q), ("visits", agent.visits)):
                check_parts("agent", [(name, arrays[name].shape == table.shape)])
            np.copyto(agent.q, arrays["q"], casting="equiv")
            np.copyto(agent.visits, arrays["visits"], casting="equiv")
            check_parts("agent", [("q or visits", agent._is_sound())])
            return agent

        agent = load_arrays(path, "agent", make)
        if isinstance(agent, str):  # the file is whole
            raise ValueError(f"{path}: {agent}")
        return agent

    def _is_sound(self) -> bool:
        """Whether learning can have left the tables like that."""
        return self.largest_q <= LARGEST_KEPT and bool((self.visits >= 0).all())
