"""Worlds in which a learner's function drives a robot that is filmed."""

from collections.abc import Callable

import numpy as np

from rlrobot_course.drives.by_your_code import Enough, Reel
from rlrobot_course.worlds.short_world import ShortWorld
from rlrobot_course.worlds.tapes import with_action
from rlrobot_edu.environments import make_env
from rlrobot_edu.robots.realism import Realism

TOO_FAR = "Your loop goes on after its {} steps; here it was stopped there."


class FilmedWorld(ShortWorld):
    """A task's robot behind the short interface of the course, filmed, for so many steps.

    task: its name; seed: of all that is random; reel: takes the film; most: the steps that it takes
    held: whether walls hold the robot, and it obeys late
    """

    def __init__(
        self, task: str, seed: int, reel: Reel, most: int, held: bool = False
    ) -> None:
        how = {"realism": Realism.vrep()} if held else {}
        super().__init__(make_env(task, seed=seed, **how), seed)
        self.reel, self.most = reel, most

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`. Raises Enough where a loop goes on after the last step."""
        if self.age >= self.most:
            self.reel.note = TOO_FAR.format(self.most)
            raise Enough
        s_next, r, terminated, truncated = super().step(a)
        self.reel.take(self.env.unwrapped.robot.scene(), r)  # type: ignore[attr-defined]
        return s_next, r, terminated, truncated


def drive_by_table(q: np.ndarray, task: str, seed: int, reel: Reel, steps: int) -> None:
    """Drive for some steps, always by the best action."""
    world = FilmedWorld(task, seed, reel, steps)
    s = world.reset()
    for _ in range(steps):
        s, _, _, truncated = world.step(int(q[s].argmax()))
        if truncated:
            s = world.reset()


def run(
    world: FilmedWorld,
    choose: Callable[[int], int],
    update: Callable[[int, int, float, int, bool], object],
) -> None:
    """Learn from all the steps that a world takes."""
    s = world.reset()
    for _ in range(world.most):
        a = choose(s)
        s_next, r, terminated, truncated = world.step(a)
        update(s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = world.reset()
