"""Where the transitions of a recording come from: which states and actions, which robot, which method."""

import math
import platform
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from numbers import Real
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import ArrayLike, NDArray

from rlrobot_edu.checks import check_count, check_numbers, first_difference
from rlrobot_edu.learning.size import Size
from rlrobot_edu.task.room import Room
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import InputVariable, OutputVariable
from rlrobot_edu.version import __version__

REMEDY = "put back the original file, or record again"
# Version of the toolkit and kind of computer, of a recording made now.
THIS_COMPUTER = {
    "version": __version__,
    "platform": f"{platform.system()} {platform.machine()}",
}


@dataclass(frozen=True)
class Source:
    """What is known about a recording besides its rows. It does not need the task's file.

    task_name: name of the task, or of the Gymnasium environment
    states, actions: the variables with their bins, values and units
    rewards: every reward that a row may have
    robot, scene: as in the task; empty for an environment that is no robot
    step_time: duration of one step [s]; None for an environment that is no robot
    episode_steps: of the task, see `Task`; None if it has none
    time_limit: steps after which Gymnasium's TimeLimit cut an episode off; None if there was none
    method, seed: of the agent that acted, such as "TOSL+SR" and 0; None if it was not seeded
    version, platform: the toolkit's version and the computer's kind, on which the last digits may depend

    Raises ValueError for rewards, a step_time or a count that cannot be.
    """

    task_name: str
    states: StateSpace
    actions: ActionSpace
    rewards: tuple[float, ...]
    robot: str = ""
    scene: str | Room = ""
    step_time: float | None = None
    episode_steps: int | None = None
    method: str = "unknown"
    seed: int | None = None
    version: str = "unknown"
    platform: str = "unknown"
    time_limit: int | None = None

    def __post_init__(self) -> None:
        rewards = check_numbers("the rewards of a recording", self.rewards, finite=True)
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "rewards", rewards)
        if self.step_time is not None:
            is_number = isinstance(self.step_time, Real) and self.step_time is not True
            if not is_number or not 0 < self.step_time < math.inf:
                raise ValueError(
                    f"the step_time of a recording must be None or a finite number above 0, got {self.step_time!r:.200}"
                )
            object.__setattr__(self, "step_time", float(self.step_time))
        for name in ("episode_steps", "time_limit"):
            check_count(f"the {name} of a recording", getattr(self, name), or_none=True)
        check_count("the seed of a recording", self.seed, least=0, or_none=True)

    @classmethod
    def of_task(cls, task: Task, **acting: Any) -> "Source":
        """The source for `task`; `acting` are method, seed, version, platform and time_limit."""
        same = (
            "robot",
            "scene",
            "step_time",
            "episode_steps",
            "states",
            "actions",
            "rewards",
        )
        return cls(task.name, **{name: getattr(task, name) for name in same}, **acting)

    @classmethod
    def of_env(
        cls, env: gymnasium.Env[Any, Any], rewards: ArrayLike, **acting: Any
    ) -> "Source":
        """The source for any Gymnasium environment without a task; `rewards` are those that were seen.

        Raises ValueError if its states or actions cannot be counted.
        """
        size = Size.of(env)
        inputs = [
            InputVariable(f"observation_{i}", values=range(n))
            for i, n in enumerate(size.shape)
        ]
        actions = ActionSpace([OutputVariable("action", values=range(size.n_actions))])
        name = env.spec.id if env.spec else type(env.unwrapped).__name__
        seen = tuple(np.unique(rewards).tolist())
        return cls(
            name,
            StateSpace(inputs),
            actions,
            seen,
            episode_steps=size.episode_steps,
            **acting,
        )

    def check_rows(
        self,
        columns: Mapping[str, NDArray[Any]],
        where: Callable[[int], str],
        remedy: str = REMEDY,
    ) -> None:
        """Raises ValueError if a row of `columns`, arrays (n,) by name, cannot be from here: the first one of a column.

        where: what a message calls the row of this number; remedy: what to do, the end of the message
        """
        sizes = {
            "s": self.states.n,
            "a": self.actions.n,
            "s_next": self.states.n,
            "terminated": 2,
            "truncated": 2,
        }
        for name, column in columns.items():
            if name == "r":
                is_possible = np.isin(column, self.rewards)
                expected = f"one of the rewards {list(self.rewards)!s:.200}"
            else:
                # up to 2**53 a float holds every whole number
                size = sizes.get(name, 2**53)
                is_possible = (column == np.floor(column)) & (column >= 0)
                is_possible &= column < size
                to = f"to {size - 1}" if name in sizes else "on"
                expected = f"a whole number from 0 {to}"
            if not is_possible.all():
                row = int(np.argmin(is_possible))
                found = repr(column[row].item()).removesuffix(".0")
                raise ValueError(
                    f"{where(row)}: {name} is {found}, expected {expected}; {remedy}"
                )

    def difference(self, task: Task) -> str:
        """In what `task` is not the one recorded, in words; empty if it is the same."""
        its_facts = Source.of_task(task)._facts()
        differ = first_difference(self._facts(), its_facts, "recording")
        if not differ:
            return ""
        return f"{differ} in the task"

    def _facts(self) -> dict[str, object]:
        """All that must agree with a task, by name, the most telling first."""
        facts: dict[str, object] = {
            "the list of inputs": [v.name for v in self.states.inputs],
            "the list of outputs": [v.name for v in self.actions.outputs],
        }
        for variable in self.states.inputs:
            facts |= _facts_of(variable, variable.name)
        for output in self.actions.outputs:
            facts |= _facts_of(output, f"output {output.name}")
        facts["the set of rewards"] = sorted(set(self.rewards))
        alike = ("robot", "scene", "step_time", "episode_steps")
        return facts | {name: getattr(self, name) for name in alike}


def _facts_of(variable: InputVariable | OutputVariable, name: str) -> dict[str, object]:
    """How a variable is cut, its values and its unit; `name` is how they are called."""
    facts = {}
    for key, value in asdict(variable).items():
        if key != "words":
            facts[f"{key} of {name}"] = value
    return facts
