"""A robot in 3D while it moves, below the cell that runs it."""

import time
from collections import deque
from functools import cached_property
from typing import Any, cast

from rlrobot_edu.learning import loop
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.progress import watched
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.display import Displayed
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.in3d.feed import frame, room
from rlrobot_edu.show.in3d.window import page
from rlrobot_edu.show.scenes import robot_of
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.widgets.carried import CarriedPage

LAST = 100  # steps that a saved notebook keeps of those that were watched
KEPT = 2000  # frames for a page that comes late: as long is the trail


class LiveView(Displayed):
    """A 3D picture that follows a robot in a notebook; the notebook's own connection carries what is new."""

    def __init__(self) -> None:
        self.count = 0  # of frames so far
        self.closed = False
        self._room: dict[str, Any] = {}
        self._room_since = 0  # how many frames there had been in other rooms
        self._steps = 0  # that paid something in this room; a start is none
        self._frames: deque[dict[str, Any]] = deque(maxlen=KEPT)

    def update(self, scene: Scene, reward: float | None = None, seconds: float = 0.0) -> None:
        """Show a scene.

        scene: what there is to see now
        reward: of the step that led here, which colours the trail; without one, this is not counted as a step
        seconds: for how long the picture moves on from the scene before to this one

        Raises RuntimeError after `close`.
        """
        if self.closed:
            raise RuntimeError("this live view is closed; make a new one")
        if room(scene) != self._room:
            self._room, self._room_since, self._steps = room(scene), self.count, 0
            self._frames.clear()
        self.count += 1
        self._steps += reward is not None
        self._frames.append({**frame(scene, reward), "seconds": seconds, "step": self._steps})
        self._carry()

    def follow(self, agent: Agent, env: Env, steps: int, speed: float) -> Film:
        """Let an agent learn and show each of its steps, see `rlrobot_edu.watch`; returns the last ones."""
        if not speed > 0:
            raise ValueError(f"speed must be above 0: 1 is as fast as in reality, 100 a hundred times; got {speed}")
        loop.check_pair_of(agent, env)
        check_count("steps", steps)
        robot, seen = robot_of(env), deque[tuple[Scene, float]](maxlen=LAST)
        seconds, due = cast(RobotEnv, env.unwrapped).task.step_time / speed, time.monotonic()
        for step in loop.steps(agent, env, steps):
            seen.append((robot.scene(), step.r))
            self.update(*seen[-1], seconds)
            due = max(due + seconds, time.monotonic())
            time.sleep(max(0.0, due - time.monotonic()) if watched() else 0.0)
        self._carry(at_once=True)
        return Film([scene for scene, _ in seen], [reward for _, reward in seen])

    def so_far(self, seen: int) -> dict[str, Any]:
        """What a page lacks that has `seen` so many frames."""
        frames = list(self._frames)[-(self.count - seen) :] if self.count > seen else []
        new_room = self._room if seen <= self._room_since else None
        return {"count": self.count, "room": new_room, "frames": frames, "closed": self.closed}

    def close(self) -> None:
        """Let pages that are open say that the view has ended."""
        self.closed = True
        self._carry(at_once=True)

    def _carry(self, *, at_once: bool = False) -> None:
        if "widget" in vars(self):
            self.widget.tell(at_once=at_once)

    def __repr__(self) -> str:
        return "<Live 3D view of a robot, where a kernel runs>"

    @cached_property
    def widget(self) -> CarriedPage:
        """The view in a frame."""
        return CarriedPage(page("Live 3D view", {"live": "carried"}), self.so_far)
