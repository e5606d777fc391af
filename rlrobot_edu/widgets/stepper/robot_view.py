"""A robot and its scene from above, for the page to draw and on matplotlib axes for the still picture."""

from __future__ import annotations

import math
from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.describe import loss_of, path_of
from rlrobot_edu.show.palette import GREY
from rlrobot_edu.show.picture import plain
from rlrobot_edu.show.room.scene_data import (
    constant_data,
    moving_data,
    near_of,
)
from rlrobot_edu.show.top_down import TopDown
from rlrobot_edu.widgets.stepper.cell_values import ASIDE, CellValues, Mark
from rlrobot_edu.widgets.stepper.colours import scale_limit, tint
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import before_it, short, told_apart
from rlrobot_edu.widgets.stepper.tape import PATH, Frame, Tape

WIDE, HIGH = 0.26, 0.19  # of a mark [m]; two lines of small letters fit into it
# of a mark in the still from the middle of its cell [m], across and upwards: beside the robot, not on it
OUT = (0.44, 0.405)


class RobotView:
    """Pictures of what `robot` does; the walls are drawn once.

    marks: the values of places in the scene, if they can be drawn there
    names: the words of the task, and the task itself, which says what is near and what is lost
    """

    def __init__(self, robot: Any, marks: CellValues | None, names: Names) -> None:
        self.heading = "The world from above"
        if marks is not None:
            self.heading = "From above: at each edge the best action, and its value"
        self._robot = robot
        self._marks = marks
        self._names = names
        self._walls: tuple[Solid, ...] = ()

    def look(self, s: int) -> Scene:
        """The scene without its walls, which do not move."""
        scene = self._robot.scene()
        if not self._walls:
            self._walls = tuple(solid for solid in scene.solids if solid.role == "wall")
            self._constant = constant_data(scene)
        others = tuple(solid for solid in scene.solids if solid.role != "wall")
        return scene._replace(solids=others)

    def constant_data(self) -> dict[str, Any]:
        """What stays in the scenes; and, if there are marks, their places for each cell of the box."""
        near, loss = None, None
        task = self._names.task
        if task is not None:
            near = near_of(task)
            loss = loss_of(task.rewards or ())
        return {
            "kind": "robot",
            "scene": self._constant,
            "near": near,
            "loss": loss,
            "marks": None if self._marks is None else self._marks.constant_data(),
        }

    def look_data(self, look: Scene) -> dict[str, Any]:
        """What may move, as room.js wants it, and the cell of the box."""
        data = {**moving_data(look), "box": None}
        for solid in look.solids:
            if solid.name == "box":
                corner = solid.pose[:2, 3] + 0.5
                data["box"] = [round(x) for x in corner.tolist()]
        return data

    def draw(self, ax: Axes, tape: Tape) -> None:
        """The last scene and the path to it, on matplotlib's axes without numbers, which leaves room for the marks."""
        looks = tape.looks()
        scene = looks[-1]._replace(solids=self._walls + looks[-1].solids)
        view = TopDown(ax, scene)
        view.update(scene, path_of(looks))
        marks = [] if self._marks is None else self._marks.of(tape, scene)
        starts_earlier = len(looks) >= PATH
        if marks or starts_earlier:
            view.words["start"].set_text("")
        if marks:
            between_cells = {
                "color": GREY,
                "linewidth": 0.8,
                "alpha": 0.5,
                "zorder": 0.5,
            }
            ax.plot([0, 0], [-1, 1], **between_cells)
            ax.plot([-1, 1], [0, 0], **between_cells)
        most = scale_limit(tape.q, tape.agent.parameters.r_max)
        for mark in marks:
            _draw_mark(ax, mark, most)
        if tape.frame is not None and not any(mark.is_its for mark in marks):
            self._draw_change(ax, tape.frame)

    def _draw_change(self, ax: Axes, frame: Frame) -> None:
        """In a corner of the room, what the step has changed."""
        was, now = told_apart(frame.q_sa, frame.q_sa_new)
        change = f"stays {now}" if was == now else f"{was} → {now}"
        text = f"{self._names.quoted(frame.step.a)} here:\n{change}"
        box = {"facecolor": "white", "edgecolor": "black", "boxstyle": "round"}
        corner = {"transform": ax.transAxes, "va": "top", "zorder": 22, "bbox": box}
        ax.text(0.03, 0.97, plain(text), fontsize=9.6, **corner)


def _draw_mark(ax: Axes, mark: Mark, most: float) -> None:
    """A value and its best actions, on white and the value's colour; what the step has changed is framed."""
    colour, opacity = tint(mark.value, most)
    lines = [mark.icons, short(mark.value)]
    if mark.was is not None:
        lines.insert(1, before_it(mark.was, mark.value))
    high = HIGH * len(lines) / 2
    aside = OUT[1] + (high - HIGH) / 2  # a higher mark grows away from the robot
    x, y = _pushed_out(mark.x, OUT[0]), _pushed_out(mark.y, aside)
    corner = (x - WIDE / 2, y - high / 2)
    for ink, alpha in (("white", 1), (colour, opacity)):
        box = Rectangle(corner, WIDE, high, color=ink, alpha=alpha, linewidth=0)
        box.set_zorder(20)
        ax.add_patch(box)
    if mark.is_its:
        frame = Rectangle(corner, WIDE, high, fill=False, linewidth=2.2)
        frame.set_zorder(20.5)
        ax.add_patch(frame)
    size = 9.6 if len(lines) == 2 else 8.6
    letters = ax.text(x, y, "\n".join(lines), ha="center", va="center", fontsize=size)
    letters.set(linespacing=0.9, zorder=21)


def _pushed_out(at: float, out: float) -> float:
    """A coordinate of a mark [m], so far from the middle of its cell if it is not in the middle."""
    middle = math.floor(at) + 0.5
    return middle + (at - middle) * out / ASIDE
