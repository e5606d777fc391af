"""A task: what a robot perceives, what it can do, and what it is rewarded for."""

import math
import pickle
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from numbers import Real
from typing import Any

import cloudpickle

from rlrobot_edu.task.messages import counts, in_words, known, where
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.spaces import ActionSpace, StateSpace, check_table
from rlrobot_edu.task.variables import InputVariable, OutputVariable, Variable, numbers

LONGEST_STEP = 600.0  # [s]; a simulator counts it out in steps of some hundredths

Readings = Mapping[str, float]


@dataclass(frozen=True)
class Task:
    """Everything that defines a learning problem; the learning method needs nothing more.

    Parameters
    ----------
    robot : str
        The robot, one of ``robot_cards.ROBOTS``.
    scene : str
        Where it stands, one of the robot's scenes.
    inputs : sequence of InputVariable
        What makes a state, one bin of each.
    outputs : sequence of OutputVariable
        What makes an action, one value of each.
    reward : function (readings before, readings after the step) -> float
        The reward of a step, one of `rewards`. Readings are numbers by the names of the robot's sensors.
    rewards : sequence of float
        Every value that `reward` may return; the largest is Rmax (paper equation 11).
    command : function (values of the outputs by name) -> command to the robot, optional
        None passes the values on as they are.
    step_time : float [s]
        Duration of one control step, at most 600.
    episode_steps : int, optional
        Steps after which an episode is cut off; None for a task that goes on for ever.
    goal : function (readings) -> bool, optional
        Whether the robot is where it should be; None for a task without a goal.
    goal_steps : int
        For so many steps in a row `goal` must be true; then the episode terminates.
    name, path, description, fingerprint : str
        Filled in by `load_task`: the file's name, its path, its docstring, and the SHA-256 of what it said then.

    Attributes
    ----------
    states : StateSpace
        All combinations of the inputs' bins.
    actions : ActionSpace
        All combinations of the outputs' values.

    Raises
    ------
    ValueError
        In one sentence, if the parts do not fit together.

    Notes
    -----
    A task is what it was when it was loaded, also in other processes and copies, whatever becomes of its file.
    """

    robot: str
    scene: str
    inputs: Sequence[InputVariable]
    outputs: Sequence[OutputVariable]
    reward: Callable[[Readings, Readings], float]
    rewards: Sequence[float]
    command: Callable[[dict[str, float]], Mapping[str, float]] | None = None
    step_time: float = 1.0
    episode_steps: int | None = None
    goal: Callable[[Readings], bool] | None = None
    goal_steps: int = 1
    name: str = "my_task"
    path: str = "the task"
    description: str = field(default="", repr=False)
    fingerprint: str = field(default="", repr=False)
    states: StateSpace = field(init=False, repr=False)
    actions: ActionSpace = field(init=False, repr=False)

    def __post_init__(self) -> None:
        card, owner = ROBOTS[known(self.robot, ROBOTS, "robot", "a task")], f"robot {self.robot!r}"
        known(self.scene, card.scenes, "scene", owner)
        inputs = []
        for variable in _variables("inputs", self.inputs, InputVariable):
            sensor = card.sensors[known(variable.name, card.sensors, "sensor", owner)]
            _same_unit("input", variable, sensor.unit)
            inputs.append(replace(variable, low=max(variable.low, sensor.low), high=min(variable.high, sensor.high)))
        outputs = _variables("outputs", self.outputs, OutputVariable)
        if self.command is None:
            for output in outputs:
                quantity = card.commands[known(output.name, card.commands, "command", owner)]
                _same_unit("output", output, quantity.unit)
        for name in ("reward", "command", "goal"):
            function = getattr(self, name)
            if not callable(function) and (function is not None or name == "reward"):
                raise ValueError(f"{name} must be a function, got {function!r:.200}")
        rewards = numbers("rewards", self.rewards)
        if not rewards or not all(math.isfinite(r) for r in rewards):
            raise ValueError(f"rewards must list finite numbers, got {list(rewards)!s:.200}")
        if max(rewards) <= 0:
            raise ValueError(
                f"the largest reward scales Q, so it must be above 0; add a constant to {list(rewards)!s:.200}"
            )
        if not (isinstance(self.step_time, Real) and 0 < self.step_time <= LONGEST_STEP):
            raise ValueError(
                f"step_time must be a positive number of seconds, at most {LONGEST_STEP:g}, got {self.step_time!r:.200}"
            )
        if self.episode_steps is not None and not counts(self.episode_steps):
            raise ValueError(f"episode_steps must be None or a whole number from 1, got {self.episode_steps!r:.200}")
        if not counts(self.goal_steps):
            raise ValueError(f"goal_steps must be a whole number from 1, got {self.goal_steps!r:.200}")
        object.__setattr__(self, "inputs", tuple(inputs))
        object.__setattr__(self, "outputs", tuple(outputs))
        object.__setattr__(self, "rewards", rewards)
        object.__setattr__(self, "states", StateSpace(self.inputs))
        object.__setattr__(self, "actions", ActionSpace(self.outputs))
        check_table(self.states.n, self.actions.n)

    def command_for(self, a: int) -> dict[str, float]:
        """The robot's command for action `a`.

        Parameters
        ----------
        a : int
            Number of the action, 0 to n_actions − 1.

        Returns
        -------
        dict
            A number for each of the robot's commands, in the units of its card.

        Raises
        ------
        ValueError
            If there is no such action, the task's function fails, or the robot cannot carry out what it returns.
        """
        values, what = self.actions.decode(a), f"command of action {a} ({self.actions.label(a)})"
        command = values if self.command is None else self._ask(what, self.command, values)
        try:
            ROBOTS[self.robot].check_command(command)
        except ValueError as error:
            raise ValueError(f"{self.path}: {what}: {error}") from None
        return dict(command)

    def reward_for(self, before: Readings, after: Readings) -> float:
        """The reward of a step.

        Parameters
        ----------
        before, after : Mapping
            The robot's readings before and after the step.

        Returns
        -------
        float
            One of `rewards`.

        Raises
        ------
        ValueError
            If the task's function fails, or returns what is not one of `rewards` (so also if that is NaN).
        """
        r = self._ask("reward", self.reward, before, after)
        if not isinstance(r, Real) or r not in self.rewards:
            raise ValueError(
                f"{self.path}: reward returned {r!r:.200}, which is not one of rewards={list(self.rewards)!s:.200}; "
                "return a listed value (is a `return` missing?), or add this one to the list"
            )
        return float(r)

    def at_goal(self, readings: Readings) -> bool:
        """Whether the robot is where it should be.

        Parameters
        ----------
        readings : Mapping
            The robot's readings.

        Returns
        -------
        bool
            What `goal` says; False for a task without one.

        Raises
        ------
        ValueError
            If the task's function fails.
        """
        return self.goal is not None and bool(self._ask("goal", self.goal, readings))

    def _ask(self, what: str, function: Callable[..., Any], *given: Mapping[str, float]) -> Any:
        """What one of the task's own functions says. Raises ValueError that names the file and the line."""
        try:
            return function(*given)
        except (Exception, SystemExit) as error:  # the task's own function may raise anything
            raise ValueError(f"{where(self.path, error)}: {what} failed: {in_words(error, given[-1])}") from error

    def __reduce__(self) -> tuple[Any, ...]:
        # Its functions go along by value: another process may not have the task's file, or not with this content.
        return _unpacked, (cloudpickle.dumps({f.name: getattr(self, f.name) for f in fields(self) if f.init}),)

    def __deepcopy__(self, memo: object) -> "Task":
        return self  # nothing of it can be changed


def _unpacked(packed: bytes) -> Task:
    """The task that `Task.__reduce__` packed."""
    return Task(**pickle.loads(packed))


def _variables(what: str, given: Any, kind: type[Variable]) -> list[Any]:
    """The list of given variables. Raises ValueError if there is anything else in it."""
    if not isinstance(given, Sequence) or not all(isinstance(variable, kind) for variable in given):
        raise ValueError(f"{what} must be a list of {kind.__name__}, got {given!r:.200}")
    return list(given)


def _same_unit(kind: str, variable: Variable, unit: str) -> None:
    if variable.unit != unit:
        raise ValueError(f"{kind} {variable.name!r}: the robot has it in {unit!r}, the task in {variable.unit!r}")
