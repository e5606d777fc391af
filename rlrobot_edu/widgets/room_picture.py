"""The room from above in a notebook; its program draws it anew whenever it is shown something."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rlrobot_edu.jupyter import anywidget, traitlets
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import describe, loss_of
from rlrobot_edu.show.room.scene_data import (
    near_of,
    room_script,
    scene_data,
)
from rlrobot_edu.show.room.tokens import look
from rlrobot_edu.task.task import Task

_SHOW = """
export default {
  render({ model, el }) {
    const box = el.appendChild(document.createElement("div"));
    const canvas = box.appendChild(document.createElement("canvas"));
    box.className = "rl-look rl-room-picture";
    canvas.setAttribute("role", "img");
    const show = () => {
      const { scene, says, ...options } = model.get("shown"), [xMin, yMin, xMax, yMax] = scene.bounds;
      if (!canvas.clientWidth) return;
      canvas.style.height = `${Math.round((canvas.clientWidth * (yMax - yMin)) / (xMax - xMin)) + ROOM_BAR}px`;
      canvas.setAttribute("aria-label", says);
      drawRoom(canvas, scene, options);
    };
    model.on("change:shown", show);
    new ResizeObserver(show).observe(box);
    followColours(show);
    show();
  },
};
"""
_STYLE = """
.rl-room-picture { width: 440px; max-width: 100%; padding: 8px; border-radius: var(--round) }
"""


class RoomPicture(anywidget.AnyWidget):
    """The room of a task's robot, seen from above.

    shown: the scene, the way to it and what the bar below it tells
    """

    shown = traitlets.Dict().tag(sync=True)

    def __init__(self, task: Task) -> None:
        self._esm = room_script() + _SHOW
        self._css = look() + _STYLE
        self._near = near_of(task)
        self._loss = loss_of(task.rewards or ())
        super().__init__()

    def show(self, way: Sequence[tuple[Scene, float | None]], bar: Any) -> None:
        """Show the last scene of a way; each has the reward of the step to it, None where the robot was put.

        bar: of room.js: step, reward and sum; None for no bar
        """
        scene, _ = way[-1]
        trail = []
        for each, reward in way:
            place = scene_data(each)["place"]
            if place is not None:
                trail.append([*place[:2], reward])
        self.shown = {
            "scene": scene_data(scene),
            "says": describe(scene),
            "trail": trail,
            "near": self._near,
            "loss": self._loss,
            "bar": bar,
        }
