"""A task: what a robot perceives, what it can do, and what earns it a reward."""

import pickle
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from numbers import Real
from typing import Any

import cloudpickle

from rlrobot_edu.checks import (
    check_between,
    check_count,
    check_name,
    check_numbers,
    check_table,
    describe_error,
    file_and_line,
    in_a_line,
)
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.task.robot_cards import ROBOTS, Quantity
from rlrobot_edu.task.room import Room
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.variables import InputVariable, OutputVariable, Variable

# the shortest and the longest [s]; a simulator counts it out in steps of some hundredths
STEP_TIME = (1e-6, 600.0)

Readings = Mapping[str, float]


@suggests_keywords
@dataclass(frozen=True)
class Task:
    """Everything that defines a learning problem; the learning method needs nothing more.

    Parameters
    ----------
    robot : str
        The robot, one of ``robot_cards.ROBOTS``.
    scene : str or Room
        Its surroundings: one of the robot's scenes or, for the mobile base and the Giraff, a room that you draw.
    inputs : sequence of InputVariable
        A state is one bin of each input.
    outputs : sequence of OutputVariable
        An action is one value of each output.
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
        Whether the robot has reached its goal; None for a task without one.
    goal_steps : int
        The episode terminates when `goal` was true for so many steps in a row.
    name, path, description, fingerprint : str
        Filled in by `load_task`: the file's name, its path, its docstring, and the SHA-256 of its content.

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
    A loaded task does not change when its file does. This is true for its copies in other processes, too.
    """

    robot: str
    scene: str | Room
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
        card = ROBOTS[check_name(self.robot, ROBOTS, "robot", "a task")]
        owner = f"robot {self.robot!r}"
        if isinstance(self.scene, Room) and card.size:
            self.scene.check_start(*card.size)
        else:
            check_name(self.scene, card.scenes, "scene", owner)
        inputs = []
        for v in _variables("inputs", self.inputs, InputVariable):
            sensor = _quantity("sensor", card.sensors, v, owner)
            low = max(v.low, sensor.low)
            high = min(v.high, sensor.high)
            inputs.append(replace(v, low=low, high=high))
        outputs = _variables("outputs", self.outputs, OutputVariable)
        if self.command is None:
            for output in outputs:
                _quantity("command", card.commands, output, owner)
        for name in ("reward", "command", "goal"):
            function = getattr(self, name)
            is_left_out = function is None and name != "reward"
            if not callable(function) and not is_left_out:
                raise ValueError(f"{name} must be a function, got {function!r:.200}")
        rewards = check_numbers("rewards", self.rewards, finite=True)
        if max(rewards) <= 0:
            raise ValueError(
                f"at least one of rewards must be above 0, because the largest scales Q; got {rewards!s:.200}"
            )
        check_between("step_time", self.step_time, *STEP_TIME, unit=" of seconds")
        check_count("episode_steps", self.episode_steps, or_none=True)
        check_count("goal_steps", self.goal_steps)
        states = StateSpace(inputs)
        actions = ActionSpace(outputs)
        check_table(states.n, actions.n)
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "states", states)
        object.__setattr__(self, "actions", actions)
        object.__setattr__(self, "rewards", rewards)
        object.__setattr__(self, "inputs", states.inputs)
        object.__setattr__(self, "outputs", actions.outputs)

    @property
    def commands(self) -> list[dict[str, float]]:
        """The robot's command for each action, in their order.

        Raises
        ------
        ValueError
            As `command_for`.
        """
        return [self.command_for(a) for a in range(self.actions.n)]

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
        command = self.actions.decode(a)
        what = f"command of action {a} ({self.actions.label(a)})"
        if self.command is not None:
            command = self._ask(what, self.command, command)
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
            If the task's function fails, or returns a value that is not one of `rewards`, such as NaN.
        """
        r = self._ask("reward", self.reward, before, after)
        if not isinstance(r, Real) or r not in self.rewards:
            fault = f"which is not one of rewards={list(self.rewards)!s:.200}"
            advice = "return a listed value (is a `return` missing?), or add this one to the list"
            raise ValueError(
                f"{self.path}: reward returned {r!r:.200}, {fault}; {advice}"
            )
        return float(r) + 0.0  # never −0

    def at_goal(self, readings: Readings) -> bool:
        """Whether the robot has reached its goal.

        Parameters
        ----------
        readings : Mapping
            The robot's readings.

        Returns
        -------
        bool
            What `goal` returns; False for a task without one.

        Raises
        ------
        ValueError
            If the task's function fails.
        """
        goal = self.goal
        if goal is None:
            return False
        return bool(self._ask("goal", lambda given: bool(goal(given)), readings))

    def _ask(
        self, what: str, function: Callable[..., Any], *given: Mapping[str, float]
    ) -> Any:
        """What one of the task's own functions returns. Raises ValueError that names the file and the line."""
        try:
            return function(*given)
        # The task's own function may raise anything.
        except (Exception, SystemExit) as error:
            mistake = describe_error(error, given[-1])
            raise ValueError(
                f"{file_and_line(self.path, error)}: {in_a_line(what)} failed: {mistake}"
            ) from error

    def __getstate__(self) -> bytes:
        # Its functions are pickled by value: another process may lack the task's file, or have it with other content.
        return bytes(cloudpickle.dumps(vars(self)))

    def __setstate__(self, packed: bytes) -> None:
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        for name, value in pickle.loads(packed).items():
            object.__setattr__(self, name, value)

    def __deepcopy__(self, memo: object) -> "Task":
        return self  # nothing of it can be changed


def _variables(what: str, given: Any, kind: type[Variable]) -> list[Any]:
    """The list of given variables. Raises ValueError if there is anything else in it."""
    is_list = isinstance(given, Sequence)
    if not is_list or not all(isinstance(variable, kind) for variable in given):
        raise ValueError(
            f"{what} must be a list of {kind.__name__}, got {given!r:.200}"
        )
    return list(given)


def _quantity(
    kind: str, quantities: Mapping[str, Quantity], variable: Variable, owner: str
) -> Quantity:
    """The sensor or command (`kind`) of the variable's name. Raises ValueError if there is none in its unit."""
    quantity = quantities[check_name(variable.name, quantities, kind, owner)]
    if variable.unit != quantity.unit:
        raise ValueError(
            f"{kind} {variable.name!r}: the robot's unit is {quantity.unit!r}, not {variable.unit!r}"
        )
    return quantity
