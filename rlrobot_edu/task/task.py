"""A task: what a robot perceives, what it can do, and what it is rewarded for. One small file each."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from rlrobot_edu.files import shipped
from rlrobot_edu.task.messages import in_words, known, where
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.variables import InputVariable, OutputVariable, Variable

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
        Duration of one control step.
    episode_steps : int, optional
        Steps after which an episode is cut off; None for a task that goes on for ever.
    goal : function (readings) -> bool, optional
        Whether the robot is where it should be; None for a task without a goal.
    goal_steps : int
        For so many steps in a row `goal` must be true; then the episode terminates.
    name, path, description : str
        Filled in by `load_task`: the file's name, its path and its docstring.

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
    states: StateSpace = field(init=False, repr=False)
    actions: ActionSpace = field(init=False, repr=False)

    def __post_init__(self) -> None:
        card, owner = ROBOTS[known(self.robot, ROBOTS, "robot", "a task")], f"robot {self.robot!r}"
        known(self.scene, card.scenes, "scene", owner)
        inputs = []
        for variable in self.inputs:
            sensor = card.sensors[known(variable.name, card.sensors, "sensor", owner)]
            _same_unit("input", variable, sensor.unit)
            inputs.append(replace(variable, low=max(variable.low, sensor.low), high=min(variable.high, sensor.high)))
        if self.command is None:
            for output in self.outputs:
                quantity = card.commands[known(output.name, card.commands, "command", owner)]
                _same_unit("output", output, quantity.unit)
        rewards = tuple(float(r) for r in self.rewards)
        if not rewards or not all(math.isfinite(r) for r in rewards):
            raise ValueError(f"rewards must list finite numbers, got {list(rewards)}")
        if max(rewards) <= 0:
            raise ValueError(f"the largest reward scales Q, so it must be above 0; add a constant to {list(rewards)}")
        if not (math.isfinite(self.step_time) and self.step_time > 0):
            raise ValueError(f"step_time must be a positive number of seconds, got {self.step_time}")
        if self.episode_steps is not None and not self.episode_steps >= 1:
            raise ValueError(f"episode_steps must be None or at least 1, got {self.episode_steps}")
        object.__setattr__(self, "inputs", tuple(inputs))
        object.__setattr__(self, "outputs", tuple(self.outputs))
        object.__setattr__(self, "rewards", rewards)
        object.__setattr__(self, "states", StateSpace(self.inputs))
        object.__setattr__(self, "actions", ActionSpace(self.outputs))

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
        try:
            command = values if self.command is None else self.command(values)
        except Exception as error:  # the task's own function may raise anything
            raise ValueError(f"{where(self.path, error)}: {what} failed: {in_words(error, values)}") from error
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
        try:
            r = self.reward(before, after)
        except Exception as error:  # the task's own function may raise anything
            raise ValueError(f"{where(self.path, error)}: reward failed: {in_words(error, after)}") from error
        if r not in self.rewards:
            raise ValueError(
                f"{self.path}: reward returned {r!r}, which is not one of rewards={list(self.rewards)}; "
                "return a listed value (is a `return` missing?), or add this one to the list"
            )
        return r

    def __reduce__(self) -> str | tuple[Any, ...]:
        # A task read from a file holds functions that only this file defines: another process reads it again.
        if Path(self.path).is_file():
            return load_task, (self.path,)
        return super().__reduce__()


def _same_unit(kind: str, variable: Variable, unit: str) -> None:
    if variable.unit != unit:
        raise ValueError(f"{kind} {variable.name!r}: the robot has it in {unit!r}, the task in {variable.unit!r}")


def available_tasks() -> list[str]:
    """The tasks that come with the toolkit.

    Returns
    -------
    list of str
        Their names, in alphabetical order; `load_task` takes each.
    """
    return sorted(path.stem for path in shipped("tasks").glob("[a-z]*.py"))


def load_task(task: str | Path | Task) -> Task:
    """The task of this name, or the one in this file.

    Parameters
    ----------
    task : str, Path or Task
        The name of a task that comes with the toolkit, or the path of your own Python file, which must define
        ``task = Task(...)``. A `Task` is handed back as it is.

    Returns
    -------
    Task
        With the `name`, `path` and `description` that its file gives it.

    Raises
    ------
    ValueError
        If there is no task of this name, or something is wrong in the file: it says which file, line and what.
    FileNotFoundError
        If there is no such file.
    """
    if isinstance(task, Task):
        return task
    path = Path(task)
    if path.suffix != ".py":
        path = shipped("tasks") / f"{known(str(task), available_tasks(), 'task', 'the toolkit')}.py"
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such task file")
    module = {"__name__": f"rlrobot_edu_task_{path.stem}", "__file__": str(path), "__doc__": None}
    try:
        # Not a regular import: that would keep bytecode beside the file and miss an edit made within the same second.
        exec(compile(path.read_bytes(), str(path), "exec"), module)
    except ValueError as error:  # most likely one of our own sentences, which says it all
        raise ValueError(f"{where(path, error)}: {error}") from None
    except Exception as error:
        raise ValueError(f"{where(path, error)}: {in_words(error)}") from error
    defined: object = module.get("task")
    if not isinstance(defined, Task):
        raise ValueError(f"{path}: the file must define task = Task(...), found {defined!r}")
    return replace(defined, name=path.stem, path=str(path), description=(module["__doc__"] or "").strip())
