"""A robot and its scene from above, for the page to draw and on matplotlib axes for the still picture."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.describe import path_of
from rlrobot_edu.show.palette import GREY, ROLE
from rlrobot_edu.show.top_down import TopDown, footprint, nose
from rlrobot_edu.widgets.stepper.cell_values import CellValues
from rlrobot_edu.widgets.stepper.colours import largest, tint
from rlrobot_edu.widgets.stepper.numerals import short
from rlrobot_edu.widgets.stepper.tape import PATH, Tape

WIDE, HIGH = 0.36, 0.25  # of a mark [m]; two lines of small letters fit into it
SHORT = 0.6  # of the line that says where the robot looks: among marks it ends before the one ahead
_ORDER = ("goal", "object", "robot", "wheel")  # from below to the top


class RobotView:
    """Pictures of what `robot` does; the walls are drawn once.

    marks: what the agent thinks of places in the scene, if it can be drawn there
    """

    def __init__(self, robot: Any, marks: CellValues | None) -> None:
        self.heading = (
            "From above, and the value of each heading"
            if marks
            else "The world from above"
        )
        self._robot, self._marks = robot, marks
        self._walls: tuple[Solid, ...] = ()

    def look(self, s: int) -> Scene:
        """The scene without its walls, which do not move."""
        scene = self._robot.scene()
        if not self._walls:
            self._walls = tuple(solid for solid in scene.solids if solid.role == "wall")
            self._bounds = scene.bounds
        return scene._replace(
            solids=tuple(solid for solid in scene.solids if solid.role != "wall")
        )

    def constant_data(self) -> dict[str, Any]:
        """Walls, bounds and colours; and, where there are marks, for each cell of the box the places that have one."""
        walls = [_points(footprint(solid)) for solid in self._walls]
        return {"kind": "robot", "bounds": self._bounds, "roles": ROLE, "walls": walls,
                "marks": self._marks and self._marks.constant_data()}  # fmt: skip

    def look_data(self, look: Scene) -> dict[str, Any]:
        """Where everything is that may move [m], the robot's x, y and heading [rad], and its nose."""
        solids = sorted(look.solids, key=lambda solid: _ORDER.index(solid.role))
        body = next(
            (solid for solid in look.solids if solid.name == "robot/body"), None
        )
        box = next(
            (solid.pose[:2, 3] + 0.5 for solid in look.solids if solid.name == "box"),
            None,
        )
        return {
            "moving": [[solid.role, _points(footprint(solid))] for solid in solids],
            "beams": np.round(look.beams[:, :, :2].reshape(-1, 4), 3).tolist(),
            "place": body
            and [
                *body.pose[:2, 3].tolist(),
                math.atan2(body.pose[1, 0], body.pose[0, 0]),
            ],
            "nose": body and nose(body)[1].tolist(),
            "box": None if box is None else [round(x) for x in box.tolist()],
        }

    def draw(self, ax: Axes, tape: Tape) -> None:
        """The last scene and the path to it on matplotlib's axes; their numbers would take the room of the marks."""
        looks, most = tape.looks(), largest(tape.q, tape.agent.parameters.r_max)
        scene = looks[-1]._replace(solids=self._walls + looks[-1].solids)
        view = TopDown(ax, scene)
        view.update(scene, path_of(looks))
        marks = self._marks.of(tape, scene) if self._marks else []
        if (
            marks or len(looks) >= PATH
        ):  # there is no room, or the trail no longer reaches back to the start
            view.words["start"].set_text("")
        ax.set_axis_off()
        if marks:
            for draw_line in (ax.axvline, ax.axhline):  # between the cells
                draw_line(0, color=GREY, linewidth=0.8, alpha=0.5, zorder=0)
            ahead = view.heading.get_xydata()
            view.heading.set_data(*(ahead[0] + SHORT * (ahead - ahead[0])).T)
        for mark in marks:
            colour, opacity = tint(mark.value, most)
            for ink, alpha in (("white", 1), (colour, opacity)):
                corner = mark.x - WIDE / 2, mark.y - HIGH / 2
                ax.add_patch(
                    Rectangle(
                        corner,
                        WIDE,
                        HIGH,
                        color=ink,
                        alpha=alpha,
                        linewidth=0,
                        zorder=20,
                    )
                )
            ax.text(mark.x, mark.y, f"{mark.icons}\n{short(mark.value)}", ha="center", va="center", fontsize=8.5,
                    linespacing=0.9, zorder=21)  # fmt: skip


def _points(xy: np.ndarray) -> list[list[float]]:
    return np.round(xy, 3).tolist()
