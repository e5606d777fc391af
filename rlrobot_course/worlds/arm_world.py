"""The toolkit's kinematic arm as a table, with the learner's own formula for the gripper, if there is one.

As the speeds of a task are few, so are the positions that the arm can get to: all of them are reckoned once, and a step
is a look into a table.
"""

import dataclasses
from collections.abc import Callable
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from rlrobot_edu import Task, load_task
from rlrobot_edu.robots.arm.arm_body import (
    HOME,
    OBJECT_PLACE,
    Angles,
    scene_of,
    solids_of,
)
from rlrobot_edu.robots.arm.kinematic_arm import gripper as the_gripper
from rlrobot_edu.robots.arm.kinematic_arm import turned
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.rewards import gripper_to_object
from rlrobot_edu.task.robot_cards import ROBOTS

Gripper = Callable[[float, float, float], tuple[float, float, float]]


class Places(NamedTuple):
    """All that the arm of a task can get to from its start, which is place 0.

    angles: of the joints at each place; readings: of its sensors there; next: array (places, actions), the place after
    an action; distance: array (places,), of the gripper to the object [m]
    """

    angles: list[Angles]
    readings: list[dict[str, float]]
    next: np.ndarray
    distance: np.ndarray


def places_of(task: Task, gripper: Gripper = the_gripper) -> Places:
    """Every place, found from the start by every action. gripper: the function of lesson 13's exercise."""
    commands = task.commands
    numbers, angles, after = {HOME: 0}, [HOME], []
    for here in angles:  # grows meanwhile
        row = [turned(here, command, task.step_time) for command in commands]
        for there in row:
            if there not in numbers:
                numbers[there] = len(angles)
                angles.append(there)
        after.append([numbers[there] for there in row])
    readings = [
        dict(
            zip(
                ROBOTS["arm"].sensors,
                map(float, (*gripper(*here), *OBJECT_PLACE, *here)),
                strict=True,
            )
        )
        for here in angles
    ]
    return Places(
        angles,
        readings,
        np.array(after),
        np.array([gripper_to_object(r) for r in readings]),
    )


class StandingArm:
    """The arm at one of its places, as a robot that can be looked at."""

    def __init__(self, angles: Angles, readings: dict[str, float]) -> None:
        self.angles, self.readings = angles, readings

    def scene(self) -> Scene:
        """What there is to see."""
        return scene_of(solids_of(self.angles))


class ArmWorld(gymnasium.Env[np.ndarray, int]):
    """A task of the arm as a Gymnasium environment, without PyBullet.

    task: ``arm_1k``, or one like it with another reward; gripper: the function of lesson 13's exercise
    places, rewards: where the arm can be, and array (places, actions), what each step from there pays
    """

    def __init__(
        self, task: Task | str = "arm_1k", gripper: Gripper = the_gripper
    ) -> None:
        self.task = load_task(task)
        self.places = places_of(self.task, gripper)
        seen = self.places.readings
        self.rewards = np.array(
            [
                [self.task.reward_for(seen[i], seen[j]) for j in row]
                for i, row in enumerate(self.places.next)
            ]
        )
        self.r_max, self.episode_steps = max(self.task.rewards), self.task.episode_steps
        self._states = [self.task.states.encode(r) for r in seen]
        self._observations = [np.array(self.task.states.bins(s)) for s in self._states]
        self.observation_space = gymnasium.spaces.MultiDiscrete(
            list(self.task.states.shape)
        )
        self.action_space = gymnasium.spaces.Discrete(self.task.actions.n)
        self.place = self._t = 0

    @property
    def state(self) -> int:
        """Number of the state."""
        return self._states[self.place]

    @property
    def robot(self) -> StandingArm:
        """The arm where it is now."""
        return StandingArm(
            self.places.angles[self.place], self.places.readings[self.place]
        )

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict]:
        """Put the arm at its start; returns observation and info."""
        super().reset(seed=seed)
        self.place = self._t = 0
        return self._seen()

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict]:
        """Do an action: returns observation, reward, terminated, truncated and info."""
        before, self.place, self._t = (
            self.place,
            int(self.places.next[self.place, action]),
            self._t + 1,
        )
        observation, info = self._seen()
        return (
            observation,
            float(self.rewards[before, action]),
            False,
            self._t == self.episode_steps,
            info,
        )

    def _seen(self) -> tuple[np.ndarray, dict]:
        info = {"state": self.state, "readings": self.places.readings[self.place]}
        return self._observations[self.place].copy(), info


def with_reward(task: Task, reward: Callable[[float, float], float], name: str) -> Task:
    """The task with another reward, a function of the distances before and after a step [m].

    The values that it takes are gathered from all steps that the arm can make.
    """

    def of_readings(before: dict[str, float], after: dict[str, float]) -> float:
        return float(reward(gripper_to_object(before), gripper_to_object(after)))

    places = places_of(task)
    seen, after = places.readings, places.next
    values = {of_readings(seen[i], seen[j]) for i, row in enumerate(after) for j in row}
    return dataclasses.replace(
        task, reward=of_readings, rewards=sorted(values), name=name
    )
