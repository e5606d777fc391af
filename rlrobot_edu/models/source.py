"""Where the transitions of a recording come from: which states and actions, which robot, which method."""

import math
import platform
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
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
        check_numbers("the rewards of a recording", self.rewards, finite=True)
        if self.step_time is not None and not 0 < self.step_time < math.inf:
            raise ValueError(
                f"the step_time of a recording must be None or above 0, got {self.step_time}"
            )
        for name in ("episode_steps", "time_limit"):
            check_count(f"the {name} of a recording", getattr(self, name), or_none=True)

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
        """Raises ValueError for the first row of `columns`, arrays (n,) by name, that cannot be from here.

        where: what a message calls the row of this number
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
                good = np.isin(column, self.rewards)
                expected = f"one of the rewards {list(self.rewards)!s:.200}"
            else:
                # up to 2**53 a float holds every whole number
                size = sizes.get(name, 2**53)
                good = (column == np.floor(column)) & (column >= 0) & (column < size)
                to = f"to {size - 1}" if name in sizes else "on"
                expected = f"a whole number from 0 {to}"
            if not good.all():
                row = int(np.argmin(good))
                found = repr(column[row].item()).removesuffix(".0")
                raise ValueError(
                    f"{where(row)}: {name} is {found}, expected {expected}; {remedy}"
                )

    def difference(self, task: Task) -> str:
        """In what `task` is not the one recorded, in words; empty if it is the same."""
        differ = first_difference(
            self._facts(), Source.of_task(task)._facts(), "recording"
        )
        return differ and f"{differ} in the task"

    def _facts(self) -> dict[str, object]:
        """All that must agree with a task, by name, the most telling first."""
        facts: dict[str, object] = {
            "the list of inputs": [v.name for v in self.states.inputs],
            "the list of outputs": [v.name for v in self.actions.outputs],
        }
        variables: list[InputVariable | OutputVariable] = [
            *self.states.inputs,
            *self.actions.outputs,
        ]
        for v in variables:
            facts |= {
                f"{key} of {v.name}": value
                for key, value in asdict(v).items()
                if key != "words"
            }
        facts["the set of rewards"] = sorted(set(self.rewards))
        alike = ("robot", "scene", "step_time", "episode_steps")
        return facts | {name: getattr(self, name) for name in alike}
