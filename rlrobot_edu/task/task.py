"""A task: what a robot perceives, what it can do, and what it is rewarded for. One small file each."""

from __future__ import annotations

import difflib
import math
import traceback
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from rlrobot_edu.files import shipped
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.variables import InputVariable, OutputVariable

Readings = Mapping[str, float]


@dataclass(frozen=True)
class Task:
    """Everything that defines a learning problem; the learning method needs nothing more.

    robot, scene: the robot and the world it stands in (``robot_cards.ROBOTS``)
    inputs, outputs: what makes a state and an action
    reward: function (readings before, readings after the step) -> reward; see `rewards`
    rewards: every value that `reward` may return; the largest is Rmax (paper equation 11)
    command: function (values of the outputs) -> command to the robot; None passes the values on as they are
    step_time: duration of one control step [s]
    episode_steps: steps after which an episode is cut off; None for a task that goes on for ever
    goal, goal_steps: function (readings) -> bool; once it is true for so many steps in a row, the episode terminates
    name, path, description: filled in by `load_task`

    Raises ValueError in one sentence if the parts do not fit together.
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
        card = _known(self.robot, ROBOTS, "robot", "a task")
        _known(self.scene, card.scenes, "scene", f"robot {self.robot!r}")
        inputs = []
        for variable in self.inputs:
            sensor = _known(variable.name, card.sensors, "sensor", f"robot {self.robot!r}")
            _same_unit("input", variable, sensor.unit)
            inputs.append(replace(variable, low=max(variable.low, sensor.low), high=min(variable.high, sensor.high)))
        if self.command is None:
            for output in self.outputs:
                quantity = _known(output.name, card.commands, "command", f"robot {self.robot!r}")
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

    def command_for(self, a: int) -> Mapping[str, float]:
        """The robot's command for action `a`."""
        values = self.actions.decode(a)
        return values if self.command is None else self.command(values)

    def reward_for(self, before: Readings, after: Readings) -> float:
        """The reward of a step. Raises ValueError if it is not one of `rewards` (so also if it is NaN)."""
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

    def __reduce__(self):
        # A task read from a file holds functions that only this file defines: another process reads it again.
        if Path(self.path).is_file():
            return load_task, (self.path,)
        return super().__reduce__()


def _known(name, known, kind: str, owner: str):
    """`known[name]`, or a ValueError that lists what is known and suggests the nearest."""
    if isinstance(name, str) and name in known:
        return known[name] if isinstance(known, Mapping) else name
    near = difflib.get_close_matches(str(name), list(known), n=1, cutoff=0.5)
    hint = f"did you mean {near[0]!r}? " if near else ""
    raise ValueError(f"{owner} has no {kind} {name!r}; {hint}It has: {', '.join(known)}")


def where(path: str | Path, error: Exception) -> str:
    """`path`, and the line of that file in which `error` arose, if it did."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    return f"{path}, line {lines[-1]}" if lines else str(path)


def in_words(error: Exception, names: Mapping | None = None) -> str:
    """What went wrong in a task's own code; for a missing key also what there is."""
    if isinstance(error, KeyError) and names is not None:
        return f"there is no {error}; there are {', '.join(map(str, names))}"
    return f"{type(error).__name__}: {error}"


def _same_unit(kind: str, variable: InputVariable | OutputVariable, unit: str) -> None:
    if variable.unit != unit:
        raise ValueError(f"{kind} {variable.name!r}: the robot has it in {unit!r}, the task in {variable.unit!r}")


def available_tasks() -> list[str]:
    """Names of the tasks that come with the toolkit."""
    return sorted(path.stem for path in shipped("tasks").glob("[a-z]*.py"))


def load_task(task: str | Path | Task) -> Task:
    """The task of this name, or the one in this file: a Python file that defines ``task = Task(...)``.

    Raises ValueError that names the file and what is wrong in it, FileNotFoundError if there is no such file.
    """
    if isinstance(task, Task):
        return task
    path = Path(task)
    if path.suffix != ".py":
        path = shipped("tasks") / f"{_known(str(task), available_tasks(), 'task', 'the toolkit')}.py"
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
    found = module.get("task")
    if not isinstance(found, Task):
        raise ValueError(f"{path}: the file must define task = Task(...), found {found!r}")
    return replace(found, name=path.stem, path=str(path), description=(module["__doc__"] or "").strip())
